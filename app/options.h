#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "session/document.h"
#include "session/trajectory_document.h"

/// Options that several verbs share, so that they are called and explained alike.
namespace inhabit::app {

struct SceneArgument {
  std::string name;
  std::vector<std::string> rooms;
  session::OpenOptions options;
};

/// SCENE and --room.
void add_scene(CLI::App& verb, SceneArgument& scene);
/// --unit, --fps and --homography, for files of trajectories that leave them open.
void add_trajectory_options(CLI::App& verb, session::TrajectoryOpenOptions& options);
/// Opens the scene and keeps the rooms asked for. Complains and returns nothing when that fails; warnings go to
/// standard error unless `quiet`.
std::optional<session::Document> open(const SceneArgument& scene, bool quiet);

/// Complains when `path` could not be written, before any work is done for it; empty names are good.
bool can_save(const std::string& path);
/// Writes bytes to `path`; false after a complaint.
bool save(const std::string& path, const core::Result<std::string>& bytes);

/// For numbers without a sign: the parser would read -1 as the largest there is.
std::string not_negative(const std::string& text);

/// "plan.svg" and 2 give "plan-2.svg".
std::string numbered_path(const std::string& path, std::size_t number);

}  // namespace inhabit::app
