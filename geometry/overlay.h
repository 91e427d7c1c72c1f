#pragma once
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// A polygon with holes; the outline runs counter-clockwise and so do the holes.
struct Area {
  Ring outline;
  std::vector<Ring> holes;
};

/// Area of the part of `ring` that is not in `outline`, square metres. Requires: both are simple.
double area_outside(std::span<const Vec2> ring, std::span<const Vec2> outline);

/// What remains of the areas' union without everything in `taken`, as simple polygons, largest first. Rings that cross
/// themselves are understood by the even-odd rule. Holes that touch their outline or each other are merged into it.
/// Corners that lie within `tolerance` of the line between their neighbours are dropped.
std::vector<Area> difference(const std::vector<Area>& areas, const std::vector<Ring>& taken, double tolerance);

}  // namespace inhabit::geometry
