#pragma once
#include <span>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// How a group lies: its middle and its principal axes.
struct Spread {
  Vec2 middle;
  double longer = 0, shorter = 0;  ///< metres; standard deviations along the axes
  double angle = 0;                ///< of the longer axis, radians in (-pi/2, pi/2]
  /// 1: as long as wide. Of people spread evenly in an ellipse it is the ratio of its axes. Requires: shorter > 0.
  double ratio() const { return longer / shorter; }
};
/// From the covariance (over n) of the positions. All zero for nobody.
Spread spread_of(std::span<const Vec2> places);

/// Root mean square distance between two pictures of one group, metres, after they are laid on each other by their
/// middles: 0 when every person kept his place among the others. Requires: as many in both, in the same order.
double distortion(std::span<const Vec2> before, std::span<const Vec2> after);

}  // namespace inhabit::crowd
