#include "crowd/measures/time_to_collision.h"

#include <algorithm>
#include <cmath>

#include "geometry/point_grid.h"

namespace inhabit::crowd {

std::optional<double> time_to_collision(Vec2 x, Vec2 v, double radii) {
  const double a = dot(v, v), b = -dot(x, v), c = dot(x, x) - radii * radii;
  if (c <= 0) return 0.0;
  const double root = b * b - a * c;
  if (b <= 0 || root <= 0) return std::nullopt;
  return c / (b + std::sqrt(root));
}

TimesToCollision times_to_collision(const Recording& recording, std::span<const Vec2> velocities, const Radii& radii,
                                    double horizon, double reach, int threads, std::size_t every) {
  TimesToCollision result;
  result.horizon = horizon;
  result.soonest.assign(recording.fix_count(), std::numeric_limits<float>::infinity());
  const auto bins = static_cast<std::size_t>(std::ceil(horizon / result.step));
  // A histogram per block of frames, added in order.
  constexpr std::size_t kBlock = 64;
  const std::size_t blocks = (recording.frame_count() + kBlock - 1) / kBlock;
  std::vector<std::vector<std::size_t>> histograms(blocks);
  parallel_for(blocks, threads, [&](std::size_t block) {
    std::vector<std::size_t>& histogram = histograms[block];
    histogram.assign(bins, 0);
    for (std::size_t k = block * kBlock; k < std::min((block + 1) * kBlock, recording.frame_count()); ++k) {
      if (k % every != 0) continue;
      const std::vector<Vec2> places = recording.places(k);
      const std::size_t base = recording.first(k);
      for_each_close_pair(places, reach, [&](std::size_t i, std::size_t j) {
        const Vec2 v = velocities[base + i] - velocities[base + j];
        if (!known(v)) return;
        const auto tau = time_to_collision(places[i] - places[j], v, radii(base + i) + radii(base + j));
        if (!tau || *tau >= horizon) return;
        for (const std::size_t who : {base + i, base + j})
          result.soonest[who] = std::min(result.soonest[who], static_cast<float>(*tau));
        if (*tau > 0) ++histogram[std::min(static_cast<std::size_t>(*tau / result.step), bins - 1)];
      });
    }
  });
  result.histogram.assign(bins, 0);
  for (const std::vector<std::size_t>& histogram : histograms)
    for (std::size_t b = 0; b < bins; ++b) result.histogram[b] += histogram[b], result.pairs += histogram[b];
  return result;
}

}  // namespace inhabit::crowd
