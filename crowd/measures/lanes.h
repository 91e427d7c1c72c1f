#pragma once
#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// Lane order parameter of two opposing flows [Rex07, there for colloids; Nowak12 for people]:
///
///   phi = 1/N sum_i ((n_same - n_opposite) / (n_same + n_opposite))²
///
/// over everybody whose distance from i across the flow is below `band`, however far ahead or behind; 1: each such band
/// walks one way; for n people in a band who go either way by chance it is 1/n. A person counts among their own n_same
/// and goes the way that the sign of v·axis says.
/// Deviation: people who are slower than `slowest` along the axis, or of unknown velocity, are left out, lest a crowd
/// that stands and sways count as two flows; frames with fewer than `least` people each way have no phi.
struct LaneRow {
  double seconds = 0;
  int forward = 0, backward = 0;
  double order = kUnknown;
};
struct LaneOptions {
  Vec2 axis{1, 0};    ///< unit vector along the flows
  double band = 0.4;  ///< metres either way
  int least = 3;
  double slowest = 0.2;  ///< metres per second
};
/// One row per frame.
std::vector<LaneRow> lanes(const Recording& recording, std::span<const Vec2> velocities, const LaneOptions& options,
                           int threads = 0);

/// Mean of the known phi; kUnknown when the flow is not two-way.
double mean_order(std::span<const LaneRow> rows);

}  // namespace inhabit::crowd
