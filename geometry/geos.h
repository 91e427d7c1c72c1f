#pragma once
#include <geos_c.h>

#include <memory>
#include <span>
#include <vector>

#include "geometry/polygon.h"

/// GEOS for the .cpp files of this folder: nobody else includes this header.
namespace inhabit::geometry {

/// A GEOS context. Shapes made in it must not outlive it; a null shape means that an operation failed or had nothing to
/// work on, and what is made of it is null too.
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

  /// The ring filled as it is, valid or not.
  Shape raw_polygon(std::span<const Vec2> ring) const;
  /// The ring filled, by the even-odd rule where it crosses itself.
  Shape polygon(std::span<const Vec2> ring) const;
  /// Mitred at corners; a negative width shrinks.
  Shape buffer(const Shape& g, double width) const;
  Shape minus(const Shape& a, const Shape& b) const;
  /// An empty polygon for no parts.
  Shape united(std::vector<Shape> parts) const;
  double area(const Shape& g) const;
  /// The corners of a GEOS ring, in its own direction.
  Ring corners(const GEOSGeometry* ring) const;

 private:
  GEOSContextHandle_t context_;
};

}  // namespace inhabit::geometry
