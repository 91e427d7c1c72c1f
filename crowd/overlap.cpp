#include "crowd/overlap.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

constexpr std::size_t kBlock = 4096;

double depth_in_walls(const Walls& walls, float x, float y, float radius) {
  if (walls.in_the_open(x, y)) return 0;
  double least = static_cast<double>(radius) * radius;
  walls.for_each_near(x, y, [&](const WallSegment& s, std::uint32_t) {
    const WallPoint p = nearest_point(s, x, y);
    const double dx = static_cast<double>(x) - p.x, dy = static_cast<double>(y) - p.y;
    least = std::min(least, dx * dx + dy * dy);
  });
  return radius - std::sqrt(least);
}

}  // namespace

Overlap OverlapMeter::measure(const Agents& agents, const Walls& walls, int threads) {
  const std::size_t n = agents.size();
  if (n == 0) return {};
  const float widest = *std::ranges::max_element(agents.radius);
  grid_.build(agents.x, agents.y, 2 * widest, threads);
  const std::span<const std::uint32_t> order = grid_.order();
  x_.resize(n), y_.resize(n), radius_.resize(n);
  for (std::size_t k = 0; k < n; ++k)
    x_[k] = agents.x[order[k]], y_[k] = agents.y[order[k]], radius_[k] = agents.radius[order[k]];

  const std::size_t blocks = (n + kBlock - 1) / kBlock;
  std::vector<Overlap> worst(blocks);
  core::parallel_for(blocks, threads, [&](std::size_t b) {
    Overlap& w = worst[b];
    for (std::size_t i = b * kBlock; i < std::min(n, (b + 1) * kBlock); ++i) {
      w.wall = std::max(w.wall, depth_in_walls(walls, x_[i], y_[i], radius_[i]));
      grid_.for_each_run(x_[i], y_[i], radius_[i] + widest, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::size_t j = std::max<std::size_t>(begin, i + 1); j < end; ++j) {
          const float dx = x_[i] - x_[j], dy = y_[i] - y_[j], radii = radius_[i] + radius_[j];
          if (dx * dx + dy * dy >= radii * radii) continue;
          const double ex = dx, ey = dy, depth = radii - std::sqrt(ex * ex + ey * ey);
          w.depth = std::max(w.depth, depth);
          w.share = std::max(w.share, depth / radii);
        }
      });
    }
  });
  Overlap all;
  for (const Overlap& w : worst)
    all = {std::max(all.depth, w.depth), std::max(all.share, w.share), std::max(all.wall, w.wall)};
  return all;
}

}  // namespace inhabit::crowd
