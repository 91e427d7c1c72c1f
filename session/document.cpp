#include "session/document.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/text.h"
#include "io/file.h"
#include "io/format_table.h"

namespace inhabit::session {
namespace {

const BuiltinScene* find_builtin(std::string_view name) {
  for (const BuiltinScene& scene : builtin_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

/// The built-in scenes called NAME-1, NAME-2, …: one document, a scene each; nothing when there are none.
Result<Document> open_builtin_set(const std::string& name) {
  Document set;
  set.name = name;
  for (int k = 1;; ++k) {
    const BuiltinScene* builtin = find_builtin(name + "-" + std::to_string(k));
    if (!builtin) return set;
    Result<Document> one = read_document(builtin->name, std::string(builtin->json));
    if (!one) return one.error();
    set.scenes.push_back(std::move(one->scenes.front()));
  }
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

/// For messages, which are one line: the first dozen.
std::string room_names(std::span<const Scene> scenes) {
  constexpr std::size_t kMost = 12;
  std::string names;
  for (const Scene& scene : scenes.first(std::min(scenes.size(), kMost)))
    names.append(names.empty() ? "" : ", ").append(scene.name);
  if (scenes.size() > kMost) names.append(" and ").append(std::to_string(scenes.size() - kMost)).append(" more");
  return names;
}

}  // namespace

Result<Document> read_document(std::string_view file_name, std::string bytes, const OpenOptions& options) {
  io::ReadOptions read;
  read.asset_database = options.asset_database;
  read.line = options.line;
  Result<io::Content> content = io::read_any_bytes(bytes, file_name, read);
  if (!content) return content.error();
  Document document{*std::move(content), std::string(file_name)};
  if (document.scenes.empty()) return invalid("", "there is no room in it");
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
  Result<Document> set = name.starts_with("exemplar/") ? open_builtin_set(name) : Document{};
  if (!set || !set->scenes.empty()) return set;
  std::vector<std::string_view> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  return Error{ErrorCode::not_found, "no such file, and no built-in scene of this name" + did_you_mean(name, names),
               ""};
}

Result<std::string> write_document(const Document& document, std::string_view file_name) {
  const io::Format* format = io::format_to_write(std::filesystem::path(file_name));
  if (!format) {
    std::string known;
    for (const io::Format& f : io::formats())
      if (f.write) known += (known.empty() ? "." : ", .") + std::string(f.extensions.substr(0, f.extensions.find(' ')));
    return Error{ErrorCode::unsupported, "no format that is written has this extension; these have: " + known, ""};
  }
  if (document.scenes.size() == 1 || (format->homes && document.home)) return format->write(document);
  return invalid("", "a file of this format holds one room, and there are " + std::to_string(document.scenes.size()) +
                         "; choose one with --room: " + room_names(document.scenes));
}

Status can_save(const std::string& path) { return io::can_write(path); }
Status save_file(const std::string& path, std::string_view bytes) { return io::write_file_atomically(path, bytes); }

Result<Document> only_rooms(Document document, std::span<const std::string> names) {
  if (names.empty()) return document;
  std::vector<std::string_view> known;
  for (const Scene& scene : document.scenes) known.push_back(scene.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string nearest = did_you_mean(name, known);
      return Error{
          ErrorCode::not_found,
          "no room is called " + name + (nearest.empty() ? "; there are " + room_names(document.scenes) : nearest), ""};
    }
  std::erase_if(document.scenes,
                [&](const Scene& scene) { return std::find(names.begin(), names.end(), scene.name) == names.end(); });
  return document;
}

}  // namespace inhabit::session
