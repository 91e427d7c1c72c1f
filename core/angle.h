#pragma once
#include <cmath>

namespace inhabit::core {

constexpr double kPi = 3.14159265358979323846;
constexpr double radians(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees(double radians) { return radians * (180 / kPi); }

/// The same direction in (-pi, pi]. Requires: |a| < 1e6 (finite and not absurd).
inline double wrap_angle(double a) {
  if (a > -kPi && a <= kPi) return a;
  a -= 2 * kPi * std::floor((a + kPi) / (2 * kPi));
  return a <= -kPi ? a + 2 * kPi : (a > kPi ? a - 2 * kPi : a);
}

struct SinCos {
  double sin = 0, cos = 1;
};

/// Sine and cosine, |a| < 1e5; absolute error below 2e-16 for |a| <= pi (Taylor series on [-pi/4, pi/4], whose next
/// term is below 1e-17). Ours and not the C library's, whose last bit differs between processors: same seed, same
/// bytes.
SinCos sin_cos(double a);

/// The angle of (x, y) in (-pi, pi], error below 5e-16; 0 for (0, 0). Ours for the same reason as sin_cos.
double direction_angle(double x, double y);

}  // namespace inhabit::core
