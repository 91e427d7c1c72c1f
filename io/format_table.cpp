#include "io/format_table.h"

#include <algorithm>

#include "core/text.h"
#include "io/file.h"
#include "io/formats/geojson.h"
#include "io/formats/procthor.h"
#include "io/formats/scene_json.h"
#include "io/formats/wkt.h"

namespace inhabit::io {
namespace {

/// How much of a file its first keys are looked for in.
constexpr std::size_t kHead = 4096;

std::string_view trimmed(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ? std::string_view{} : bytes.substr(start);
}
bool json_with(std::string_view bytes, std::initializer_list<std::string_view> words) {
  const std::string_view head = trimmed(bytes).substr(0, kHead);
  return head.starts_with('{') &&
         std::ranges::any_of(words, [&](std::string_view word) { return head.find(word) != std::string_view::npos; });
}

bool is_scene(std::string_view bytes) { return json_with(bytes, {"\"inhabit-scene\"", "\"space\""}); }
bool is_wkt(std::string_view bytes) {
  const std::string_view head = trimmed(bytes);
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION", "SRID="},
      [&](std::string_view word) { return head.starts_with(word); });
}
bool is_geojson(std::string_view bytes) {
  return json_with(bytes, {"\"FeatureCollection\"", "\"coordinates\"", "\"geometries\"", "\"Feature\""});
}
bool is_procthor(std::string_view bytes) {
  return json_with(bytes, {"\"floorPolygon\"", "\"proceduralParameters\"", "\"roomType\""});
}

bool is_home(std::string_view bytes) {
  const std::string_view head = trimmed(bytes).substr(0, kHead);
  return bytes.starts_with("PK\x03\x04") || (head.starts_with('<') && head.find("<home") != std::string_view::npos);
}

Result<Content> content(Result<std::vector<scene::Scene>> scenes) {
  if (!scenes) return scenes.error();
  return Content{*std::move(scenes), {}, {}};
}
Result<Content> read_scene_file(std::string_view bytes, const ReadOptions&) {
  Result<scene::Scene> scene = read_scene(bytes);
  if (!scene) return scene.error();
  Content content;
  content.scenes.push_back(*std::move(scene));
  return content;
}
Result<std::string> write_scene_file(const Content& content) { return write_scene(content.scenes.front()); }

Result<Content> read_home_file(std::string_view bytes, const ReadOptions&) {
  Result<Sh3dHome> home = open_sh3d(std::string(bytes));
  if (!home) return home.error();
  Result<Sh3dRooms> rooms = read_rooms(*home);
  if (!rooms) return rooms.error();
  if (rooms->scenes.empty()) return invalid("", "the home has no rooms");
  Content content{std::move(rooms->scenes), *std::move(home), std::move(rooms->warnings)};
  for (const std::string& piece : rooms->outside) content.warnings.push_back("in no room: " + piece);
  return content;
}
Result<std::string> write_home_file(const Content& content) {
  Result<Sh3dFile> file =
      content.home ? write_sh3d(*content.home, content.scenes) : write_sh3d_new(content.scenes.front());
  if (!file) return file.error();
  return std::move(file->bytes);
}

Result<Content> read_procthor_file(std::string_view bytes, const ReadOptions& options) {
  if (options.asset_database.empty())
    return invalid("", "a ProcTHOR house needs the asset database with the sizes of its pieces");
  const Result<std::string> database = read_file(options.asset_database);
  if (!database) return database.error();
  const Result<Assets> assets = read_procthor_assets(*database);
  if (!assets) return invalid(options.asset_database.string() + assets.error().where, assets.error().message);
  return content(read_procthor(bytes, *assets, options.line));
}

// One line per format; the first whose sniffing agrees reads a file.
constexpr Format kFormats[] = {
    {"scene", "json", is_scene, read_scene_file, write_scene_file, false, "inhabit's own scene document"},
    {"sweethome3d", "sh3d xml", is_home, read_home_file, write_home_file, true,
     "homes of Sweet Home 3D, one scene per room"},
    {"wkt", "wkt", is_wkt, [](std::string_view b, const ReadOptions&) { return content(read_wkt(b)); }, nullptr, false,
     "walkable areas as well-known text (JuPedSim)"},
    {"geojson", "geojson", is_geojson, [](std::string_view b, const ReadOptions&) { return content(read_geojson(b)); },
     nullptr, false, "floor plans and WRLD indoor maps"},
    {"procthor", "json jsonl", is_procthor, read_procthor_file, nullptr, false,
     "ProcTHOR / AI2-THOR houses, one or one per line", true},
};

bool has_extension(const Format& format, std::string_view extension) {
  for (std::string_view rest = format.extensions; !rest.empty();) {
    const std::size_t space = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, space) == extension) return true;
    rest.remove_prefix(std::min(space + 1, rest.size()));
  }
  return false;
}
/// An option without a meaning would be ignored, and the whole file taken for the part that was asked for.
Status options_fit(const Format& format, const ReadOptions& options) {
  if (format.houses || (options.asset_database.empty() && options.line == 0)) return Done{};
  return invalid("", (options.line != 0 ? "--line" : "--assets") +
                         std::string(" is for ProcTHOR houses, and this is another format: ") +
                         std::string(format.name));
}
std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* format_to_write(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  const auto found = std::ranges::find_if(kFormats, [&](const Format& f) {
    return f.write != nullptr && f.extensions.substr(0, f.extensions.find(' ')) == extension;
  });
  return found == std::end(kFormats) ? nullptr : found;
}

Result<Content> read_any_bytes(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  if (is_gzip(bytes)) {
    const Result<std::string> unpacked = gunzip(bytes);
    if (!unpacked) return unpacked.error();
    if (is_gzip(*unpacked)) return invalid("", "gzip within gzip");
    return read_any_bytes(*unpacked, name.ends_with(".gz") ? name.substr(0, name.size() - 3) : name, options);
  }
  auto format = std::ranges::find_if(kFormats, [&](const Format& f) { return f.sniff(bytes); });
  const std::string extension = extension_of(name);
  if (format == std::end(kFormats))
    format = std::ranges::find_if(kFormats, [&](const Format& f) { return has_extension(f, extension); });
  if (format != std::end(kFormats)) {
    if (const Status fit = options_fit(*format, options); !fit) return fit.error();
    return format->read(bytes, options);
  }
  std::string known;
  for (const Format& f : kFormats) known += (known.empty() ? "" : ", ") + std::string(f.name);
  return Error{ErrorCode::unsupported, "none of the known formats: " + known, ""};
}

Result<Content> read_any(const std::filesystem::path& path, const ReadOptions& options) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return bytes.error();
  Result<Content> content = read_any_bytes(*bytes, path.filename().string(), options);
  if (content) return content;
  Error error = content.error();
  error.where = path.string() + (error.where.empty() ? "" : ": ") + error.where;
  return error;
}

}  // namespace inhabit::io
