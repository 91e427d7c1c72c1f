#include "session/prior_scene.h"

#include <algorithm>

#include "session/scene_builder.h"

namespace inhabit::session {
namespace {

/// Stiffness and weight of a wish that may give way; what stands at its wall is held as the house rules hold it.
constexpr double kWish = 0.5, kWeak = 0.3, kAtWall = 0.25;
/// Metres: a mean of distances that are farther spread says nothing.
constexpr double kSpread = 0.4;

template <class T>
T soft(T constraint, double stiffness, double weight) {
  constraint.stiffness = stiffness, constraint.weight = weight;
  return constraint;
}

Ref object_ref(std::uint32_t i) { return {Ref::Kind::object, i}; }

void add_wall(Scene& scene, std::uint32_t i, const annealing::ObjectTarget& target) {
  const Object& o = scene.objects[i];
  WallDistance distance;
  WallOrientation turn;
  distance.members = turn.members = list_of({object_ref(i)});
  if (target.mount == Mount::wall) {
    scene.constraints.add(distance);
    scene.constraints.add(turn);
    return;
  }
  if (!target.wall || target.carrier != annealing::kNobody) return;
  const WallMode& mode = *target.wall;
  // The constraint measures from the object's own back face; the prior from the face that stood to the wall.
  constexpr std::array kTurns = {0.0, -kPi / 2, kPi, kPi / 2};
  const double back_turn = kTurns[static_cast<std::size_t>(target.back)];
  const bool side = target.back == Face::left || target.back == Face::right;
  const double half = side ? o.size.x / 2 : o.size.y / 2;
  const double heading = wrap_angle(mode.angle - back_turn);
  distance.distance = std::max(0.0, mode.distance + half * std::cos(mode.angle) - o.size.y / 2 * std::cos(heading));
  turn.angle = heading;
  const bool at_wall = mode.distance <= kAtWall;
  if (mode.distance_deviation <= kSpread) scene.constraints.add(at_wall ? distance : soft(distance, kWeak, 1));
  if (annealing::angle_strength(mode.angle_deviation) > 0.5)
    scene.constraints.add(at_wall ? turn : soft(turn, kWish, 1));
}

void add_pair(Scene& scene, const annealing::PairTarget& pair) {
  const Ref first = object_ref(pair.first), second = object_ref(pair.second);
  if (!pair.concentric && annealing::angle_strength(pair.mode.bearing_deviation) > 0.5) {
    HeatPoint place;
    place.members = list_of({second}), place.on = first;
    place.point = pair.mode.distance * direction(pair.mode.bearing);
    scene.constraints.add(soft(place, kWish, 1));
  } else {
    Distance apart;
    apart.between = {first, second}, apart.distance = pair.mode.distance;
    scene.constraints.add(soft(apart, kWish, 1));
  }
  if (annealing::angle_strength(pair.mode.facing_deviation) > 0.5) {
    Orientation facing;
    facing.members = list_of({second}), facing.to = first, facing.angle = pair.mode.facing;
    scene.constraints.add(soft(facing, kWish, 1));
  } else {
    // Bound to each other all the same: one may stand in the other's free space.
    Distance near;
    near.between = {first, second}, near.max = 2 * pair.mode.distance;
    scene.constraints.add(soft(near, kWish, 1));
  }
}

bool has_view_constraint(const Scene& scene, std::uint32_t i) {
  return std::ranges::any_of(scene.constraints.of<Visibility>(), [&](const Visibility& v) {
    return std::ranges::find(v.members.list, object_ref(i)) != v.members.list.end();
  });
}

}  // namespace

Scene with_targets(const Scene& original, const annealing::Targets& targets) {
  Scene scene = original;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    Object& o = scene.objects[i];
    const annealing::ObjectTarget& target = targets.objects[i];
    if (!o.clearance.any()) {
      const auto& depth = target.access;
      o.clearance = {.front = depth[2], .back = depth[0], .left = depth[1], .right = depth[3]};
    }
    if (!o.view) o.view = target.view;
    if (o.mount == Mount::floor && target.mount != Mount::floor) {
      o.mount = target.mount;
      if (!o.position && !o.elevation && target.prior != nullptr && target.prior->elevation > 0)
        o.elevation = target.prior->elevation;
    }
    if (o.on.none() && target.carrier != annealing::kNobody) o.on = object_ref(target.carrier);
    if (o.fixed) continue;
    add_wall(scene, i, target);
    if (o.view && !has_view_constraint(scene, i)) {
      Visibility view;
      view.members = list_of({object_ref(i)});
      scene.constraints.add(view);
    }
  }
  for (const annealing::PairTarget& pair : targets.pairs) add_pair(scene, pair);
  scene.house_rules = scene.house_rules || scene.constraints.size() > original.constraints.size();
  return scene;
}

void add_path_zones(Scene& scene, std::span<const annealing::BezierCurve> paths, double width) {
  // What hangs higher than people are, or is fixed, is in nobody's way.
  std::vector<Ref> members;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].mount == Mount::floor && !scene.objects[i].fixed && scene.objects[i].on.none())
      members.push_back(object_ref(i));
  if (members.empty()) return;
  for (const annealing::BezierCurve& path : paths) {
    for (const Box& part : annealing::path_boxes(path, width)) {
      KeepOut zone;
      zone.members = list_of(members);
      const auto corners = part.corners();
      zone.polygon.assign(corners.begin(), corners.end());
      scene.constraints.add(zone);
    }
  }
}

std::vector<annealing::BezierCurve> empty_room_paths(const Scene& scene, std::uint64_t seed, double width) {
  Scene empty;
  empty.space = scene.space;
  annealing::Options options;
  options.seed = seed, options.threads = 1, options.path_width = width, options.iterations = 4000, options.hot = 0.3;
  const auto outcome = annealing::arrange(empty, {}, options);
  return outcome ? outcome->best.paths : std::vector<annealing::BezierCurve>{};
}

}  // namespace inhabit::session
