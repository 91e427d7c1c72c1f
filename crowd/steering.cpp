#include "crowd/steering.h"

#include <cmath>

namespace inhabit::crowd {
namespace {

/// Pushes out of one wall after the other; two are a corner, more a pocket between corners.
constexpr int kPushes = 6;
/// Metres: discs may be so far inside a wall, by the rounding of floats.
constexpr double kTouch = 1e-5;

/// How deep a disc that came from `from` is inside a wall (negative: clear of it), and the way out.
struct Entry {
  double depth = -1;
  Vec2 out;
};

Entry entry_into(const WallSegment& wall, Vec2 from, Vec2 to, double radius) {
  const Vec2 a{wall.ax, wall.ay}, b{wall.bx, wall.by}, along = b - a;
  // People are on the left of walls: one that is seen from behind is the far side of something thin.
  if (cross(along, from - a) < 0) return {};
  const Vec2 nearest = nearest_on_segment(a, b, to), apart = to - nearest;
  const double distance = length(apart);
  const double t = dot(to - a, along), inside = dot(along, along);
  if ((cross(along, to - a) < 0 || distance == 0) && t > 0 && t < inside)
    return {radius + distance, unit(perp(along))};  // the centre went through
  if (distance == 0) return {radius, unit(perp(along))};
  return {radius - distance, (1 / distance) * apart};
}

Entry deepest_entry(const Walls& walls, Vec2 from, Vec2 to, double radius) {
  Entry deepest;
  walls.for_each_near(static_cast<float>(to.x), static_cast<float>(to.y), [&](const WallSegment& wall, std::uint32_t) {
    const Entry entry = entry_into(wall, from, to, radius);
    if (entry.depth > deepest.depth) deepest = entry;
  });
  return deepest;
}

}  // namespace

Vec2 moved_among_walls(const Walls& walls, Vec2 from, Vec2 to, double radius) {
  if (walls.empty()) return to;
  Entry entry = deepest_entry(walls, from, to, radius);
  for (int k = 0; k < kPushes && entry.depth > kTouch; ++k) {
    to += entry.depth * entry.out;
    entry = deepest_entry(walls, from, to, radius);
  }
  if (entry.depth <= kTouch) return to;
  // No room. Whoever stood deeper before may come out; nobody goes deeper.
  const bool better = entry.depth < deepest_entry(walls, from, from, radius).depth &&
                      walls.on_floor(static_cast<float>(to.x), static_cast<float>(to.y));
  return better ? to : from;
}

void NextMoment::set(const Agents& now, std::size_t i, Vec2 v, const Walls& walls, double dt, double core) {
  const Vec2 from = position(now, i) + lost_[i], most = limited(v, now.maximum_speed[i]), free = from + dt * most;
  const Vec2 to = moved_among_walls(walls, from, free, core * now.radius[i]);
  const Vec2 had = to == free ? most : limited((1 / dt) * (to - from), now.maximum_speed[i]);
  x_[i] = static_cast<float>(to.x), y_[i] = static_cast<float>(to.y);
  lost_[i] = to - Vec2{x_[i], y_[i]};
  vx_[i] = static_cast<float>(had.x), vy_[i] = static_cast<float>(had.y);
}

}  // namespace inhabit::crowd
