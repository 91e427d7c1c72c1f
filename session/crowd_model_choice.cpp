#include "session/crowd_model_choice.h"

#include <charconv>

#include "core/text.h"

namespace inhabit::session {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

/// The index of a name among names.
Result<int> choice_of(std::string_view name, const std::vector<std::string_view>& names, const std::string& what) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<int>(k);
  return invalid(what, "\"" + std::string(name) + "\" is none of " + listed(names) + did_you_mean(name, names));
}

template <class T>
Result<double> number_of(std::string_view text, const scene::Field<T>& field, const std::string& what) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return invalid(what, "\"" + std::string(text) + "\" is no number");
  if (!(value >= field.low && value <= field.high))
    return invalid(what, shortest(value) + " is outside [" + shortest(field.low) + ", " + shortest(field.high) + "]" +
                             (field.unit.empty() ? "" : " ") + std::string(field.unit));
  return value;
}

template <class T>
Status set_field(T& model, const scene::Field<T>& field, std::string_view text) {
  const std::string what = "--set " + std::string(field.name);
  if (!field.choices.empty()) {
    const Result<int> choice = choice_of(text, split(field.choices, '|'), what);
    if (!choice) return choice.error();
    model.*std::get<scene::Choice T::*>(field.member) = *choice;
    return Done{};
  }
  const Result<double> value = number_of(text, field, what);
  if (!value) return value.error();
  if (const auto* real = std::get_if<double T::*>(&field.member)) {
    model.** real = *value;
  } else if (const auto* whole = std::get_if<int T::*>(&field.member)) {
    if (*value != static_cast<int>(*value)) return invalid(what, std::string(text) + " is no whole number");
    model.** whole = static_cast<int>(*value);
  } else {
    return invalid(what, "this parameter can be set in the scene alone");
  }
  return Done{};
}

template <class T>
Status set_by_name(T& model, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return invalid("--set " + assignment, "it must be NAME=VALUE");
  const std::string_view name = std::string_view(assignment).substr(0, equals);
  std::vector<std::string_view> known;
  for (const scene::Field<T>& field : T::kFields) {
    if (field.name == name) return set_field(model, field, std::string_view(assignment).substr(equals + 1));
    known.push_back(field.name);
  }
  const std::string nearest = did_you_mean(name, known);
  return invalid("--set " + std::string(name), "the model " + std::string(T::kName) + " has no such parameter" +
                                                   (nearest.empty() ? "; it has " + listed(known) : nearest));
}

template <std::size_t k = 0>
scene::CrowdModel model_of_index(int index) {
  if constexpr (k + 1 < std::variant_size_v<scene::CrowdModel>)
    if (index != static_cast<int>(k)) return model_of_index<k + 1>(index);
  using T = std::variant_alternative_t<k, scene::CrowdModel>;
  if constexpr (std::is_same_v<T, scene::PbdModel>) return T::of_preset(T::Preset::pedestrian);
  return T{};
}

template <class T>
void append_parameters(std::string& text, const T& model) {
  text.append(T::kName).append(":\n");
  for (const scene::Field<T>& field : T::kFields) {
    std::string value;
    if (const auto* real = std::get_if<double T::*>(&field.member)) value = shortest(model.**real);
    if (const auto* whole = std::get_if<int T::*>(&field.member)) {
      const auto at = static_cast<std::size_t>(model.**whole);
      value = field.choices.empty() ? std::to_string(model.**whole) : std::string(split(field.choices, '|')[at]);
    }
    std::string line = "  " + std::string(field.name) + " = " + value;
    if (!field.unit.empty()) line.append(" ").append(field.unit);
    line.resize(std::max<std::size_t>(line.size() + 1, 36), ' ');
    text.append(line).append(field.help).append("\n");
  }
}

}  // namespace

std::string_view model_name(const scene::CrowdModel& model) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::kName; }, model);
}

std::vector<std::string_view> model_names() {
  std::vector<std::string_view> names;
  for (int k = 0; k < static_cast<int>(std::variant_size_v<scene::CrowdModel>); ++k)
    names.push_back(model_name(model_of_index(k)));
  return names;
}

std::string model_parameter_lines() {
  std::string text;
  for (int k = 0; k < static_cast<int>(std::variant_size_v<scene::CrowdModel>); ++k)
    std::visit([&](const auto& m) { append_parameters(text, m); }, model_of_index(k));
  return text;
}

Result<scene::CrowdModel> choose_model(const scene::CrowdModel& of_scene, const ModelChoice& choice) {
  scene::CrowdModel model = of_scene;
  if (!choice.model.empty()) {
    const Result<int> index = choice_of(choice.model, model_names(), "--model");
    if (!index) return index.error();
    if (static_cast<std::size_t>(*index) != model.index()) model = model_of_index(*index);
  }
  if (!choice.preset.empty() || !choice.far.empty()) {
    if (!std::holds_alternative<scene::PbdModel>(model))
      return invalid(choice.preset.empty() ? "--far" : "--preset",
                     "the model " + std::string(model_name(model)) + " has none; it is for pbd");
    auto& pbd = std::get<scene::PbdModel>(model);
    if (!choice.preset.empty()) {
      const Result<int> preset = choice_of(choice.preset, {"game", "pedestrian"}, "--preset");
      if (!preset) return preset.error();
      pbd = scene::PbdModel::of_preset(static_cast<scene::PbdModel::Preset>(*preset));
    }
    if (!choice.far.empty()) {
      const Result<int> far = choice_of(choice.far, {"off", "long-range", "avoidance"}, "--far");
      if (!far) return far.error();
      pbd.far = *far;
    }
  }
  for (const std::string& assignment : choice.set)
    if (Status s = std::visit([&](auto& m) { return set_by_name(m, assignment); }, model); !s) return s.error();
  return model;
}

Result<scene::Planner> planner_of(const std::string& name) {
  const Result<int> index = choice_of(name, {"automatic", "straight", "paths", "field"}, "--planner");
  if (!index) return index.error();
  return static_cast<scene::Planner>(*index);
}

}  // namespace inhabit::session
