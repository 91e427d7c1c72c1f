#pragma once
#include <optional>

#include "crowd/measures/overlaps.h"

namespace inhabit::crowd {

/// When two discs whose radii add up to `radii` will touch if both keep their velocity, seconds [thesis eq. 4.4-4.7,
/// Karamouzas14]:
///
///   tau = (b - sqrt(b² - a c)) / a,  a = |v|²,  b = -x·v,  c = |x|² - radii²
///
/// with x and v the position and the velocity of one as seen from the other. Nothing when they never touch; 0 when they
/// touch or overlap already. Computed as c / (b + sqrt(b² - a c)), which is the same and keeps its digits for slow
/// pairs.
std::optional<double> time_to_collision(Vec2 x, Vec2 v, double radii);

struct TimesToCollision {
  std::vector<float> soonest;  ///< per fix: the next collision with anybody, seconds; infinity for none
  std::vector<std::size_t>
      histogram;  ///< of pairs: so many with k * step <= tau < (k + 1) * step, overlapping ones left out
  double step = 0.1, horizon = 10;
  std::size_t pairs = 0;  ///< in the histogram
};
/// Pairs nearer than `reach` metres whose tau is below `horizon` seconds. People of unknown velocity are left out.
/// `every`: of so many frames one, since neighbouring frames say the same; the others have no soonest.
TimesToCollision times_to_collision(const Recording& recording, std::span<const Vec2> velocities, const Radii& radii,
                                    double horizon = 10, double reach = 10, int threads = 0, std::size_t every = 1);

}  // namespace inhabit::crowd
