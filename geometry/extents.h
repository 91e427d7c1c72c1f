#pragma once
#include <array>
#include <span>

#include "geometry/vec2.h"

namespace inhabit::geometry {

/// Extents of a polygon in many directions, to tell what can never lie inside it.
class Extents {
 public:
  explicit Extents(std::span<const Vec2> ring);

  /// True only when no position and no angle could make the rectangle fit: a bound, not the exact answer.
  bool too_small_for(double width, double depth) const;

 private:
  static constexpr int kDirections = 720;
  std::array<double, kDirections> extent_{};
  double area_ = 0, smallest_ = 0, slack_ = 0;
};

}  // namespace inhabit::geometry
