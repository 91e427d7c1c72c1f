#pragma once
#include <optional>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// A place to measure at.
struct MeasureArea {
  Ring ring;                ///< counter-clockwise
  std::vector<Ring> parts;  ///< convex, together the ring
  double size = 0;          ///< square metres that can be walked on
  bool contains(Vec2 p) const { return geometry::contains(ring, p); }
  /// Square metres of the area within `shape`.
  double overlap(const Area& shape) const;
};
/// Requires: a simple ring. `walkable` empty: all of it can be walked on.
MeasureArea make_measure_area(Ring ring, const std::vector<Area>& walkable);

/// What was measured in an area in one frame.
struct AreaRow {
  std::int32_t frame = 0;
  double seconds = 0;
  int people = 0;           ///< heads in the area, its border included
  double density = 0;       ///< people per square metre
  double speed = kUnknown;  ///< metres per second; unknown where there is nobody to measure
};

/// Classic density and speed [PedPy compute_classic_density, compute_mean_speed_per_frame]:
///
///   rho(t) = N(t) / A,   v(t) = mean of |v_i(t)| over the N people in the area
///
/// One row per frame of the recording. `speed`: one per fix (velocity.h); unknown ones are left out of the mean.
/// Deviation: A is the part of the area that can be walked on; PedPy expects areas that lie within the floor.
std::vector<AreaRow> classic_density(const Recording& recording, const MeasureArea& area, std::span<const double> speed,
                                     int threads = 0);

}  // namespace inhabit::crowd
