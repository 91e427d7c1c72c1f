#pragma once
#include <cmath>

#include "core/angle.h"

/// The mathematics of position-based projection that layouts and crowds share.
namespace inhabit::pbd {

/// How a constraint's stiffness changes from one iteration to the next (TVCG 3.1; thesis 5.2.3).
enum class Schedule {
  decreasing,  ///< k_l = 1 - (1 - k0)^(M / l): soft constraints give way as the layout settles
  constant,    ///< k_l = k0: boundary, walls, accessibility
  increasing,  ///< k_l = 1 - (1 - k0)^(l / M): collisions. Our reading of "increases": it must tend to 1
};

/// Stiffness in [0, 1] of iteration l = 1, 2, … Rounded to 2^-30, so that the last bit of the C library's pow, which
/// differs between processors, cannot reach a result. Requires: 0 <= k0 <= 1, rate >= 1, l >= 1.
inline double stiffness(Schedule schedule, double k0, double rate, int l) {
  double k = k0;
  if (schedule == Schedule::decreasing) k = 1 - std::pow(1 - k0, rate / l);
  if (schedule == Schedule::increasing) k = 1 - std::pow(1 - k0, l / rate);
  return std::round(k * 0x1p30) * 0x1p-30;
}

/// Over-relaxation of averaged corrections (TVCG 3.1, after Macklin et al. 2014).
constexpr double kAveraging = 1.2;

/// Step of one particle along a unit gradient that it shares with others: -k w C / sum(w). Nothing when everyone is
/// pinned.
inline double share(double w, double sum) { return sum > 0 ? w / sum : 0; }

}  // namespace inhabit::pbd
