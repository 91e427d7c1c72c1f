#include "session/document.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/text.h"
#include "io/file.h"
#include "io/format_table.h"

namespace inhabit::session {
namespace {

bool has_extension(std::string_view name, std::string_view extension) {
  if (name.size() < extension.size()) return false;
  return std::equal(extension.rbegin(), extension.rend(), name.rbegin(),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + ('a' - 'A') : b); });
}

const BuiltinScene* find_builtin(std::string_view name) {
  for (const BuiltinScene& scene : builtin_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

Result<Document> read_home(std::string bytes) {
  Result<io::Sh3dHome> home = io::open_sh3d(std::move(bytes));
  if (!home) return home.error();
  Result<io::Sh3dRooms> rooms = io::read_rooms(*home);
  if (!rooms) return rooms.error();
  Document document;
  document.scenes = std::move(rooms->scenes);
  document.home = std::move(*home);
  document.warnings = std::move(rooms->warnings);
  for (const std::string& piece : rooms->outside) document.warnings.push_back("in no room: " + piece);
  if (document.scenes.empty()) return invalid("", "the home has no rooms");
  return document;
}

bool is_home(std::string_view file_name) {
  return has_extension(file_name, ".sh3d") || has_extension(file_name, ".xml");
}

/// Rooms are chosen by name, so a name stands for one room: "Bedroom", "Bedroom (2)"; one without is "room 3".
void name_rooms_apart(std::vector<Scene>& scenes) {
  if (scenes.size() < 2) return;
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::string& name = scenes[i].name;
    if (name.empty()) name.append("room ").append(std::to_string(i + 1));
    const int count = ++seen[name];
    if (count > 1) name.append(" (").append(std::to_string(count)).append(")");
  }
}

}  // namespace

Result<Document> read_document(std::string_view file_name, std::string bytes, const OpenOptions& options) {
  Document document;
  if (is_home(file_name)) {
    Result<Document> home = read_home(std::move(bytes));
    if (!home) return home.error();
    document = std::move(*home);
  } else {
    io::ReadOptions read;
    read.asset_database = options.asset_database;
    read.line = options.line;
    Result<io::Scenes> scenes = io::read_any_bytes(bytes, file_name, read);
    if (!scenes) return scenes.error();
    document.scenes = std::move(*scenes);
    if (document.scenes.empty()) return invalid("", "there is no room in it");
  }
  document.name = file_name;
  name_rooms_apart(document.scenes);
  return document;
}

Result<Document> open_document(const std::string& name, const OpenOptions& options) {
  std::error_code missing;
  if (std::filesystem::exists(name, missing)) {
    Result<std::string> bytes = io::read_file(name);
    if (!bytes) return bytes.error();
    return read_document(name, std::move(*bytes), options);
  }
  if (const BuiltinScene* builtin = find_builtin(name)) return read_document(name, std::string(builtin->json), options);
  std::vector<std::string_view> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  return Error{ErrorCode::not_found, "no such file, and no built-in scene of this name" + did_you_mean(name, names),
               ""};
}

Result<std::string> write_document(const Document& document, std::string_view file_name) {
  if (is_home(file_name)) {
    if (!has_extension(file_name, ".sh3d"))
      return Error{ErrorCode::unsupported, "homes are written as .sh3d, not as Home.xml", ""};
    if (!document.home && document.scenes.size() > 1)
      return invalid("", "only rooms that come from one home can be written into one; choose one with --room");
    Result<io::Sh3dFile> file =
        document.home ? io::write_sh3d(*document.home, document.scenes) : io::write_sh3d_new(document.scenes.front());
    if (!file) return file.error();
    return std::move(file->bytes);
  }
  const io::Format* format = io::format_to_write(std::filesystem::path(file_name));
  if (!format) {
    std::string known = "this extension is none that is written; these are: .sh3d";
    for (const io::Format& f : io::formats())
      if (f.write) known += ", ." + std::string(f.extensions.substr(0, f.extensions.find(' ')));
    return Error{ErrorCode::unsupported, known, ""};
  }
  if (document.scenes.size() != 1) {
    std::string names;
    for (const Scene& scene : document.scenes) names += (names.empty() ? "" : ", ") + scene.name;
    return invalid("", "this format holds one room; choose one with --room: " + names);
  }
  return format->write(document.scenes.front());
}

Status save_file(const std::string& path, std::string_view bytes) { return io::write_file_atomically(path, bytes); }

Result<Document> only_rooms(Document document, std::span<const std::string> names) {
  if (names.empty()) return document;
  std::vector<std::string_view> known;
  for (const Scene& scene : document.scenes) known.push_back(scene.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string list;
      for (const std::string_view other : known) {
        list += list.empty() ? "; it has " : ", ";
        list += other;
      }
      return Error{ErrorCode::not_found, "no room called " + name + list, ""};
    }
  std::erase_if(document.scenes,
                [&](const Scene& scene) { return std::find(names.begin(), names.end(), scene.name) == names.end(); });
  return document;
}

}  // namespace inhabit::session
