#include "core/distributions.h"

#include <bit>
#include <cmath>

#include "core/angle.h"
#include "core/result.h"

namespace inhabit::core {

double natural_log(double x) {
  INHABIT_ASSERT(x >= 0x1p-1022 && x <= 0x1.fffffffffffffp+1023);
  // x = m 2^e with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh(s), s = (m - 1) / (m + 1), |s| < 0.172.
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto e = static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 1.4142135623730951) m *= 0.5, ++e;
  const double s = (m - 1) / (m + 1), z = s * s;
  // The first term left out is z^12 / 25 < 2e-20.
  double series = 1.0 / 23;
  for (int k = 21; k >= 3; k -= 2) series = 1.0 / k + z * series;
  const double log_m = 2 * s + 2 * s * (z * series);
  // ln 2 in two parts, of which the first has so few bits that e times it is exact.
  constexpr double kHigh = 0x1.62e42fefa3800p-1, kLow = 0x1.ef35793c76730p-45;
  return e * kHigh + (log_m + e * kLow);
}

double standard_normal(Rng& rng) {
  const double u = rng.uniform(), v = rng.uniform();
  return std::sqrt(-2 * natural_log(1 - u)) * sin_cos(2 * kPi * v).cos;
}

double exponential(Rng& rng) { return -natural_log(1 - rng.uniform()); }

}  // namespace inhabit::core
