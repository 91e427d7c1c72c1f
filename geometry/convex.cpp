#include "geometry/convex.h"

#include <algorithm>

#include "geometry/geos.h"

namespace inhabit::geometry {

Separation separation(const Box& box, std::span<const Vec2> convex) {
  Separation best{{1, 0}, 1e300};
  // Axes of the ring: its outward side normals. The box lies beyond a side when its nearest extent does.
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 a = convex[i], b = convex[(i + 1) % convex.size()];
    const Vec2 out = -perp(unit(b - a));
    const double depth = box.extent(out) - dot(box.center - a, out);
    if (depth < best.depth) best = {out, depth};
  }
  for (const bool along : {true, false}) {
    const Vec2 axis = along ? box.front : box.left();
    double low = 1e300, high = -1e300;
    for (const Vec2 p : convex) {
      const double t = dot(p - box.center, axis);
      low = std::min(low, t), high = std::max(high, t);
    }
    const double e = along ? box.half_depth : box.half_width;
    // Along +axis the box is free when its low face passes `high`, along -axis when its high face passes `low`.
    if (high + e < best.depth) best = {axis, high + e};
    if (e - low < best.depth) best = {-axis, e - low};
  }
  return best;
}

bool is_convex(std::span<const Vec2> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (cross(b - a, c - b) < -1e-12 * (1 + dot(b - a, b - a))) return false;
  }
  return true;
}

Ring counter_clockwise(Ring ring) {
  if (signed_area(ring) < 0) std::ranges::reverse(ring);
  return ring;
}

namespace {

/// Joins `b` to `a` along a shared side when the union is convex.
bool join(Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 p = a[i], q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (b[j] != q || b[(j + 1) % b.size()] != p) continue;
      Ring merged;
      for (std::size_t k = 1; k <= a.size(); ++k) merged.push_back(a[(i + k) % a.size()]);
      for (std::size_t k = 2; k < b.size(); ++k) merged.push_back(b[(j + k) % b.size()]);
      if (!is_convex(merged)) return false;
      a = std::move(merged);
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Ring> convex_parts(std::span<const Vec2> ring) {
  const Ring whole = counter_clockwise({ring.begin(), ring.end()});
  if (is_convex(whole)) return {whole};
  const Geos geos;
  const Geos::Shape polygon = geos.raw_polygon(whole);
  const Geos::Shape triangles = geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.get(), polygon.get()));
  std::vector<Ring> parts;
  const int count = triangles ? GEOSGetNumGeometries_r(geos.get(), triangles.get()) : 0;
  for (int t = 0; t < count; ++t) {
    const GEOSGeometry* triangle = GEOSGetGeometryN_r(geos.get(), triangles.get(), t);
    Ring corners = geos.corners(GEOSGetExteriorRing_r(geos.get(), triangle));
    if (corners.size() == 3) parts.push_back(counter_clockwise(std::move(corners)));
  }
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = 0; i < parts.size() && !joined; ++i) {
      for (std::size_t j = i + 1; j < parts.size() && !joined; ++j) {
        joined = join(parts[i], parts[j]);
        if (joined) parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
      }
    }
  }
  return parts.empty() ? std::vector<Ring>{whole} : parts;
}

Ring convex_hull(std::vector<Vec2> points) {
  std::ranges::sort(points, {}, [](Vec2 p) { return std::pair(p.x, p.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring ring;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = ring.size();
    for (const Vec2 p : points) {
      while (ring.size() >= base + 2 && cross(ring.back() - ring[ring.size() - 2], p - ring.back()) <= 0)
        ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
    std::ranges::reverse(points);
  }
  return ring;
}

}  // namespace inhabit::geometry
