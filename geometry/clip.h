#pragma once
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// A polygon with holes: the outline counter-clockwise, and so the holes.
struct Area {
  Ring outline;
  std::vector<Ring> holes;
  double size = 0;  ///< square metres
};

/// `subject` without all of `removed`, largest part first. The rings may overlap and cross (each is repaired as if
/// filled by its winding). Notches, spikes and gaps narrower than 2 * `sliver` metres are dropped, corners are kept by
/// mitring. Empty when nothing is left. Cost of GEOS overlay: about O(n log n) in all corners.
std::vector<Area> difference(std::span<const Vec2> subject, std::span<const Ring> removed, double sliver);

/// True when `a` and the union of `b` share a spot that is wider than 2 * `depth` in every direction.
bool overlap_deeper(std::span<const Vec2> a, std::span<const Ring> b, double depth);

}  // namespace inhabit::geometry
