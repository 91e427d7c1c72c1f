#pragma once
#include <algorithm>

#include "annealing/arrangement.h"

namespace inhabit::annealing {

/// C_pair^d: two that belong together are as far apart as learned, centre from centre [Yu11 4.3, eq. 6 for pairs].
struct PairDistance {
  static constexpr std::string_view kName = "pair distance";
  static double weight(const Weights& w) { return w.learned.pair_distance; }
  static double of_relation(const Arrangement& x, std::uint32_t r) {
    const Relation& c = x.furniture().relations[r];
    return std::abs(length(x.position(c.second) - x.position(c.first)) - c.distance);
  }
};

/// C_pair^theta: the second stands at the learned bearing from the first's front and looks where it was seen to look,
/// measured from the direction to the first [Yu11 4.3, eq. 7 for pairs]. Those who stand round something are evenly
/// spaced, which the paper says its chairs come out as: with n of them, each gap between neighbours misses 2 pi / n by
/// half of what one of them would have to move.
struct PairAngle {
  static constexpr std::string_view kName = "pair angle";
  static double weight(const Weights& w) { return w.learned.pair_angle; }
  static double of_relation(const Arrangement& x, std::uint32_t r) {
    const Relation& c = x.furniture().relations[r];
    const Vec2 d = x.position(c.second) - x.position(c.first);
    if (d == Vec2{}) return 0;  // any direction is as good as another
    const double to_second = angle_of(d);
    double sum = 0;
    if (c.facing_strength > 0)
      sum += c.facing_strength * std::abs(wrap_angle(x.angle(c.second) - to_second - kPi - c.facing));
    if (c.bearing_strength > 0)
      sum += c.bearing_strength * std::abs(wrap_angle(to_second - x.angle(c.first) - c.bearing));
    return sum;
  }
  static double of_circle(const Arrangement& x, std::uint32_t k) {
    const Circle& circle = x.furniture().circles[k];
    std::array<double, kMost> at{};
    const std::size_t n = std::min(circle.seconds.size(), kMost);
    for (std::size_t i = 0; i < n; ++i) at[i] = angle_of(x.position(circle.seconds[i]) - x.position(circle.first));
    std::sort(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(n));
    const double even = 2 * kPi / static_cast<double>(n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double gap = i + 1 < n ? at[i + 1] - at[i] : at[0] + 2 * kPi - at[n - 1];
      sum += std::abs(gap - even) / 2;
    }
    return sum;
  }
  static constexpr std::size_t kMost = 64;  ///< more are not evenly spaced
};

}  // namespace inhabit::annealing
