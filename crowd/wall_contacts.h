#pragma once
#include "crowd/walls.h"

namespace inhabit::crowd {

/// Calls f(point) for each wall that (x, y) faces, with the wall's point nearest to it: the foot of the perpendicular
/// on a segment of which it is on the left, or a corner that sticks out towards it, once however many segments meet
/// there. A straight wall in pieces is one wall, and the far side of something thin is none. In order of the segments'
/// indices. Cost: the number of segments near, squared only for those that end near.
template <class F>
void for_each_facing_wall(const Walls& walls, float x, float y, F&& f) {
  const auto ends = [&](float px, float py, auto&& is_at) {
    for (const std::uint32_t k : walls.near(x, y))
      if (is_at(walls.segments()[k], px, py)) return &walls.segments()[k];
    return static_cast<const WallSegment*>(nullptr);
  };
  walls.for_each_near(x, y, [&](const WallSegment& s, std::uint32_t) {
    const Vec2 a{s.ax, s.ay}, along = Vec2{s.bx, s.by} - a, from_a = Vec2{x, y} - a;
    const double t = dot(along, from_a);
    if (t <= 0) {
      // Corner a is nearest. It belongs to the segment before this one too, which may have a nearer point.
      const WallSegment* before = ends(s.ax, s.ay, [](const WallSegment& other, float px, float py) {
        return other.bx == px && other.by == py && (other.ax != px || other.ay != py);
      });
      if (before != nullptr) {
        const Vec2 b{before->ax, before->ay};
        if (dot(a - b, Vec2{x, y} - b) < dot(a - b, a - b)) return;
      }
      f(a);
    } else if (t >= dot(along, along)) {
      // Corner b is nearest: the segment after this one speaks for it, when there is one.
      const WallSegment* after = ends(s.bx, s.by, [](const WallSegment& other, float px, float py) {
        return other.ax == px && other.ay == py && (other.bx != px || other.by != py);
      });
      if (after == nullptr) f(a + along);
    } else if (cross(along, from_a) >= 0) {
      f(a + (t / dot(along, along)) * along);
    }
  });
}

}  // namespace inhabit::crowd
