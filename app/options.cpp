#include "app/options.h"

#include "app/terminal.h"

namespace inhabit::app {

void add_scene(CLI::App& verb, SceneArgument& scene) {
  verb.add_option("SCENE", scene.name, "A file (.json, .sh3d, Home.xml, …) or the name of a built-in scene")
      ->required();
  verb.add_option("--room", scene.rooms, "Only the room of this name, when SCENE has several; may be repeated")
      ->type_name("NAME")
      ->expected(1)
      ->take_all();
  verb.add_option("--assets", scene.options.asset_database,
                  "ProcTHOR houses: their asset-database.json, which has the sizes")
      ->type_name("FILE");
  verb.add_option("--line", scene.options.line, "ProcTHOR houses, one per line: only this one, from 1; 0 = all")
      ->check(not_negative, "")
      ->capture_default_str();
}

void add_trajectory_options(CLI::App& verb, session::TrajectoryOpenOptions& options) {
  verb.add_option("--unit", options.unit, "Trajectories: unit of the positions in the file, cm or m")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"cm", "m"}));
  verb.add_option("--fps", options.frame_rate, "Trajectories: frames per second")->check(CLI::Range(1e-3, 1e4));
  verb.add_option("--homography", options.homography, "Trajectories in pixels: 3x3 matrix to metres")
      ->type_name("FILE");
}

std::optional<session::Document> open(const SceneArgument& scene, bool quiet) {
  core::Result<session::Document> document = session::open_document(scene.name, scene.options);
  if (document && !quiet)
    for (const std::string& warning : document->warnings) complain(scene.name + ": warning: " + warning);
  if (document) document = session::only_rooms(std::move(*document), scene.rooms);
  if (document) return std::move(*document);
  fail(scene.name, document.error());
  return std::nullopt;
}

bool can_save(const std::string& path) {
  if (path.empty()) return true;
  const core::Status possible = session::can_save(path);
  if (!possible) fail(path, possible.error());
  return possible.ok();
}

bool save(const std::string& path, const core::Result<std::string>& bytes) {
  if (!bytes) return fail(path, bytes.error()), false;
  const core::Status saved = session::save_file(path, *bytes);
  if (!saved) return fail(path, saved.error()), false;
  return true;
}

std::string not_negative(const std::string& text) { return text.starts_with("-") ? text + " is below 0" : ""; }

std::string numbered_path(const std::string& path, std::size_t number) {
  const std::size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
  const bool has_extension = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1) && dot > 0;
  std::string result = has_extension ? path.substr(0, dot) : path;
  result += '-';
  result += std::to_string(number);
  if (has_extension) result += path.substr(dot);
  return result;
}

}  // namespace inhabit::app
