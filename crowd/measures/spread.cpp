#include "crowd/measures/spread.h"

#include <cmath>

namespace inhabit::crowd {

Spread spread_of(std::span<const Vec2> places) {
  Spread spread;
  if (places.empty()) return spread;
  const double n = static_cast<double>(places.size());
  for (const Vec2 p : places) spread.middle = spread.middle + (1 / n) * p;
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2 p : places) {
    const Vec2 d = p - spread.middle;
    xx += d.x * d.x / n, xy += d.x * d.y / n, yy += d.y * d.y / n;
  }
  // Eigenvalues of [[xx, xy], [xy, yy]].
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  spread.longer = std::sqrt(mean + half), spread.shorter = std::sqrt(std::max(0.0, mean - half));
  spread.angle = half > 0 ? 0.5 * std::atan2(2 * xy, xx - yy) : 0;
  return spread;
}

double distortion(std::span<const Vec2> before, std::span<const Vec2> after) {
  INHABIT_ASSERT(before.size() == after.size());
  if (before.empty()) return 0;
  const Vec2 moved = spread_of(after).middle - spread_of(before).middle;
  double sum = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Vec2 d = after[k] - before[k] - moved;
    sum += dot(d, d);
  }
  return std::sqrt(sum / static_cast<double>(before.size()));
}

}  // namespace inhabit::crowd
