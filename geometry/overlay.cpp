#include "geometry/overlay.h"

#include <algorithm>

#include "geometry/geos.h"

namespace inhabit::geometry {
namespace {

/// Counter-clockwise and without corners that do not turn; empty when nothing simple remains.
Ring tidy(Ring ring, double tolerance) {
  bool changed = true;
  while (changed && ring.size() >= 3) {
    changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;) {
      const Vec2 before = ring[(i + ring.size() - 1) % ring.size()], after = ring[(i + 1) % ring.size()];
      const Vec2 near = nearest_on_segment(before, after, ring[i]);
      if (length(ring[i] - near) <= tolerance || ring[i] == after) {
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i)), changed = true;
      } else {
        ++i;
      }
    }
  }
  if (ring.size() < 3 || why_not_simple(ring)) return {};
  if (signed_area(ring) < 0) std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

void collect(const Geos& geos, const GEOSGeometry* g, double tolerance, std::vector<Area>& areas) {
  if (g == nullptr || GEOSisEmpty_r(geos.get(), g) != 0) return;
  const int type = GEOSGeomTypeId_r(geos.get(), g);
  if (type == GEOS_POLYGON) {
    const Ring raw = geos.corners(GEOSGetExteriorRing_r(geos.get(), g));
    Area area{tidy(raw, tolerance), {}};
    if (area.outline.empty()) area.outline = tidy(raw, 0);
    if (area.outline.empty()) return;
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos.get(), g); ++i) {
      Ring hole = tidy(geos.corners(GEOSGetInteriorRingN_r(geos.get(), g, i)), tolerance);
      if (!hole.empty()) area.holes.push_back(std::move(hole));
    }
    areas.push_back(std::move(area));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(geos.get(), g); ++i)
      collect(geos, GEOSGetGeometryN_r(geos.get(), g, i), tolerance, areas);
  }
}

Geos::Shape shape_of(const Geos& geos, const Area& area) {
  Geos::Shape shape = geos.polygon(area.outline);
  for (const Ring& hole : area.holes) {
    if (const Geos::Shape h = geos.polygon(hole)) shape = geos.minus(shape, h);
  }
  return shape;
}

Geos::Shape united(const Geos& geos, std::span<const Ring> rings) {
  std::vector<Geos::Shape> parts;
  for (const Ring& ring : rings) parts.push_back(geos.polygon(ring));
  return geos.united(std::move(parts));
}

std::vector<Area> areas_of(const Geos& geos, const Geos::Shape& shape, double tolerance) {
  std::vector<Area> areas;
  collect(geos, shape.get(), tolerance, areas);
  std::ranges::stable_sort(areas, std::ranges::greater{},
                           [](const Area& a) { return std::abs(signed_area(a.outline)); });
  return areas;
}

}  // namespace

double Area::size() const {
  double sum = std::abs(signed_area(outline));
  for (const Ring& hole : holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double area_outside(std::span<const Vec2> ring, std::span<const Vec2> outline) {
  const Geos geos;
  return geos.area(geos.minus(geos.polygon(ring), geos.polygon(outline)));
}

std::vector<Area> difference(const std::vector<Area>& areas, std::span<const Ring> taken, double tolerance) {
  const Geos geos;
  std::vector<Geos::Shape> kept;
  for (const Area& area : areas) kept.push_back(shape_of(geos, area));
  return areas_of(geos, geos.minus(geos.united(std::move(kept)), united(geos, taken)), tolerance);
}

std::vector<Area> intersection(const std::vector<Area>& areas, std::span<const Vec2> ring, double tolerance) {
  const Geos geos;
  std::vector<Geos::Shape> parts;
  for (const Area& area : areas) parts.push_back(shape_of(geos, area));
  const Geos::Shape all = parts.size() == 1 ? std::move(parts.front()) : geos.united(std::move(parts));
  const Geos::Shape cut = geos.polygon(ring);
  if (!all || !cut) return {};
  return areas_of(geos, geos.own(GEOSIntersection_r(geos.get(), all.get(), cut.get())), tolerance);
}

std::vector<Area> smooth_difference(std::span<const Vec2> subject, std::span<const Ring> taken, double sliver) {
  const Geos geos;
  Geos::Shape shape = geos.minus(geos.polygon(subject), united(geos, taken));
  // In, out twice, in again: opening drops spikes, closing drops notches.
  for (const double step : {-sliver, 2 * sliver, -sliver}) shape = geos.buffer(shape, step);
  return areas_of(geos, shape, sliver / 10);
}

bool overlap_deeper(std::span<const Vec2> a, std::span<const Ring> b, double depth) {
  const Geos geos;
  const Geos::Shape shape = geos.polygon(a), other = united(geos, b);
  if (!shape || !other) return false;
  const Geos::Shape shared = geos.own(GEOSIntersection_r(geos.get(), shape.get(), other.get()));
  const Geos::Shape core = geos.buffer(shared, -depth);
  return core && GEOSisEmpty_r(geos.get(), core.get()) == 0;
}

}  // namespace inhabit::geometry
