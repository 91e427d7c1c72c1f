#pragma once
#include <tuple>

#include "scene/scene.h"

/// What every object of a scene document may hold, said once: reading, writing, the JSON Schema and the error messages
/// all come from these tables. Constraints describe themselves (scene/constraint_kinds.h).
namespace inhabit::io {
using namespace scene;

/// What a member means and which values it may have; `low` and `high` are in code units (radians for "rad").
struct Spec {
  std::string_view help;
  std::string_view unit = "";
  double low = -1e6, high = 1e6;
  bool required = false;
  std::string_view choices = "";
  bool carrier = false;  ///< a Ref that must be an object, or null
};

template <class T, class M>
struct Member {
  std::string_view name;
  M T::*pointer;
  Spec spec;
};
// clang 14 does not deduce aggregates.
template <class T, class M>
Member(std::string_view, M T::*, Spec) -> Member<T, M>;

template <class T>
struct Table;

template <class T>
concept HasTable = requires {
  Table<T>::members;
};
/// Constraints and crowd models describe themselves.
template <class T>
concept HasFields = requires {
  T::kFields;
};

/// One member that means something only beside another.
struct OnlyWith {
  std::string_view name, with;
};

/// Calls f(name, pointer to member, spec) for every member that a T may have in a document, in the order of writing.
template <class T, class F>
void for_each_member(F&& f) {
  if constexpr (HasFields<T>) {
    for (const auto& field : T::kFields) {
      const Spec spec{field.help, field.unit, field.low, field.high, field.required, field.choices};
      std::visit([&](auto pointer) { f(field.name, pointer, spec); }, field.member);
    }
    if constexpr (std::derived_from<T, Strength>) {
      f("stiffness", &Strength::stiffness,
        Spec{"how much of the error one projection removes; the kind's default when absent", "", 0, 1});
      f("weight", &Strength::weight, Spec{"weight in the energy; the kind's default when absent", "", 0, 1e6});
    }
  } else {
    std::apply([&](const auto&... member) { (f(member.name, member.pointer, member.spec), ...); }, Table<T>::members);
  }
}

constexpr double kMetres = 1e6;     ///< nothing is farther from the origin
constexpr double kSmallest = 1e-4;  ///< nothing is thinner
constexpr double kTurn = 2 * kPi;

template <>
struct Table<Hole> {
  static constexpr std::tuple members{
      Member{"id", &Hole::id, {"name of the hole"}},
      Member{
          "outline", &Hole::outline, {"its corners, inside the outline of the space", "m", -kMetres, kMetres, true}}};
};

template <>
struct Table<Door> {
  static constexpr std::tuple members{
      Member{"id", &Door::id, {"name of the door", "", 0, 0, true}},
      Member{"wall", &Door::wall, {"the wall it is in: wall k joins corner k to corner k + 1", "", 0, 1e6, true}},
      Member{"from", &Door::from, {"from the wall's first corner to the near jamb", "m", 0, kMetres, true}},
      Member{"width", &Door::width, {"clear width", "m", 0.01, 1e4}},
      Member{"height", &Door::height, {"clear height", "m", 0.01, 1e3}},
      Member{"swing", &Door::swing, {"which way the leaf opens", "", 0, 0, false, "in|out|none"}},
      Member{"hinge", &Door::hinge, {"the jamb it turns on, along the wall", "", 0, 0, false, "start|end"}}};
};

template <>
struct Table<Window> {
  static constexpr std::tuple members{
      Member{"id", &Window::id, {"name of the window"}},
      Member{"wall", &Window::wall, {"the wall it is in: wall k joins corner k to corner k + 1", "", 0, 1e6, true}},
      Member{"from", &Window::from, {"from the wall's first corner to the near edge", "m", 0, kMetres, true}},
      Member{"width", &Window::width, {"width", "m", 0.01, 1e4}},
      Member{"sill", &Window::sill, {"height of its lower edge above the floor", "m", 0, 1e3}},
      Member{"height", &Window::height, {"height of the opening itself", "m", 0.01, 1e3}}};
};

template <>
struct Table<Space> {
  static constexpr std::tuple members{
      Member{"outline", &Space::outline, {"corners of the room, counter-clockwise", "m", -kMetres, kMetres, true}},
      Member{"holes", &Space::holes, {"pillars, shafts: what is no floor"}},
      Member{"height", &Space::height, {"from floor to ceiling", "m", 0.1, 1e3}},
      Member{"doors", &Space::doors, {"openings that people use"}},
      Member{"windows", &Space::windows, {"openings for light"}}};
};

template <>
struct Table<Clearance> {
  static constexpr std::tuple members{
      Member{"front", &Clearance::front, {"before the front face", "m", 0, 100}},
      Member{"back", &Clearance::back, {"behind the back face", "m", 0, 100}},
      Member{"left", &Clearance::left, {"at the left face, seen along its heading", "m", 0, 100}},
      Member{"right", &Clearance::right, {"at the right face", "m", 0, 100}}};
};

template <>
struct Table<View> {
  static constexpr std::tuple members{
      Member{"distance", &View::distance, {"length of the cone from the front face's centre", "m", 0, 1e4, true}},
      Member{"angle", &View::angle, {"full opening of the cone", "rad", 0, kTurn, true}}};
};

template <>
struct Table<Object> {
  static constexpr std::tuple members{
      Member{"id", &Object::id, {"unique name", "", 0, 0, true}},
      Member{"kind", &Object::kind, {"what it is: bed, chair, lamp"}},
      Member{"name", &Object::name, {"what people call it"}},
      Member{"size", &Object::size, {"width across the front, depth front to back, height", "m", kSmallest, 1e4}},
      Member{"position",
             &Object::position,
             {"centre of the footprint and height of the base; anywhere when absent", "m", -kMetres, kMetres}},
      Member{"angle",
             &Object::angle,
             {"where the front faces, counter-clockwise from +x; any when absent", "rad", -kTurn, kTurn}},
      Member{"elevation",
             &Object::elevation,
             {"height of the base while there is no position; by its carrier and mount when absent", "m", 0, 1e4}},
      Member{"fixed", &Object::fixed, {"never moves, like a built-in thing"}},
      Member{"lock", &Object::lock, {"what a user has pinned", "", 0, 0, false, "none|position|angle|both"}},
      Member{"clearance", &Object::clearance, {"free depth wanted in front of each face"}},
      Member{"view", &Object::view, {"a cone from the front that stays free"}},
      Member{"mount", &Object::mount, {"what it is fastened to", "", 0, 0, false, "floor|wall|ceiling"}},
      Member{"on", &Object::on, {"the object that carries it, or null", "", 0, 0, false, "", true}},
      Member{"mass", &Object::mass, {"how hard it is to move; the box's volume when absent", "", 1e-9, 1e9}},
      Member{"model", &Object::model, {"file of its three-dimensional model"}}};
};

template <>
struct Table<Group> {
  static constexpr std::tuple members{
      Member{"id", &Group::id, {"unique name", "", 0, 0, true}},
      Member{"members", &Group::members, {"objects and groups that belong together", "", 0, 0, true}},
      Member{"rigid", &Group::rigid, {"moves as one piece"}},
      Member{"spacing", &Group::spacing, {"equal distance between neighbours along the curve", "m", 0, 1e4}},
      Member{"curve", &Group::curve, {"the line or arc that the members stand on"}},
      Member{"position", &Group::position, {"where the whole stands", "m", -kMetres, kMetres}},
      Member{"angle", &Group::angle, {"where the whole faces", "rad", -kTurn, kTurn}}};
};

template <>
struct Table<Speed> {
  static constexpr std::tuple members{
      Member{"mean", &Speed::mean, {"mean desired speed", "m/s", 0, 100}},
      Member{"deviation", &Speed::deviation, {"its standard deviation", "m/s", 0, 100}},
      Member{"maximum", &Speed::maximum, {"nobody is faster; 1.3 times each one's wish when absent", "m/s", 0, 100}}};
};

constexpr double kLongest = 1e7;  ///< seconds, a third of a year

template <>
struct Table<Body> {
  static constexpr std::tuple members{
      Member{"radius", &Body::radius, {"half a person's width; [low, high]: evenly spread", "m", 0.01, 100}},
      Member{"mass", &Body::mass, {"mass of a person relative to the others", "", 1e-6, 1e6}},
      Member{"speed", &Body::speed, {"desired speed"}},
      Member{"goal", &Body::goal, {"goals one after the other; of several in brackets, the nearest"}}};
};

template <>
struct Table<Population> {
  static constexpr std::tuple members = std::tuple_cat(
      std::tuple{
          Member{"id", &Population::id, {"unique name among populations"}},
          Member{"count", &Population::count, {"how many; one on every point of the grid when absent", "", 0, 1e7}},
          Member{"area", &Population::area, {"where they are at first", "m", -kMetres, kMetres, true}},
          Member{"spacing",
                 &Population::spacing,
                 {"side of the square grid they stand on; at random when absent", "m", 0.01, 1e4}},
          Member{"jitter", &Population::jitter, {"each coordinate moved by up to this much either way", "m", 0, 1e4}},
          Member{
              "walking", &Population::walking, {"start as fast as they like, towards their goal; at rest when false"}}},
      Table<Body>::members);
  static constexpr std::array<std::string_view, 2> needs_one_of = {"count", "spacing"};
  static constexpr std::array only_with = {OnlyWith{"jitter", "spacing"}};
};

template <>
struct Table<Source> {
  static constexpr std::tuple members = std::tuple_cat(
      std::tuple{
          Member{"id", &Source::id, {"unique name among sources"}},
          Member{"area", &Source::area, {"where people appear", "m", -kMetres, kMetres, true}},
          Member{"rate", &Source::rate, {"how many appear", "1/s", 0, 1e6}},
          Member{"arrivals", &Source::arrivals, {"evenly, or at random (Poisson)", "", 0, 0, false, "even|poisson"}},
          Member{"from", &Source::from, {"nobody appears before", "s", 0, kLongest}},
          Member{"until", &Source::until, {"nobody appears after; never ends when absent", "s", 0, kLongest}},
          Member{"count", &Source::count, {"not more than so many in all", "", 0, 1e7}}},
      Table<Body>::members);
};

template <>
struct Table<Goal> {
  static constexpr std::tuple members{
      Member{"id", &Goal::id, {"unique name among goals", "", 0, 0, true}},
      Member{"area", &Goal::area, {"reached on entering it", "m", -kMetres, kMetres}},
      Member{"aim",
             &Goal::aim,
             {"what they head for until they are in the area; itself when absent", "m", -kMetres, kMetres}},
      Member{"direction", &Goal::direction, {"this way for ever, counter-clockwise from +x", "rad", -kTurn, kTurn}},
      Member{"offset", &Goal::offset, {"so far from where each one started", "m", -kMetres, kMetres}},
      Member{
          "jitter", &Goal::jitter, {"each coordinate of an offset moved by up to this much either way", "m", 0, 1e4}},
      Member{"wait", &Goal::wait, {"stays there so long before going on", "s", 0, kLongest}},
      Member{"absorb", &Goal::absorb, {"who arrives at the end of a route leaves the scene"}}};
  static constexpr std::array<std::string_view, 3> exactly_one_of = {"area", "direction", "offset"};
  static constexpr std::array only_with = {OnlyWith{"aim", "area"}, OnlyWith{"jitter", "offset"}};
};

template <>
struct Table<Crowd> {
  static constexpr std::tuple members{
      Member{"populations", &Crowd::populations, {"people who are there at first"}},
      Member{"sources", &Crowd::sources, {"places where people appear"}},
      Member{"goals", &Crowd::goals, {"places where people want to be"}},
      Member{"model", &Crowd::model, {"how they walk; pbd with its preset pedestrian when absent"}},
      Member{
          "planner", &Crowd::planner, {"how they find their way", "", 0, 0, false, "automatic|straight|paths|field"}},
      Member{"step", &Crowd::step, {"of time", "s", 1e-4, 1}},
      Member{"seconds", &Crowd::seconds, {"how long a simulation runs when nobody says", "s", 1e-3, kLongest}}};
};

/// What the members that a document does not say have: T{}, and a preset's values where there are presets.
template <class T>
T default_like(const T&) {
  return {};
}
inline PbdModel default_like(const PbdModel& model) {
  return PbdModel::of_preset(static_cast<PbdModel::Preset>(model.preset));
}
/// The preset of a model that does not say one: what a scene without a model has, too.
constexpr auto kUsualPreset = PbdModel::Preset::pedestrian;

template <>
struct Table<Scene> {
  static constexpr std::tuple members{
      Member{"name", &Scene::name, {"title of the scene"}},
      Member{"space", &Scene::space, {"the room", "", 0, 0, true}},
      Member{"objects", &Scene::objects, {"what stands in it"}},
      Member{"groups", &Scene::groups, {"what belongs together"}},
      Member{"constraints", &Scene::constraints, {"the rules of the arrangement"}},
      Member{"house_rules",
             &Scene::house_rules,
             {"the constraints are the usual ones by kind, wishes that an arrangement may miss"}},
      Member{"crowd", &Scene::crowd, {"the people in it"}},
      Member{"seed", &Scene::seed, {"the source of every random choice", "", 0, 1.8446744073709552e19}}};
};

constexpr std::string_view kFormatName = "inhabit-scene";
constexpr int kFormatVersion = 1;

/// Degrees as files have them: rounded to 1e-9, so that reading what was written gives the same radians.
inline double file_degrees(double radians) { return std::round(degrees(radians) * 1e9) / 1e9; }
/// A bound of a Spec in the units of a file.
inline double file_bound(const Spec& spec, double bound) { return spec.unit == "rad" ? file_degrees(bound) : bound; }
inline std::string_view file_unit(const Spec& spec) { return spec.unit == "rad" ? "degrees" : spec.unit; }

/// The names in "a|b|c".
inline std::vector<std::string_view> split_choices(std::string_view choices) {
  std::vector<std::string_view> names;
  for (std::size_t at = 0; at <= choices.size();) {
    const std::size_t bar = std::min(choices.find('|', at), choices.size());
    names.push_back(choices.substr(at, bar - at));
    at = bar + 1;
  }
  return names;
}

}  // namespace inhabit::io
