#include "geometry/clip.h"

#include <geos_c.h>

#include <algorithm>
#include <memory>

namespace inhabit::geometry {
namespace {

/// A GEOS context and the geometries made in it.
class Geos {
 public:
  struct Free {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context, g); }
  };
  using Shape = std::unique_ptr<GEOSGeometry, Free>;

  Geos() : context_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSContextHandle_t get() const { return context_; }
  Shape own(GEOSGeometry* g) const { return {g, Free{context_}}; }

  /// The ring filled; null for fewer than three corners.
  Shape polygon(std::span<const Vec2> ring) const {
    if (ring.size() < 3) return own(nullptr);
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2 p = ring[i % ring.size()];
      GEOSCoordSeq_setXY_r(context_, sequence, static_cast<unsigned>(i), p.x, p.y);
    }
    GEOSGeometry* shell = GEOSGeom_createLinearRing_r(context_, sequence);
    if (shell == nullptr) return own(nullptr);
    const Shape raw = own(GEOSGeom_createPolygon_r(context_, shell, nullptr, 0));
    return raw == nullptr ? own(nullptr) : buffer(raw, 0);
  }
  Shape buffer(const Shape& g, double width) const {
    return own(GEOSBufferWithStyle_r(context_, g.get(), width, 4, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, 5));
  }
  /// The union of all rings; null when there are none.
  Shape together(std::span<const Ring> rings) const {
    std::vector<GEOSGeometry*> parts;
    for (const Ring& ring : rings) {
      if (Shape part = polygon(ring)) parts.push_back(part.release());
    }
    if (parts.empty()) return own(nullptr);
    const Shape all = own(GEOSGeom_createCollection_r(context_, GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                      static_cast<unsigned>(parts.size())));
    return all == nullptr ? own(nullptr) : own(GEOSUnaryUnion_r(context_, all.get()));
  }
  Ring corners(const GEOSGeometry* ring) const {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(context_, ring);
    unsigned size = 0;
    if (sequence == nullptr || GEOSCoordSeq_getSize_r(context_, sequence, &size) != 1 || size < 4) return {};
    Ring out(size - 1);
    for (unsigned i = 0; i + 1 < size; ++i) GEOSCoordSeq_getXY_r(context_, sequence, i, &out[i].x, &out[i].y);
    if (signed_area(out) < 0) std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  GEOSContextHandle_t context_;
};

std::vector<Area> areas_of(const Geos& geos, const GEOSGeometry* g) {
  std::vector<Area> areas;
  const int count = GEOSGetNumGeometries_r(geos.get(), g);
  for (int i = 0; i < count; ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos.get(), g, i);
    if (GEOSGeomTypeId_r(geos.get(), part) != GEOS_POLYGON || GEOSisEmpty_r(geos.get(), part) == 1) continue;
    Area area;
    area.outline = geos.corners(GEOSGetExteriorRing_r(geos.get(), part));
    const int holes = GEOSGetNumInteriorRings_r(geos.get(), part);
    for (int k = 0; k < holes; ++k) area.holes.push_back(geos.corners(GEOSGetInteriorRingN_r(geos.get(), part, k)));
    GEOSArea_r(geos.get(), part, &area.size);
    if (!area.outline.empty()) areas.push_back(std::move(area));
  }
  std::stable_sort(areas.begin(), areas.end(), [](const Area& a, const Area& b) { return a.size > b.size; });
  return areas;
}

}  // namespace

std::vector<Area> difference(std::span<const Vec2> subject, std::span<const Ring> removed, double sliver) {
  const Geos geos;
  Geos::Shape shape = geos.polygon(subject);
  const Geos::Shape away = geos.together(removed);
  if (shape && away) shape = geos.own(GEOSDifference_r(geos.get(), shape.get(), away.get()));
  // In, out twice, in again: opening drops spikes, closing drops notches.
  if (sliver > 0) {
    for (const double step : {-sliver, 2 * sliver, -sliver}) {
      if (shape) shape = geos.buffer(shape, step);
    }
    if (shape) shape = geos.own(GEOSTopologyPreserveSimplify_r(geos.get(), shape.get(), sliver / 10));
  }
  return shape ? areas_of(geos, shape.get()) : std::vector<Area>{};
}

bool overlap_deeper(std::span<const Vec2> a, std::span<const Ring> b, double depth) {
  const Geos geos;
  const Geos::Shape shape = geos.polygon(a), other = geos.together(b);
  if (!shape || !other) return false;
  const Geos::Shape shared = geos.own(GEOSIntersection_r(geos.get(), shape.get(), other.get()));
  if (!shared) return false;
  const Geos::Shape core = geos.buffer(shared, -depth);
  return core && GEOSisEmpty_r(geos.get(), core.get()) == 0;
}

}  // namespace inhabit::geometry
