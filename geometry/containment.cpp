#include "geometry/containment.h"

#include <utility>

namespace inhabit::geometry {
namespace {

bool inside(const Bounds& b, Vec2 p) { return p.x >= b.min.x && p.x <= b.max.x && p.y >= b.min.y && p.y <= b.max.y; }

/// The deepest poke of a ring's sides into the box; sets `near` when the bounds of some side meet those of the box.
double ring_poke(std::span<const Vec2> ring, const Box& box, const Bounds& reach, bool& near) {
  double deepest = 0;
  Vec2 a = ring.back();
  for (const Vec2 b : ring) {
    const bool apart = std::max(a.x, b.x) < reach.min.x || std::min(a.x, b.x) > reach.max.x ||
                       std::max(a.y, b.y) < reach.min.y || std::min(a.y, b.y) > reach.max.y;
    if (!apart) {
      near = true;
      deepest = std::max(deepest, poke_depth(box, a, b));
    }
    a = b;
  }
  return deepest;
}

}  // namespace

Floor make_floor(Ring outline, std::vector<Ring> holes) {
  Floor floor{std::move(outline), std::move(holes), {}, {}};
  floor.outline_bounds = bounds(floor.outline);
  for (const Ring& hole : floor.holes) floor.hole_bounds.push_back(bounds(hole));
  return floor;
}

double area(const Floor& floor) {
  double sum = std::abs(signed_area(floor.outline));
  for (const Ring& hole : floor.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double outside_distance(const Floor& floor, Vec2 p) {
  if (!inside(floor.outline_bounds, p) || !contains(std::span<const Vec2>(floor.outline), p))
    return nearest_on_ring(floor.outline, p).distance;
  double deepest = 0;
  for (std::size_t i = 0; i < floor.holes.size(); ++i) {
    if (inside(floor.hole_bounds[i], p) && contains(std::span<const Vec2>(floor.holes[i]), p))
      deepest = std::max(deepest, nearest_on_ring(floor.holes[i], p).distance);
  }
  return deepest;
}

bool contains(const Floor& floor, Vec2 p) {
  // A point on a hole's border is both in the hole's closure and on the floor: its distance is 0.
  if (!inside(floor.outline_bounds, p) || !contains(std::span<const Vec2>(floor.outline), p)) return false;
  for (std::size_t i = 0; i < floor.holes.size(); ++i) {
    if (inside(floor.hole_bounds[i], p) && contains(std::span<const Vec2>(floor.holes[i]), p) &&
        nearest_on_ring(floor.holes[i], p).distance > 0)
      return false;
  }
  return true;
}

double poke_depth(const Box& box, Vec2 a, Vec2 b) {
  const Vec2 p = rotate_back(a - box.center, box.front), d = rotate_back(b - a, box.front);
  // Distance to the four faces along the segment, value + slope * t; their minimum is concave in t, so its maximum lies
  // at an end or where two of them cross.
  const std::array<double, 4> value = {box.half_depth - p.x, box.half_depth + p.x, box.half_width - p.y,
                                       box.half_width + p.y};
  const std::array<double, 4> slope = {-d.x, d.x, -d.y, d.y};
  double deepest = 0;
  const auto try_at = [&](double t) {
    double depth = value[0] + slope[0] * t;
    for (std::size_t i = 1; i < 4; ++i) depth = std::min(depth, value[i] + slope[i] * t);
    deepest = std::max(deepest, depth);
  };
  try_at(0), try_at(1);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double ds = slope[i] - slope[j];
      if (ds == 0) continue;
      const double t = (value[j] - value[i]) / ds;
      if (t > 0 && t < 1) try_at(t);
    }
  }
  return deepest;
}

Bounds bounds(const Box& box) {
  const Vec2 half{box.extent({1, 0}), box.extent({0, 1})};
  return {box.center - half, box.center + half};
}

double outside_depth(const Floor& floor, const Box& box) {
  const Bounds reach = bounds(box);
  bool near = false;
  double depth = ring_poke(floor.outline, box, reach, near);
  for (std::size_t i = 0; i < floor.holes.size(); ++i) {
    if (meet(floor.hole_bounds[i], reach)) depth = std::max(depth, ring_poke(floor.holes[i], box, reach, near));
  }
  depth = std::max(depth, outside_distance(floor, box.center));
  // Without a side near the box, all of it is where its centre is; it still has to say how far out its corners are.
  if (!near && depth == 0) return 0;
  for (const Vec2 corner : box.corners()) depth = std::max(depth, outside_distance(floor, corner));
  return depth;
}

}  // namespace inhabit::geometry
