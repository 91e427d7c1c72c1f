#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/box.h"

namespace inhabit::geometry {

/// A closed ring of corners, not repeated at the end. Side k joins corner k to corner k + 1.
using Ring = std::vector<Vec2>;

/// Positive for a counter-clockwise ring, square metres.
double signed_area(std::span<const Vec2> ring);
/// Centre of the area (not of the corners). Requires: area > 0.
Vec2 centroid(std::span<const Vec2> ring);
/// True inside and on the border.
bool contains(std::span<const Vec2> ring, Vec2 p);

/// Why a ring is no simple polygon: fewer than three corners, a repeated corner, crossing or touching sides, no area.
/// Nothing when it is one. Cost O(n log n) through GEOS for long rings.
std::optional<std::string> why_not_simple(std::span<const Vec2> ring);

struct Nearest {
  Vec2 point;
  double distance = 0;
  std::size_t side = 0;
};
/// The point of the segment ab nearest to p.
inline Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 d = b - a;
  const double dd = dot(d, d);
  const double t = dd > 0 ? std::clamp(dot(p - a, d) / dd, 0.0, 1.0) : 0;
  return a + t * d;
}
/// The nearest point of the ring's sides; ties go to the first side. Requires: at least one corner.
Nearest nearest_on_ring(std::span<const Vec2> ring, Vec2 p);

struct Bounds {
  Vec2 min{1e300, 1e300}, max{-1e300, -1e300};
  void add(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  Vec2 size() const { return max - min; }
  Vec2 center() const { return 0.5 * (min + max); }
};
Bounds bounds(std::span<const Vec2> ring);

/// The part of `ring` that lies in the convex, counter-clockwise ring (Sutherland-Hodgman clipping). Where it falls
/// into several pieces, they are joined by sides of no area along the convex ring, so that its area is right all the
/// same.
Ring clipped(Ring ring, std::span<const Vec2> convex);
/// Area of the part of `ring` that lies in the convex, counter-clockwise ring.
double overlap_area(std::span<const Vec2> ring, std::span<const Vec2> convex);
double overlap_area(const Box& box, std::span<const Vec2> convex);
/// Area that two boxes share.
inline double overlap_area(const Box& a, const Box& b) {
  const auto c = b.corners();
  return overlap_area(a, c);
}

}  // namespace inhabit::geometry
