#include "crowd/models/linear_programme.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace inhabit::crowd {
namespace {

/// Sines of angles between lines that count as parallel, and metres per second by which a half plane may be missed:
/// far below what the floats of velocities resolve, far above what doubles round.
constexpr double kParallel = 1e-9, kMissed = 1e-9;

/// The optimum on the border of planes[i], within the half planes before it and the disc; nothing when they leave no
/// point of it.
std::optional<Vec2> optimum_on_border(std::span<const HalfPlane> planes, std::size_t i, Vec2 wish, double longest,
                                      bool direction) {
  const Vec2 n = planes[i].n, along = perp(n);
  // The border is c n + t along; the disc leaves t in [-s, s].
  const double c = planes[i].c, ss = longest * longest - c * c;
  if (ss < 0) return std::nullopt;
  double low = -std::sqrt(ss), high = -low;
  for (std::size_t j = 0; j < i; ++j) {
    const double slope = dot(planes[j].n, along), needed = planes[j].c - c * dot(planes[j].n, n);
    if (std::abs(slope) <= kParallel) {
      if (needed > kMissed) return std::nullopt;
    } else if (slope > 0) {
      low = std::max(low, needed / slope);
    } else {
      high = std::min(high, needed / slope);
    }
    if (low > high) return std::nullopt;
  }
  const double t = dot(along, wish);
  return c * n + (direction ? (t > 0 ? high : low) : std::clamp(t, low, high)) * along;
}

}  // namespace

PlaneOptimum optimum(std::span<const HalfPlane> planes, Vec2 wish, double longest, bool direction) {
  const double l = length(wish);
  Vec2 v = direction || l > longest ? (l > 0 ? longest / l : 0) * wish : wish;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (violation(planes[i], v) <= 0) continue;
    const auto better = optimum_on_border(planes, i, wish, longest, direction);
    if (better) {
      v = *better;
    } else if (violation(planes[i], v) > kMissed) {
      return {v, false};
    }
  }
  return {v, true};
}

/// Minimises d subject to n_j.v >= c_j - d for the soft half planes: whenever one is violated by more than the d so
/// far, the optimum is where it is the worst, d = c_i - n_i.v, and the others then ask for
/// (n_j - n_i).v >= c_j - c_i: a programme in the plane that maximises n_i.v.
Vec2 LinearProgramme::least_violation(std::span<const HalfPlane> planes, std::size_t hard, Vec2 v, double longest) {
  double worst = 0;
  for (std::size_t i = hard; i < planes.size(); ++i) {
    if (violation(planes[i], v) <= worst + kMissed) continue;
    projected_.assign(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(hard));
    bool nothing = false;
    for (std::size_t j = hard; j < i && !nothing; ++j) {
      const Vec2 n = planes[j].n - planes[i].n;
      const double c = planes[j].c - planes[i].c, l = length(n);
      // The same normal: whichever asks for more is the worse one everywhere.
      if (l <= kParallel) {
        nothing = c > kMissed;
      } else {
        projected_.push_back({(1 / l) * n, c / l});
      }
    }
    if (nothing) continue;
    const PlaneOptimum best = optimum(projected_, planes[i].n, longest, true);
    // By construction there is a solution, the one so far at the least; what contradicts that is rounding.
    if (best.feasible) v = best.v;
    worst = std::max(worst, violation(planes[i], v));
  }
  return v;
}

Vec2 LinearProgramme::solve(std::span<const HalfPlane> planes, std::size_t hard, Vec2 wish, double longest) {
  const PlaneOptimum best = optimum(planes, wish, longest, false);
  if (best.feasible) return best.v;
  const PlaneOptimum among_hard = optimum(planes.first(hard), wish, longest, false);
  return among_hard.feasible ? least_violation(planes, hard, among_hard.v, longest)
                             : least_violation(planes, 0, among_hard.v, longest);
}

}  // namespace inhabit::crowd
