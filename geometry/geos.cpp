#include "geometry/geos.h"

namespace inhabit::geometry {

Geos::Shape Geos::raw_polygon(std::span<const Vec2> ring) const {
  if (ring.size() < 3) return own(nullptr);
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(ring.size() + 1), 2);
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec2 p = ring[i % ring.size()];
    GEOSCoordSeq_setXY_r(context_, sequence, static_cast<unsigned>(i), p.x, p.y);
  }
  GEOSGeometry* shell = GEOSGeom_createLinearRing_r(context_, sequence);
  return shell == nullptr ? own(nullptr) : own(GEOSGeom_createPolygon_r(context_, shell, nullptr, 0));
}

Geos::Shape Geos::polygon(std::span<const Vec2> ring) const {
  Shape raw = raw_polygon(ring);
  if (!raw || GEOSisValid_r(context_, raw.get()) == 1) return raw;
  return own(GEOSMakeValid_r(context_, raw.get()));
}

Geos::Shape Geos::buffer(const Shape& g, double width) const {
  if (!g) return own(nullptr);
  return own(GEOSBufferWithStyle_r(context_, g.get(), width, 4, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, 5));
}

Geos::Shape Geos::minus(const Shape& a, const Shape& b) const {
  return a && b ? own(GEOSDifference_r(context_, a.get(), b.get())) : own(nullptr);
}

Geos::Shape Geos::united(std::vector<Shape> parts) const {
  std::vector<GEOSGeometry*> raw;
  for (Shape& part : parts) {
    if (part) raw.push_back(part.release());
  }
  if (raw.empty()) return own(GEOSGeom_createEmptyPolygon_r(context_));
  const Shape all = own(
      GEOSGeom_createCollection_r(context_, GEOS_GEOMETRYCOLLECTION, raw.data(), static_cast<unsigned>(raw.size())));
  return all ? own(GEOSUnaryUnion_r(context_, all.get())) : own(nullptr);
}

double Geos::area(const Shape& g) const {
  double area = 0;
  return g && GEOSArea_r(context_, g.get(), &area) == 1 ? area : 0;
}

Ring Geos::corners(const GEOSGeometry* ring) const {
  Ring out;
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(context_, ring);
  unsigned size = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(context_, sequence, &size) != 1 || size < 4) return out;
  out.resize(size - 1);
  for (unsigned i = 0; i + 1 < size; ++i) GEOSCoordSeq_getXY_r(context_, sequence, i, &out[i].x, &out[i].y);
  return out;
}

}  // namespace inhabit::geometry
