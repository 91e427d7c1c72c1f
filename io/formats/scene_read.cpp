#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/text.h"
#include "io/formats/scene_curve.h"
#include "io/formats/scene_json.h"
#include "io/formats/scene_members.h"
#include "io/formats/scene_rules.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// Everything that has an id in the space, the objects and the groups; holes and windows cannot be pointed at.
using Names = std::unordered_map<std::string_view, Ref>;

/// Reads a document into a scene. The first error ends it: every function returns false after one.
class SceneReader {
 public:
  std::optional<Error> error;

  bool read(JsonValue root, Scene& scene) {
    if (!root.is(Json::object))
      return fail(root, std::string("a scene is an object, this is ") + std::string(name_of(root.kind())));
    if (const JsonValue format = root.find("format"); !format.none() && format.text() != kFormatName)
      return fail(format, "is not \"" + std::string(kFormatName) + "\"");
    if (const JsonValue version = root.find("version");
        !version.none() && version.text() != std::to_string(kFormatVersion))
      return fail(version, version.is(Json::number) && version.number() > kFormatVersion
                               ? "written by a newer inhabit; this one reads version " + std::to_string(kFormatVersion)
                               : "is not " + std::to_string(kFormatVersion));
    return collect_names(root) && read_object(root, scene, {"format", "version"}) && hold(check_objects(scene)) &&
           hold(check_groups(scene)) && hold(check_crowd(scene.crowd));
  }

 private:
  bool fail(JsonValue at, std::string message) {
    if (!error) error = at.error(std::move(message));
    return false;
  }
  bool hold(const Status& status) {
    if (!status && !error) error = status.error();
    return status.ok();
  }
  bool expect(JsonValue v, Json kind) {
    if (v.is(kind)) return true;
    return fail(v, "is " + std::string(name_of(v.kind())) + " where " + std::string(name_of(kind)) + " belongs");
  }

  // Names first, so that a reference may point forward.
  bool collect_names(JsonValue root) {
    const JsonValue space = root.find("space");
    if (!space.none()) {
      for (const auto& [list, kind] :
           {std::pair{"doors", Ref::Kind::door}, {"holes", Ref::Kind::none}, {"windows", Ref::Kind::none}})
        if (!collect(space.find(list), kind)) return false;
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

  template <class T>
  bool check_unknown(JsonValue v, std::vector<std::string_view> known) {
    for_each_member<T>([&](std::string_view name, auto, const Spec&) { known.push_back(name); });
    constexpr bool kExtras = requires(T t) { t.extras; };
    for (const JsonValue member : v) {
      if ((kExtras && member.key().starts_with("x-")) || std::ranges::find(known, member.key()) != known.end())
        continue;
      return fail(member, "unknown key" + did_you_mean(member.key(), known));
    }
    return true;
  }

  template <class T>
  bool read_object(JsonValue v, T& out, const std::vector<std::string_view>& also = {}) {
    if (!expect(v, Json::object)) return false;
    std::size_t known = 0;
    for_each_member<T>([&](std::string_view name, auto, const Spec&) { known += v.find(name).none() ? 0 : 1; });
    if (known < v.size() && !check_unknown<T>(v, also)) return false;
    bool good = true;
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      if (!good) return;
      const JsonValue member = v.find(name);
      if (member.none()) {
        if (spec.required) good = fail(v, "\"" + std::string(name) + "\" is missing");
      } else {
        good = read(member, out.*pointer, spec);
      }
    });
    if constexpr (requires { out.extras; }) {
      if (good && known < v.size()) {
        for (const JsonValue member : v) {
          if (member.key().starts_with("x-")) out.extras.emplace_back(member.key(), flat_json(member));
        }
      }
    }
    return good;
  }

  bool number(JsonValue v, double& out, const Spec& spec) {
    if (!expect(v, Json::number)) return false;
    const double low = file_bound(spec, spec.low), high = file_bound(spec, spec.high);
    if (!(v.number() >= low && v.number() <= high)) {
      const std::string_view unit = file_unit(spec);
      return fail(v, std::string(v.text().substr(0, 40)) + " is outside [" + number_text(low) + ", " +
                         number_text(high) + "]" + (unit.empty() ? "" : " " + std::string(unit)));
    }
    out = spec.unit == "rad" ? radians(std::round(v.number() * 1e9) / 1e9) : v.number();
    return true;
  }
  template <std::size_t N>
  bool numbers(JsonValue v, std::array<double, N>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    if (v.size() != N) return fail(v, "has " + std::to_string(v.size()) + " numbers instead of " + std::to_string(N));
    std::size_t i = 0;
    for (const JsonValue item : v) {
      if (!number(item, out[i++], spec)) return false;
    }
    return true;
  }
  bool choice(JsonValue v, int& out, const Spec& spec) {
    if (!expect(v, Json::text)) return false;
    const auto names = split_choices(spec.choices);
    const auto found = std::ranges::find(names, v.text());
    if (found == names.end()) {
      std::string all;
      for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
      return fail(v, quoted(v.text()) + " is none of: " + all + did_you_mean(v.text(), names));
    }
    out = static_cast<int>(found - names.begin());
    return true;
  }

  bool read(JsonValue v, double& out, const Spec& spec) { return number(v, out, spec); }
  bool read(JsonValue v, bool& out, const Spec&) {
    if (!expect(v, Json::boolean)) return false;
    out = v.boolean();
    return true;
  }
  bool read(JsonValue v, int& out, const Spec& spec) {
    if (!spec.choices.empty()) return choice(v, out, spec);
    double value = 0;
    if (!number(v, value, spec)) return false;
    if (value != std::trunc(value)) return fail(v, std::string(v.text().substr(0, 40)) + " is no whole number");
    out = static_cast<int>(value);
    return true;
  }
  bool read(JsonValue v, std::uint64_t& out, const Spec&) {
    if (!expect(v, Json::number)) return false;
    const std::string_view digits = v.text();
    std::uint64_t value = 0;
    for (const char c : digits) {
      if (c < '0' || c > '9') return fail(v, "is no whole number from 0 to 18446744073709551615");
      value = value * 10 + static_cast<std::uint64_t>(c - '0');
    }
    // The parser keeps numbers beyond 64 bits as decimals with their text; they have 20 digits or more.
    if (digits.size() > 20 || (digits.size() == 20 && std::to_string(value) != digits))
      return fail(v, "is no whole number from 0 to 18446744073709551615");
    out = value;
    return true;
  }
  bool read(JsonValue v, std::string& out, const Spec& spec) {
    if (!expect(v, Json::text)) return false;
    if (spec.required && v.text().empty()) return fail(v, "is empty");
    out = v.text();
    return true;
  }
  template <class E>
  requires std::is_enum_v<E>
  bool read(JsonValue v, E& out, const Spec& spec) {
    int index = 0;
    if (!choice(v, index, spec)) return false;
    out = static_cast<E>(index);
    return true;
  }
  template <class T>
  bool read(JsonValue v, std::optional<T>& out, const Spec& spec) {
    return read(v, out.emplace(), spec);
  }
  bool read(JsonValue v, Vec2& out, const Spec& spec) {
    std::array<double, 2> a{};
    if (!numbers(v, a, spec)) return false;
    out = {a[0], a[1]};
    return true;
  }
  bool read(JsonValue v, Vec3& out, const Spec& spec) {
    std::array<double, 3> a{};
    if (!numbers(v, a, spec)) return false;
    out = {a[0], a[1], a[2]};
    return true;
  }
  bool read(JsonValue v, Ring& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    out.reserve(v.size());
    for (const JsonValue corner : v) {
      if (!read(corner, out.emplace_back(), spec)) return false;
    }
    if (const auto why = why_not_simple(out)) return fail(v, *why);
    ring_turned_ = signed_area(out) < 0;
    if (ring_turned_) std::reverse(out.begin() + 1, out.end());
    return true;
  }
  template <class T>
  requires HasTable<T>
  bool read(JsonValue v, T& out, const Spec&) { return read_object(v, out); }
  template <class T>
  requires HasTable<T>
  bool read(JsonValue v, std::vector<T>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    out.reserve(v.size());
    for (const JsonValue item : v) {
      if (!read(item, out.emplace_back(), spec)) return false;
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
  bool read_constraint(JsonValue v, Constraints& out) {
    if (!expect(v, Json::object)) return false;
    const JsonValue type = v.find("type");
    if (type.none()) return fail(v, "\"type\" is missing");
    if (!expect(type, Json::text)) return false;
    bool found = false, good = false;
    std::vector<std::string_view> names;
    for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
      names.push_back(T::kName);
      if (found || type.text() != T::kName) return;
      found = true;
      T constraint;
      good = read_object(v, constraint, {"type"}) && check_constraint(v, constraint);
      if (good) out.add(std::move(constraint));
    });
    return found ? good : fail(type, "unknown constraint " + quoted(type.text()) + did_you_mean(type.text(), names));
  }
  template <class T>
  bool check_constraint(JsonValue v, T& constraint) {
    const auto given = [&](std::string_view name) { return !v.find(name).none(); };
    if constexpr (requires { T::kNeedsOneOf; }) {
      if (std::ranges::none_of(T::kNeedsOneOf, given)) {
        std::string all;
        for (const std::string_view name : T::kNeedsOneOf) all += (all.empty() ? "" : ", ") + std::string(name);
        return fail(v, "needs one of: " + all);
      }
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

  Names names_;
  std::size_t walls_ = 0;
  bool ring_turned_ = false, outline_turned_ = false;
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
