#pragma once
#include <algorithm>
#include <array>

#include "geometry/vec2.h"

namespace inhabit::geometry {

/// An oriented rectangle on the ground. `front` is the unit vector that its front face looks along; `half_depth` is
/// measured along it, `half_width` across it.
struct Box {
  Vec2 center;
  Vec2 front{1, 0};
  double half_depth = 0, half_width = 0;

  constexpr Vec2 left() const { return perp(front); }
  /// Back-right, front-right, front-left, back-left: counter-clockwise.
  constexpr std::array<Vec2, 4> corners() const {
    const Vec2 f = half_depth * front, l = half_width * left();
    return {center - f - l, center + f - l, center + f + l, center - f + l};
  }
  constexpr double area() const { return 4 * half_depth * half_width; }
  double radius() const { return std::sqrt(half_depth * half_depth + half_width * half_width); }
  constexpr bool contains(Vec2 p) const {
    const Vec2 d = rotate_back(p - center, front);
    return d.x >= -half_depth && d.x <= half_depth && d.y >= -half_width && d.y <= half_width;
  }
  /// Half the extent along the unit vector n.
  double extent(Vec2 n) const { return half_depth * std::abs(dot(front, n)) + half_width * std::abs(dot(left(), n)); }
};

/// The box of an object of `size` = (width across the front, depth front to back, height) at `pose`.
inline Box make_box(const Pose& pose, Vec3 size) { return {pose.p, direction(pose.angle), size.y / 2, size.x / 2}; }

/// How to part two boxes: `depth` metres along the unit vector `normal`, which points from b to a.
/// depth <= 0 means that they are apart (a lower bound of the gap, negated).
struct Separation {
  Vec2 normal{1, 0};
  double depth = 0;
};

/// Minimum translation between two oriented boxes by the separating-axis test over their four face normals. Ties go to
/// the first axis: a's front, a's left, b's front, b's left. Boxes with the same centre are parted along the positive
/// axis.
inline Separation separation(const Box& a, const Box& b) {
  const Vec2 d = a.center - b.center;
  // In a's frame: b's axes seen from a.
  const double c = dot(a.front, b.front), s = cross(a.front, b.front);
  const double ac = std::abs(c), as = std::abs(s);
  const double da_f = dot(d, a.front), da_l = dot(d, a.left());
  const double o0 = a.half_depth + b.half_depth * ac + b.half_width * as - std::abs(da_f);
  const double o1 = a.half_width + b.half_depth * as + b.half_width * ac - std::abs(da_l);
  // Most neighbours are apart, and most of those along one of a's axes.
  if (o0 <= 0 || o1 <= 0) return {{1, 0}, std::min(o0, o1)};
  const double db_f = dot(d, b.front), db_l = dot(d, b.left());
  const double o2 = b.half_depth + a.half_depth * ac + a.half_width * as - std::abs(db_f);
  const double o3 = b.half_width + a.half_depth * as + a.half_width * ac - std::abs(db_l);
  Separation r{da_f < 0 ? -a.front : a.front, o0};
  if (o1 < r.depth) r = {da_l < 0 ? -a.left() : a.left(), o1};
  if (o2 < r.depth) r = {db_f < 0 ? -b.front : b.front, o2};
  if (o3 < r.depth) r = {db_l < 0 ? -b.left() : b.left(), o3};
  return r;
}

}  // namespace inhabit::geometry
