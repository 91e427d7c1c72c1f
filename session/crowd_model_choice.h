#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/crowd.h"

/// The model of a run as people ask for it, by names.
namespace inhabit::session {
using namespace core;

struct ModelChoice {
  std::string model;             ///< "": the scene's
  std::string preset;            ///< pbd alone; "": the scene's
  std::string far;               ///< pbd alone; "": the scene's
  std::vector<std::string> set;  ///< NAME=VALUE
};

/// The scene's model with what was chosen; another model than the scene's has its own defaults, and a preset replaces
/// what the scene says. Errors: unknown names, with the nearest one; a value that is no number or outside its range.
Result<scene::CrowdModel> choose_model(const scene::CrowdModel& of_scene, const ModelChoice& choice);

/// "pbd".
std::string_view model_name(const scene::CrowdModel& model);
std::vector<std::string_view> model_names();
/// One line for each parameter of each model: name, unit, default, range and meaning.
std::string model_parameter_lines();

/// The planner of this name, "automatic" and so on.
Result<scene::Planner> planner_of(const std::string& name);

}  // namespace inhabit::session
