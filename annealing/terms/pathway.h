#pragma once
#include "annealing/terms/intrusion.h"

namespace inhabit::annealing {

/// C_path: furniture stays out of the rectangles along every curve from door to door [Yu11 eq. 5, 4.3].
///
/// Deviations: a part of the curve that comes nearer to a wall or a pillar than half its width counts as furniture
/// would, from 0 where it just touches to 1 on the border and on beyond it, since rooms need not be convex; and the
/// curve's length beyond the straight line counts a tenth of its share, since "a pathway should be short" is said but
/// nothing in the paper's term prefers it.
struct PathwayCost {
  static constexpr std::string_view kName = "pathway";
  static constexpr double kLength = 0.1;
  static double weight(const Weights& w) { return w.learned.pathway; }
  static double of_space(const Arrangement& x, std::uint32_t i, std::uint32_t s) {
    return x.furniture().spaces[s].kind == Space::Kind::path ? intrusion(x, i, s) : 0;
  }
  static double of_path(const Arrangement& x, std::uint32_t p) {
    const Furniture& f = x.furniture();
    const Path& path = f.paths[p];
    double sum = 0, curve = 0;
    for (std::uint32_t k = 0; k < kPathParts; ++k) {
      const Box& part = x.space(path.first_space + k).box;
      curve += 2 * part.half_depth;
      // The ends lie in their walls.
      if (k == 0 || k + 1 == kPathParts) continue;
      Box disc = part;
      disc.half_depth = std::min(disc.half_depth, disc.half_width);
      double deepest = 0;
      f.room.for_each_violation(disc, [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
      sum += deepest / part.half_width;
    }
    const double shortest = length(path.to - path.from);
    return shortest > 0 ? sum + kLength * (curve / shortest - 1) : sum;
  }
};

}  // namespace inhabit::annealing
