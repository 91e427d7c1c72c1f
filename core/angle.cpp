#include "core/angle.h"

namespace inhabit::core {

SinCos sin_cos(double a) {
  // Nearest multiple of pi/2, subtracted in two parts so that the remainder keeps its bits.
  // Rounded by conversion: without SSE 4.1 std::floor is a call.
  const auto turns = static_cast<long long>(a * (2 / kPi) + (a < 0 ? -0.5 : 0.5));
  const auto n = static_cast<double>(turns);
  const double r = (a - n * 0x1.921fb54400000p+0) - n * 0x1.0b4611a626331p-34;
  const double z = r * r;
  double s = 1.0 / 355687428096000.0;
  s = s * z - 1.0 / 1307674368000.0;
  s = s * z + 1.0 / 6227020800.0;
  s = s * z - 1.0 / 39916800.0;
  s = s * z + 1.0 / 362880.0;
  s = s * z - 1.0 / 5040.0;
  s = s * z + 1.0 / 120.0;
  s = s * z - 1.0 / 6.0;
  s = r + r * (z * s);
  double c = 1.0 / 20922789888000.0;
  c = c * z - 1.0 / 87178291200.0;
  c = c * z + 1.0 / 479001600.0;
  c = c * z - 1.0 / 3628800.0;
  c = c * z + 1.0 / 40320.0;
  c = c * z - 1.0 / 720.0;
  c = c * z + 1.0 / 24.0;
  c = 1 - (z * 0.5 - z * z * c);
  switch (turns & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

namespace {

/// atan(t) for 0 <= t <= 1: one step t -> (t - t0) / (1 + t t0) brings |t| below tan(pi/16), then the series.
double arc_tangent(double t) {
  constexpr double kTan1 = 0.19891236737965800, kTan2 = 0.41421356237309505, kTan3 = 0.66817863791929891;
  double base = 0, u = t;
  if (t > kTan3) {
    base = kPi / 4, u = (t - 1) / (t + 1);
  } else if (t > kTan1) {
    base = kPi / 8, u = (t - kTan2) / (1 + t * kTan2);
  }
  const double z = u * u;
  double s = 1.0 / 23;
  for (int k = 21; k >= 3; k -= 2) s = 1.0 / k - z * s;
  return base + (u - u * (z * s));
}

}  // namespace

double direction_angle(double x, double y) {
  const double ax = std::abs(x), ay = std::abs(y);
  if (ax == 0 && ay == 0) return 0;
  double a = ay <= ax ? arc_tangent(ay / ax) : kPi / 2 - arc_tangent(ax / ay);
  if (x < 0) a = kPi - a;
  return y < 0 ? -a : a;
}

}  // namespace inhabit::core
