#pragma once
#include "crowd/measures/crossings.h"

/// Where to measure when nobody says.
namespace inhabit::crowd {

/// The middle of the people's ways and how they walk there.
struct MainFlow {
  Vec2 center;         ///< the place on somebody's way that is nearest to the median of all ways' half-way points
  Vec2 axis{1, 0};     ///< principal axis of the velocities within a metre of it, pointing the way that most walk
  double two_way = 0;  ///< share of those velocities that point the other way
};
/// Requires: at least one fix.
MainFlow main_flow(const Recording& recording, std::span<const Vec2> velocities);

/// The line across the flow through its centre, from wall to wall; where no wall is known, as wide as people pass
/// within half a metre of it and 0.2 m more on both sides. Forward is the flow's axis.
MeasureLine cross_line(const Recording& recording, const MainFlow& flow);

/// The rectangle as wide as the line and `depth` metres deep along its normal, the line in its middle.
Ring box_around(const MeasureLine& line, double depth);

}  // namespace inhabit::crowd
