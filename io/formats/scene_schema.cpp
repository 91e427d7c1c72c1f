#include "io/formats/scene_schema.h"

#include "io/formats/scene_curve.h"
#include "io/formats/scene_members.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// The value of a member as JSON, "" when it has none worth telling.
template <class X>
std::string value_text(const X& value, const Spec& spec) {
  std::string out;
  if constexpr (std::is_same_v<X, double>) {
    append_number(out, spec.unit == "rad" ? file_degrees(value) : value);
  } else if constexpr (std::is_same_v<X, bool>) {
    out = value ? "true" : "false";
  } else if constexpr (std::is_same_v<X, int> || std::is_enum_v<X>) {
    const int index = static_cast<int>(value);
    spec.choices.empty() ? append_number(out, index)
                         : append_quoted(out, split_choices(spec.choices)[static_cast<std::size_t>(index)]);
  } else if constexpr (std::is_same_v<X, Vec3>) {
    out = std::string("[") + number_text(value.x) + ", " + number_text(value.y) + ", " + number_text(value.z) + "]";
  } else if constexpr (std::is_same_v<X, Span>) {
    append_number(out, value.low);
  } else if constexpr (std::is_same_v<X, std::uint64_t>) {
    out = std::to_string(value);
  }
  return out;
}

/// The default of a member as JSON, "" when it has none worth telling.
template <class T, class M>
std::string default_of(M pointer, const Spec& spec) {
  if (spec.required) return "";
  // What a preset decides has no one default.
  if constexpr (std::is_same_v<T, PbdModel>) {
    return spec.choices == PbdModel::kFields.front().choices ? value_text(static_cast<int>(kUsualPreset), spec) : "";
  } else {
    static const T kValue{};
    return value_text(kValue.*pointer, spec);
  }
}

class SchemaWriter {
 public:
  std::string text() {
    out_ = R"({"$schema": "http://json-schema.org/draft-07/schema#", "title": "inhabit scene", )";
    out_ += R"("description": "A space, what stands in it, the rules of its arrangement, and the people in it. )";
    out_ += R"(Metres, degrees counter-clockwise, z up.", )";
    properties<Scene>(R"("format": {"const": "inhabit-scene"}, "version": {"const": 1}, )", "");
    out_ += "}";
    return std::move(out_);
  }

 private:
  /// "type", "properties", "required" and what else may be there; without the braces.
  template <class T>
  void properties(std::string_view first, std::string required) {
    out_ += R"("type": "object", "properties": {)";
    out_ += first;
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      append_quoted(out_, name), out_ += ": {";
      describe(spec);
      type(std::type_identity<std::remove_cvref_t<decltype(std::declval<T>().*pointer)>>{}, spec);
      if (const std::string value = default_of<T>(pointer, spec); !value.empty()) out_ += R"(, "default": )" + value;
      out_ += "}, ";
      if (spec.required) required += (required.empty() ? "" : ", ") + quoted(name);
    });
    out_.resize(out_.size() - 2);
    out_ += '}';
    if (!required.empty()) out_ += R"(, "required": [)" + required + "]";
    if constexpr (requires(T t) { t.extras; }) out_ += R"(, "patternProperties": {"^x-": {}})";
    out_ += R"(, "additionalProperties": false)";
    if constexpr (HasTable<T>) company<T>();
  }
  template <class List>
  void required_one_by_one(std::string_view keyword, const List& names) {
    out_ += ", " + quoted(keyword) + ": [";
    for (const std::string_view name : names) out_ += R"({"required": [)" + quoted(name) + "]}, ";
    out_.resize(out_.size() - 2);
    out_ += ']';
  }
  template <class T>
  void company() {
    if constexpr (requires { Table<T>::needs_one_of; }) required_one_by_one("anyOf", Table<T>::needs_one_of);
    if constexpr (requires { Table<T>::exactly_one_of; }) required_one_by_one("oneOf", Table<T>::exactly_one_of);
    if constexpr (requires { Table<T>::only_with; }) {
      out_ += R"(, "dependencies": {)";
      for (const OnlyWith& rule : Table<T>::only_with) out_ += quoted(rule.name) + ": [" + quoted(rule.with) + "], ";
      out_.resize(out_.size() - 2);
      out_ += '}';
    }
  }
  void describe(const Spec& spec) {
    if (spec.help.empty()) return;
    std::string text(spec.help);
    if (!file_unit(spec).empty()) text += " (" + std::string(file_unit(spec)) + ")";
    out_ += R"("description": )", append_quoted(out_, text), out_ += ", ";
  }

  void type(std::type_identity<double>, const Spec& spec) {
    out_ += R"("type": "number", "minimum": )" + number_text(file_bound(spec, spec.low)) + R"(, "maximum": )" +
            number_text(file_bound(spec, spec.high));
  }
  void type(std::type_identity<bool>, const Spec&) { out_ += R"("type": "boolean")"; }
  void type(std::type_identity<int>, const Spec& spec) {
    if (!spec.choices.empty()) return choices(spec);
    out_ += R"("type": "integer", "minimum": )" + number_text(spec.low) + R"(, "maximum": )" + number_text(spec.high);
  }
  void type(std::type_identity<std::uint64_t>, const Spec&) { out_ += R"("type": "integer", "minimum": 0)"; }
  void type(std::type_identity<std::string>, const Spec& spec) {
    out_ += R"("type": "string")";
    if (spec.required) out_ += R"(, "minLength": 1)";
  }
  template <class E>
  requires std::is_enum_v<E>
  void type(std::type_identity<E>, const Spec& spec) { choices(spec); }
  void choices(const Spec& spec) {
    out_ += R"("enum": [)";
    for (const std::string_view name : split_choices(spec.choices)) out_ += quoted(name) + ", ";
    out_.resize(out_.size() - 2);
    out_ += ']';
  }
  template <class T>
  void type(std::type_identity<std::optional<T>>, const Spec& spec) {
    type(std::type_identity<T>{}, spec);
  }
  void type(std::type_identity<Vec2>, const Spec& spec) { numbers(2, spec); }
  void type(std::type_identity<Vec3>, const Spec& spec) { numbers(3, spec); }
  void numbers(int count, const Spec& spec) {
    const std::string n = std::to_string(count);
    out_ += R"("type": "array", "minItems": )" + n + R"(, "maxItems": )" + n + R"(, "items": {)";
    type(std::type_identity<double>{}, spec);
    out_ += '}';
  }
  void type(std::type_identity<Ring>, const Spec& spec) {
    out_ += R"("type": "array", "minItems": 3, "items": {)";
    numbers(2, spec);
    out_ += '}';
  }
  void type(std::type_identity<Ref>, const Spec& spec) {
    out_ += spec.carrier ? R"("type": ["string", "null"])" : R"("type": "string")";
  }
  void type(std::type_identity<std::array<Ref, 2>>, const Spec&) {
    out_ += R"("type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "string"})";
  }
  void type(std::type_identity<std::vector<Ref>>, const Spec&) {
    out_ += R"("type": "array", "minItems": 1, "items": {"type": "string"})";
  }
  void type(std::type_identity<Members>, const Spec&) {
    out_ += R"("oneOf": [{"type": "array", "minItems": 1, "items": {"type": "string"}}, )";
    out_ += R"({"type": "string", "description": "every member of this group"}])";
  }
  void type(std::type_identity<Curve>, const Spec&) {
    properties<CurveInFile>("", "");
    out_ += R"(, "minProperties": 1, "maxProperties": 1)";
  }
  template <class T>
  requires HasTable<T>
  void type(std::type_identity<T>, const Spec&) { properties<T>("", ""); }
  template <class T>
  void type(std::type_identity<std::vector<T>>, const Spec& spec) {
    out_ += R"("type": "array", "items": {)";
    type(std::type_identity<T>{}, spec);
    out_ += '}';
  }
  void type(std::type_identity<Constraints>, const Spec&) {
    out_ += R"("type": "array", "items": {"oneOf": [)";
    for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
      out_ += '{';
      properties<T>(R"("type": {"const": )" + quoted(T::kName) + "}, ", R"("type")");
      if constexpr (requires { T::kNeedsOneOf; }) required_one_by_one("anyOf", T::kNeedsOneOf);
      out_ += "}, ";
    });
    out_.resize(out_.size() - 2);
    out_ += "]}";
  }

  void type(std::type_identity<Span>, const Spec& spec) {
    out_ += R"("oneOf": [{)";
    type(std::type_identity<double>{}, spec);
    out_ += "}, {";
    numbers(2, spec);
    out_ += "}]";
  }
  void type(std::type_identity<Route>, const Spec&) {
    out_ +=
        R"("oneOf": [{"type": "string"}, {"type": "array", "minItems": 1, "items": {"oneOf": [{"type": "string"}, )";
    out_ += R"({"type": "array", "minItems": 1, "items": {"type": "string"}}]}}])";
  }
  void type(std::type_identity<CrowdModel>, const Spec&) {
    out_ += R"("oneOf": [)";
    for_each_type(CrowdModels{}, [&]<class T>(std::type_identity<T>) {
      out_ += '{';
      properties<T>(R"("type": {"const": )" + quoted(T::kName) + "}, ", R"("type")");
      out_ += "}, ";
    });
    out_.resize(out_.size() - 2);
    out_ += ']';
  }

  std::string out_;
};

// How the reference page names what a member holds.
template <class X>
std::string kind_of(const Spec& spec) {
  if (!spec.choices.empty()) {
    std::string all;
    for (const std::string_view name : split_choices(spec.choices))
      all += (all.empty() ? "" : ", ") + std::string(name);
    return all;
  }
  if constexpr (std::is_same_v<X, Ref>) return "id";
  if constexpr (std::is_same_v<X, std::array<Ref, 2>>) return "two ids";
  if constexpr (std::is_same_v<X, Members>) return "ids, or one group's id";
  if constexpr (std::is_same_v<X, bool>) return "true or false";
  std::string text = std::string("[") + number_text(file_bound(spec, spec.low)) + ", " +
                     number_text(file_bound(spec, spec.high)) + "]";
  if (!file_unit(spec).empty()) text += " " + std::string(file_unit(spec));
  if constexpr (std::is_same_v<X, Vec2>) return "point in " + text;
  if constexpr (std::is_same_v<X, Ring>) return "polygon in " + text;
  return text;
}

/// The first columns of a member's row: name, meaning, values.
template <class T, class M>
std::string row_of(std::string_view name, M, const Spec& spec) {
  using X = std::remove_cvref_t<decltype(std::declval<T>().*std::declval<M>())>;
  const std::string mark = spec.required ? "**" : "";
  return "| " + mark + std::string(name) + mark + " | " + std::string(spec.help) + " | " + kind_of<X>(spec);
}

}  // namespace

std::string scene_schema() { return pretty_json(SchemaWriter().text()); }

std::string constraints_page() {
  std::string page =
      "# Constraints\n\nEvery constraint that a scene may hold, in the order of projection. This page is made from the "
      "tables in\n"
      "`scene/constraint_kinds.h`. Lists of ids name objects and groups; one group's id stands for all its members. "
      "Angles are\n"
      "degrees. Members in bold must be given.\n";
  for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
    page += "\n## " + std::string(T::kName) + "\n\n| member | meaning | values | default |\n|---|---|---|---|\n";
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      page += row_of<T>(name, pointer, spec) + " | " + default_of<T>(pointer, spec) + " |\n";
    });
    if constexpr (requires { T::kNeedsOneOf; }) {
      page += "\nAt least one of";
      for (const std::string_view name : T::kNeedsOneOf)
        page += (name == T::kNeedsOneOf.front() ? " " : ", ") + std::string(name);
      page += " must be given.\n";
    }
  });
  return page;
}

std::string crowd_models_page() {
  std::string page =
      "# Models of crowds\n\nEvery model of how people walk that a scene's `crowd` may name as its `model`, with all "
      "its "
      "parameters. This page\nis made from the tables in `scene/crowd_models.h`; what the models are stands in "
      "`crowd/models/`, one file each.\nSymbols and equations: [papers.md](papers.md); how the values of `pedestrian` "
      "were found: "
      "[results.md](results.md#realism).\n";
  for_each_type(CrowdModels{}, [&]<class T>(std::type_identity<T>) {
    constexpr bool kPresets = std::is_same_v<T, PbdModel>;
    page += "\n## " + std::string(T::kName) + "\n\n| member | meaning | values | ";
    page += kPresets ? "`game` | `pedestrian` |\n|---|---|---|---|---|\n" : "default |\n|---|---|---|---|\n";
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      page += row_of<T>(name, pointer, spec) + " | ";
      if constexpr (kPresets) {
        const T game = T::of_preset(T::Preset::game), pedestrian = T::of_preset(T::Preset::pedestrian);
        page += value_text(game.*pointer, spec) + " | " + value_text(pedestrian.*pointer, spec) + " |\n";
      } else {
        page += default_of<T>(pointer, spec) + " |\n";
      }
    });
  });
  return page;
}

}  // namespace inhabit::io
