#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/text.h"
#include "io/formats/object_reader.h"
#include "io/formats/scene_curve.h"
#include "io/formats/scene_json.h"
#include "io/formats/scene_rules.h"

namespace inhabit::io {
namespace {

/// Everything that has an id in the space, the objects and the groups; holes and windows cannot be pointed at.
using Names = std::unordered_map<std::string_view, Ref>;

/// Reads a document into a scene. The first error ends it: every function returns false after one.
class SceneReader : public ObjectReader<SceneReader> {
 public:
  bool read(JsonValue root, Scene& scene) {
    if (!root.is(Json::object))
      return fail(root, std::string("a scene is an object, this is ") + std::string(name_of(root.kind())));
    return check_header(root, kFormatName, kFormatVersion) && collect_names(root) &&
           read_object(root, scene, {"format", "version"}) && hold(check_objects(scene)) && hold(check_groups(scene)) &&
           hold(check_crowd(scene.crowd));
  }

 private:
  friend class ObjectReader<SceneReader>;
  using ObjectReader::read;

  // Names first, so that a reference may point forward.
  bool collect_names(JsonValue root) {
    const JsonValue space = root.find("space");
    if (!space.none()) {
      for (const auto& [list, kind] :
           {std::pair{"doors", Ref::Kind::door}, {"holes", Ref::Kind::none}, {"windows", Ref::Kind::none}})
        if (!collect(space.find(list), kind)) return false;
    }
    const JsonValue crowd = root.find("crowd");
    if (const JsonValue goals = crowd.none() ? crowd : crowd.find("goals"); !goals.none() && goals.is(Json::array)) {
      for (const JsonValue goal : goals) {
        if (const JsonValue id = goal.find("id"); !id.none() && id.is(Json::text)) goals_.push_back(id.text());
      }
    }
    return collect(root.find("objects"), Ref::Kind::object) && collect(root.find("groups"), Ref::Kind::group);
  }
  bool collect(JsonValue list, Ref::Kind kind) {
    if (list.none() || !list.is(Json::array)) return true;
    std::uint32_t index = 0;
    for (const JsonValue item : list) {
      const JsonValue id = item.find("id");
      if (!id.none() && id.is(Json::text) && !id.text().empty() && !names_.emplace(id.text(), Ref{kind, index}).second)
        return fail(id, quoted(id.text()) + " is the id of something else before it");
      ++index;
    }
    return true;
  }

  bool read(JsonValue v, Space& out, const Spec&) {
    // The outline's orientation decides what the wall numbers mean, so it is asked for first.
    if (const JsonValue outline = v.find("outline"); !outline.none()) {
      Ring ring;
      if (!read(outline, ring, Spec{"", "m"})) return false;
      outline_turned_ = ring_turned_;
    }
    if (!read_object(v, out)) return false;
    walls_ = out.walls();
    if (!hold(check_space(out, outline_turned_))) return false;
    if (outline_turned_) turn_walls(out);
    return true;
  }
  bool read(JsonValue v, Curve& out, const Spec&) {
    CurveInFile file;
    if (!read_object(v, file)) return false;
    const std::optional<std::string> why = curve_from_file(file, out);
    return !why || fail(v, *why);
  }

  // References.
  bool resolve(JsonValue v, Ref& out, std::initializer_list<Ref::Kind> kinds, std::string_view wanted) {
    if (!expect(v, Json::text)) return false;
    const auto found = names_.find(v.text());
    if (found != names_.end() && std::ranges::find(kinds, found->second.kind) != kinds.end()) {
      out = found->second;
      return true;
    }
    if (found != names_.end()) return fail(v, quoted(v.text()) + " is no " + std::string(wanted));
    std::vector<std::string_view> candidates;
    for (const auto& [name, ref] : names_) {
      if (std::ranges::find(kinds, ref.kind) != kinds.end()) candidates.push_back(name);
    }
    std::ranges::sort(candidates);
    return fail(v, "no " + std::string(wanted) + " is called " + quoted(v.text()) + did_you_mean(v.text(), candidates));
  }
  bool member(JsonValue v, Ref& out) {
    return resolve(v, out, {Ref::Kind::object, Ref::Kind::group}, "object or group");
  }
  bool read(JsonValue v, Ref& out, const Spec& spec) {
    if (spec.carrier) return v.is(Json::null) || resolve(v, out, {Ref::Kind::object}, "object");
    return resolve(v, out, {Ref::Kind::object, Ref::Kind::group, Ref::Kind::door}, "object, group or door");
  }
  bool read(JsonValue v, std::array<Ref, 2>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    if (v.size() != 2) return fail(v, "names " + std::to_string(v.size()) + " things instead of two");
    std::size_t i = 0;
    for (const JsonValue item : v) {
      if (!read(item, out[i++], spec)) return false;
    }
    return out[0] != out[1] || fail(v, "names the same thing twice");
  }
  bool read(JsonValue v, std::vector<Ref>& out, const Spec&) {
    if (!expect(v, Json::array)) return false;
    if (v.size() == 0) return fail(v, "names nobody");
    for (const JsonValue item : v) {
      if (!member(item, out.emplace_back())) return false;
    }
    return true;
  }
  bool read(JsonValue v, Members& out, const Spec& spec) {
    if (v.is(Json::text)) return resolve(v, out.all_of, {Ref::Kind::group}, "group; a list of ids names objects");
    return read(v, out.list, spec);
  }

  // Constraints: the type's name decides which table is read.
  bool read(JsonValue v, Constraints& out, const Spec&) {
    if (!expect(v, Json::array)) return false;
    for (const JsonValue item : v) {
      if (!read_constraint(item, out)) return false;
    }
    return true;
  }
  /// An object whose "type" is the name of one of the kinds: `f` reads it as that.
  template <class Kinds, class F>
  bool read_by_type(Kinds kinds, JsonValue v, const std::string& what, F&& f) {
    if (!expect(v, Json::object)) return false;
    const JsonValue type = v.find("type");
    if (type.none()) return fail(v, "\"type\" is missing");
    if (!expect(type, Json::text)) return false;
    bool found = false, good = false;
    std::vector<std::string_view> names;
    for_each_type(kinds, [&]<class T>(std::type_identity<T> kind) {
      names.push_back(T::kName);
      if (found || type.text() != T::kName) return;
      found = true;
      good = f(kind);
    });
    return found ? good : fail(type, "unknown " + what + " " + quoted(type.text()) + did_you_mean(type.text(), names));
  }
  bool read_constraint(JsonValue v, Constraints& out) {
    return read_by_type(ConstraintKinds{}, v, "constraint", [&]<class T>(std::type_identity<T>) {
      T constraint;
      if (!read_object(v, constraint, {"type"}) || !check_constraint(v, constraint)) return false;
      out.add(std::move(constraint));
      return true;
    });
  }
  template <class T>
  bool check_constraint(JsonValue v, T& constraint) {
    const auto given = [&](std::string_view name) { return !v.find(name).none(); };
    if constexpr (requires { T::kNeedsOneOf; }) {
      if (std::ranges::none_of(T::kNeedsOneOf, given)) return fail(v, "needs one of: " + joined(T::kNeedsOneOf));
    }
    const JsonValue min = v.find("min"), max = v.find("max");
    if (!min.none() && !max.none() && min.number() > max.number())
      return fail(min, std::string(min.text()) + " is more than max, " + std::string(max.text()));
    bool good = true;
    for (const auto& field : T::kFields) {
      const auto* pointer = std::get_if<std::optional<int> T::*>(&field.member);
      if (field.name != "wall" || pointer == nullptr || !(constraint.**pointer) || !good) continue;
      int& wall = *(constraint.**pointer);
      if (static_cast<std::size_t>(wall) >= walls_)
        good = fail(v.find("wall"), "there is no wall " + std::to_string(wall) + ", the outline has walls 0 to " +
                                        std::to_string(walls_ - 1));
      if (outline_turned_) wall = turned_wall(wall, walls_);
    }
    return good;
  }

  // People.
  bool goal(JsonValue v, std::vector<std::string>& leg) {
    if (!expect(v, Json::text)) return false;
    if (std::ranges::find(goals_, v.text()) == goals_.end())
      return fail(v, "no goal is called " + quoted(v.text()) + did_you_mean(v.text(), goals_));
    leg.emplace_back(v.text());
    return true;
  }
  bool read(JsonValue v, Route& out, const Spec&) {
    if (v.is(Json::text)) return goal(v, out.legs.emplace_back());
    if (!v.is(Json::array)) return fail(v, "is neither a goal's id nor a list of them");
    if (v.size() == 0) return fail(v, "names no goal");
    for (const JsonValue leg : v) {
      std::vector<std::string>& goals = out.legs.emplace_back();
      if (!leg.is(Json::array)) {
        if (!goal(leg, goals)) return false;
        continue;
      }
      if (leg.size() == 0) return fail(leg, "names no goal");
      for (const JsonValue item : leg) {
        if (!goal(item, goals)) return false;
      }
    }
    return true;
  }
  bool read(JsonValue v, CrowdModel& out, const Spec&) {
    return read_by_type(CrowdModels{}, v, "model", [&]<class T>(std::type_identity<T>) {
      T model;
      if constexpr (std::is_same_v<T, PbdModel>) {
        const auto& field = PbdModel::kFields.front();
        int preset = static_cast<int>(kUsualPreset);
        if (const JsonValue given = v.find(field.name);
            !given.none() && !choice(given, preset, Spec{.choices = field.choices}))
          return false;
        model = PbdModel::of_preset(static_cast<PbdModel::Preset>(preset));
      }
      const bool good = read_object(v, model, {"type"});
      out = model;
      return good;
    });
  }

  Names names_;
  std::vector<std::string_view> goals_;
  std::size_t walls_ = 0;
  bool outline_turned_ = false;
};

}  // namespace

Result<Scene> read_scene(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  Scene scene;
  SceneReader reader;
  if (!reader.read(document->root(), scene)) return *reader.error;
  return scene;
}

}  // namespace inhabit::io
