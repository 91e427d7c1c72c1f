#include "geometry/polygon.h"

#include <string>

#include "geometry/geos.h"

namespace inhabit::geometry {

double signed_area(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // Relative to the first corner, so that plans in national grids keep their digits.
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return twice / 2;
}

Vec2 centroid(std::span<const Vec2> ring) {
  Vec2 sum;
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    const double w = cross(a, b);
    twice += w;
    sum += w * (a + b);
  }
  return twice != 0 ? ring[0] + (1 / (3 * twice)) * sum : ring[0];
}

bool contains(std::span<const Vec2> ring, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double side = cross(b - a, p - a);
    if (side == 0 && dot(p - a, p - b) <= 0) return true;
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

Nearest nearest_on_ring(std::span<const Vec2> ring, Vec2 p) {
  Nearest best{ring[0], 1e300, 0};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 q = nearest_on_segment(ring[i], ring[(i + 1) % ring.size()], p);
    const double d = dot(p - q, p - q);
    if (d < best.distance) best = {q, d, i};
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

Bounds bounds(std::span<const Vec2> ring) {
  Bounds b;
  for (const Vec2 p : ring) b.add(p);
  return b;
}

Ring clipped(Ring ring, std::span<const Vec2> convex) {
  Ring out;
  for (std::size_t k = 0; k < convex.size() && !ring.empty(); ++k) {
    const Vec2 a = convex[k], e = convex[(k + 1) % convex.size()] - a;
    out.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 p = ring[i], q = ring[(i + 1) % ring.size()];
      const double sp = cross(e, p - a), sq = cross(e, q - a);
      if (sp >= 0) out.push_back(p);
      if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) out.push_back(p + (sp / (sp - sq)) * (q - p));
    }
    ring.swap(out);
  }
  return ring;
}

double overlap_area(std::span<const Vec2> ring, std::span<const Vec2> convex) {
  const Ring in = clipped({ring.begin(), ring.end()}, convex);
  return in.size() < 3 ? 0 : std::abs(signed_area(in));
}

double overlap_area(const Box& box, std::span<const Vec2> convex) { return overlap_area(box.corners(), convex); }

std::optional<std::string> why_not_simple(std::span<const Vec2> ring) {
  if (ring.size() < 3) return "an outline needs at least three corners, this one has " + std::to_string(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == ring[(i + 1) % ring.size()])
      return "corners " + std::to_string(i) + " and " + std::to_string((i + 1) % ring.size()) + " are the same point";
  }
  const Geos geos;
  const Geos::Shape polygon = geos.raw_polygon(ring);
  if (!polygon) return "is no ring";
  char* reason = nullptr;
  GEOSGeometry* place = nullptr;
  const char valid = GEOSisValidDetail_r(geos.get(), polygon.get(), 0, &reason, &place);
  const Geos::Shape at = geos.own(place);
  std::optional<std::string> answer;
  if (valid != 1) {
    answer = reason != nullptr ? std::string(reason) : "is no simple polygon";
    double x = 0, y = 0;
    if (at && GEOSGeomGetX_r(geos.get(), at.get(), &x) == 1 && GEOSGeomGetY_r(geos.get(), at.get(), &y) == 1)
      answer = "the outline touches or crosses itself near (" + std::to_string(x) + ", " + std::to_string(y) + ")";
  } else if (std::abs(signed_area(ring)) < 1e-9) {
    answer = "the outline encloses no area";
  }
  if (reason != nullptr) GEOSFree_r(geos.get(), reason);
  return answer;
}

}  // namespace inhabit::geometry
