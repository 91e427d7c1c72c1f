#include "geometry/extents.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace inhabit::geometry {
namespace {

/// What areas and lengths may be off by, since files round.
constexpr double kSlack = 1e-6;

}  // namespace

Extents::Extents(std::span<const Vec2> ring) : area_(std::abs(signed_area(ring))) {
  double reach = 0;
  for (int k = 0; k < kDirections; ++k) {
    const Vec2 n = direction(kPi * k / kDirections);
    double low = 1e300, high = -1e300;
    for (const Vec2 p : ring) low = std::min(low, dot(n, p)), high = std::max(high, dot(n, p));
    extent_[static_cast<std::size_t>(k)] = high - low;
    reach = std::max(reach, high - low);
  }
  smallest_ = *std::ranges::min_element(extent_);
  // Between two directions an extent changes by at most the polygon's reach times half the step.
  slack_ = reach * kPi / kDirections / 2 + kSlack;
}

bool Extents::too_small_for(double width, double depth) const {
  if (width * depth > area_ + kSlack) return true;
  if (width * width + depth * depth <= smallest_ * smallest_) return false;
  for (std::size_t k = 0; k < kDirections; ++k) {
    if (width <= extent_[k] + slack_ && depth <= extent_[(k + kDirections / 2) % kDirections] + slack_) return false;
  }
  return true;
}

}  // namespace inhabit::geometry
