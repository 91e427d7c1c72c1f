#pragma once
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// A polygon with holes; the outline runs counter-clockwise and so do the holes.
struct Area {
  Ring outline;
  std::vector<Ring> holes;
  double size() const;  ///< square metres
};

/// Area of the part of `ring` that is not in `outline`, square metres. Requires: both are simple.
double area_outside(std::span<const Vec2> ring, std::span<const Vec2> outline);

/// What remains of the areas' union without everything in `taken`, as simple polygons, largest first. Rings that cross
/// themselves are understood by the even-odd rule. Holes that touch their outline or each other are merged into it.
/// Corners that lie within `tolerance` of the line between their neighbours are dropped.
std::vector<Area> difference(const std::vector<Area>& areas, std::span<const Ring> taken, double tolerance);

/// The parts of the areas' union that lie in `ring`, largest first; rings and `tolerance` as for difference().
std::vector<Area> intersection(const std::vector<Area>& areas, std::span<const Vec2> ring, double tolerance);

/// `subject` without everything in `taken`, largest part first. Notches, spikes and gaps narrower than 2 * `sliver`
/// metres are dropped, corners are kept by mitring.
std::vector<Area> smooth_difference(std::span<const Vec2> subject, std::span<const Ring> taken, double sliver);

/// True when `a` and the union of `b` share a spot that is wider than 2 * `depth` in every direction.
bool overlap_deeper(std::span<const Vec2> a, std::span<const Ring> b, double depth);

}  // namespace inhabit::geometry
