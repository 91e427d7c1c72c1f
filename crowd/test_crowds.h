#pragma once
#include <cmath>

#include "core/rng.h"
#include "crowd/model.h"

/// For tests: people in simple places.
namespace inhabit::crowd::testing {

/// Adds somebody of mass 1, standing, who wants to walk with `wish` and at most 1.5 times as fast.
inline std::size_t add_agent(Agents& agents, Vec2 p, Vec2 wish, double radius = 0.5) {
  const std::size_t i = agents.add();
  agents.x[i] = static_cast<float>(p.x), agents.y[i] = static_cast<float>(p.y);
  agents.wish_x[i] = static_cast<float>(wish.x), agents.wish_y[i] = static_cast<float>(wish.y);
  agents.radius[i] = static_cast<float>(radius), agents.mass[i] = 1;
  agents.preferred_speed[i] = static_cast<float>(length(wish));
  agents.maximum_speed[i] = static_cast<float>(std::max(1.5 * length(wish), 0.1));
  agents.id[i] = static_cast<std::uint32_t>(i);
  return i;
}

/// Two blocks of `across` times `deep` people each who walk through each other along x, `gap` metres apart at first.
inline Agents passing(int across, int deep, double spacing, double gap, double jitter = 0.25, std::uint64_t seed = 1) {
  Agents agents;
  Rng rng(seed);
  for (const int side : {-1, 1})
    for (int row = 0; row < across; ++row)
      for (int rank = 0; rank < deep; ++rank) {
        const Vec2 p{side * (gap / 2 + rank * spacing) + rng.uniform(-jitter, jitter),
                     (row - (across - 1) / 2.0) * spacing + rng.uniform(-jitter, jitter)};
        const std::size_t i = add_agent(agents, p, {-1.4 * side, 0});
        agents.maximum_speed[i] = 2;
      }
  return agents;
}

/// Which index everybody has now: index_of[id].
inline std::vector<std::size_t> index_of(const Agents& agents) {
  std::vector<std::size_t> index(agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) index[agents.id[i]] = i;
  return index;
}

/// Pairs that overlap by more than `slack` metres, and the deepest overlap as a share of the radii's sum. Everybody
/// against everybody.
struct Overlaps {
  std::size_t pairs = 0;
  double worst = 0;
};
inline Overlaps overlaps(const Agents& agents, double slack = 0) {
  Overlaps result;
  for (std::size_t i = 0; i < agents.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double both = static_cast<double>(agents.radius[i]) + agents.radius[j];
      const double dx = static_cast<double>(agents.x[i]) - agents.x[j];
      if (std::abs(dx) > both) continue;
      const double depth = both - std::hypot(dx, static_cast<double>(agents.y[i]) - agents.y[j]);
      if (depth > slack) ++result.pairs, result.worst = std::max(result.worst, depth / both);
    }
  return result;
}

inline bool all_finite(const Agents& agents) {
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (!std::isfinite(agents.x[i] + agents.y[i] + agents.vx[i] + agents.vy[i])) return false;
  return true;
}

/// A rectangle from (0, 0), with holes.
inline Walls room(double width, double depth, std::vector<Ring> holes = {}, double reach = 5) {
  return Walls({make_floor({{0, 0}, {width, 0}, {width, depth}, {0, depth}}, std::move(holes))}, {}, reach);
}

}  // namespace inhabit::crowd::testing
