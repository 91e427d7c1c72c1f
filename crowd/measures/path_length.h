#pragma once
#include <functional>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// How far a person walked, and what it cost.
struct PathRow {
  std::int32_t person = 0;
  double seconds = 0;   ///< from the first fix to the last
  double length = 0;    ///< sum of the distances between fixes, metres; swaying heads add a few per cent
  double shortest = 0;  ///< of the way from the first place to the last, metres
  double effort = 0;    ///< joules per kilogram, see below
  /// length / shortest; kUnknown when the person ends where they began.
  double detour() const { return shortest > 0 ? length / shortest : kUnknown; }
  /// Effort over the least that the shortest way can cost; kUnknown when there is no way.
  double effort_ratio() const;
};

/// Effort of walking [Guy10]: E/m = integral of (e_s + e_w |v|²) dt with e_s = 2.23 J/(kg s) for being on one's feet
/// and e_w = 1.26 J s/(kg m²) for walking; velocities are constant between fixes. Least per metre, 2 sqrt(e_s e_w) =
/// 3.35 J/(kg m), at sqrt(e_s / e_w) = 1.33 m/s.
constexpr double kStandingEffort = 2.23, kWalkingEffort = 1.26;
double least_effort_per_metre();

/// One row per person with at least two fixes, in order of number. `shortest` gives the length of the shortest way from
/// a to b; absent: the straight line.
std::vector<PathRow> path_lengths(const Recording& recording,
                                  const std::function<double(Vec2 a, Vec2 b)>& shortest = nullptr);

}  // namespace inhabit::crowd
