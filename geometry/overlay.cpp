#include "geometry/overlay.h"

#include <geos_c.h>

#include <algorithm>
#include <memory>

namespace inhabit::geometry {
namespace {

/// GEOS objects of one call, freed together with their context.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {}
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() {
    for (GEOSGeometry* g : owned_) GEOSGeom_destroy_r(handle_, g);
    GEOS_finish_r(handle_);
  }
  GEOSContextHandle_t handle() const { return handle_; }
  /// Takes charge of `g`, which may be null: then the operation failed and everything that follows is null too.
  GEOSGeometry* own(GEOSGeometry* g) {
    if (g != nullptr) owned_.push_back(g);
    return g;
  }
  GEOSGeometry* ring(std::span<const Vec2> corners) {
    if (corners.size() < 3) return nullptr;
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle_, static_cast<unsigned>(corners.size() + 1), 2);
    for (std::size_t i = 0; i <= corners.size(); ++i) {
      const Vec2 p = corners[i % corners.size()];
      GEOSCoordSeq_setXY_r(handle_, sequence, static_cast<unsigned>(i), p.x, p.y);
    }
    return GEOSGeom_createLinearRing_r(handle_, sequence);
  }
  /// A valid geometry for the ring, by the even-odd rule.
  GEOSGeometry* polygon(std::span<const Vec2> corners) {
    GEOSGeometry* shell = ring(corners);
    if (shell == nullptr) return nullptr;
    GEOSGeometry* raw = own(GEOSGeom_createPolygon_r(handle_, shell, nullptr, 0));
    if (raw == nullptr || GEOSisValid_r(handle_, raw) == 1) return raw;
    return own(GEOSMakeValid_r(handle_, raw));
  }
  GEOSGeometry* minus(const GEOSGeometry* a, const GEOSGeometry* b) {
    return a == nullptr || b == nullptr ? nullptr : own(GEOSDifference_r(handle_, a, b));
  }
  double area(const GEOSGeometry* g) const {
    double area = 0;
    return g != nullptr && GEOSArea_r(handle_, g, &area) == 1 ? area : 0;
  }

 private:
  GEOSContextHandle_t handle_;
  std::vector<GEOSGeometry*> owned_;
};

GEOSGeometry* united(Geos& geos, std::vector<GEOSGeometry*> parts) {
  std::erase(parts, nullptr);
  if (parts.empty()) return geos.own(GEOSGeom_createEmptyPolygon_r(geos.handle()));
  // The collection takes its members over, so it is given copies.
  for (GEOSGeometry*& part : parts) part = GEOSGeom_clone_r(geos.handle(), part);
  GEOSGeometry* all = geos.own(GEOSGeom_createCollection_r(geos.handle(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                           static_cast<unsigned>(parts.size())));
  return all == nullptr ? nullptr : geos.own(GEOSUnaryUnion_r(geos.handle(), all));
}

Ring corners_of(const Geos& geos, const GEOSGeometry* ring) {
  Ring corners;
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos.handle(), ring);
  unsigned count = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(geos.handle(), sequence, &count) != 1 || count < 4) return corners;
  for (unsigned i = 0; i + 1 < count; ++i) {
    Vec2 p;
    GEOSCoordSeq_getXY_r(geos.handle(), sequence, i, &p.x, &p.y);
    corners.push_back(p);
  }
  return corners;
}

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
  if (g == nullptr || GEOSisEmpty_r(geos.handle(), g) != 0) return;
  const int type = GEOSGeomTypeId_r(geos.handle(), g);
  if (type == GEOS_POLYGON) {
    const Ring raw = corners_of(geos, GEOSGetExteriorRing_r(geos.handle(), g));
    Area area{tidy(raw, tolerance), {}};
    if (area.outline.empty()) area.outline = tidy(raw, 0);
    if (area.outline.empty()) return;
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos.handle(), g); ++i) {
      Ring hole = tidy(corners_of(geos, GEOSGetInteriorRingN_r(geos.handle(), g, i)), tolerance);
      if (!hole.empty()) area.holes.push_back(std::move(hole));
    }
    areas.push_back(std::move(area));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(geos.handle(), g); ++i)
      collect(geos, GEOSGetGeometryN_r(geos.handle(), g, i), tolerance, areas);
  }
}

}  // namespace

double area_outside(std::span<const Vec2> ring, std::span<const Vec2> outline) {
  Geos geos;
  return geos.area(geos.minus(geos.polygon(ring), geos.polygon(outline)));
}

std::vector<Area> difference(const std::vector<Area>& areas, const std::vector<Ring>& taken, double tolerance) {
  Geos geos;
  std::vector<GEOSGeometry*> kept, cut;
  for (const Area& area : areas) {
    GEOSGeometry* part = geos.polygon(area.outline);
    for (const Ring& hole : area.holes) {
      if (GEOSGeometry* h = geos.polygon(hole); h != nullptr) part = geos.minus(part, h);
    }
    kept.push_back(part);
  }
  for (const Ring& ring : taken) cut.push_back(geos.polygon(ring));
  std::vector<Area> rest;
  collect(geos, geos.minus(united(geos, std::move(kept)), united(geos, std::move(cut))), tolerance, rest);
  std::ranges::stable_sort(rest, std::ranges::greater{},
                           [](const Area& a) { return std::abs(signed_area(a.outline)); });
  return rest;
}

}  // namespace inhabit::geometry
