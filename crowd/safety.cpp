#include "crowd/safety.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

/// Agents that one call looks after, and as many as are one thread's work.
constexpr std::size_t kBlock = 8192;
/// Faster than this is no velocity, metres per second; also false for what is no number.
constexpr float kFastest = 1e6f;

bool lost(const Agents& agents, std::size_t i, const Walls& walls, float reach_squared) {
  const float x = agents.x[i], y = agents.y[i], vx = agents.vx[i], vy = agents.vy[i];
  if (!(vx * vx + vy * vy < kFastest * kFastest)) return true;
  const float kx = agents.kept_x[i], ky = agents.kept_y[i];
  const float dx = x - kx, dy = y - ky, moved = dx * dx + dy * dy;
  if (moved <= reach_squared) return walls.leaves(kx, ky, x, y);
  if (!(moved < kFastest * kFastest)) return true;
  return !walls.sees(kx, ky, x, y);
}

}  // namespace

std::size_t keep_on_floor(Agents& agents, const Walls& walls, int threads) {
  const std::size_t n = agents.size(), blocks = (n + kBlock - 1) / kBlock;
  const float reach = walls.empty() ? kFastest : walls.reach();
  const float reach_squared = reach * reach;
  std::vector<std::size_t> back(blocks, 0);
  core::parallel_for(blocks, threads, [&](std::size_t b) {
    const std::size_t end = std::min(n, (b + 1) * kBlock);
    for (std::size_t i = b * kBlock; i < end; ++i) {
      const float x = agents.x[i], y = agents.y[i], vx = agents.vx[i], vy = agents.vy[i];
      const float dx = x - agents.kept_x[i], dy = y - agents.kept_y[i];
      // In the open after less than the reach: no wall was on the way. Comparisons with no number are false.
      const bool good = (dx * dx + dy * dy <= reach_squared) & (vx * vx + vy * vy < kFastest * kFastest);
      if ((good && walls.in_the_open(x, y)) || !lost(agents, i, walls, reach_squared)) continue;
      agents.x[i] = agents.kept_x[i], agents.y[i] = agents.kept_y[i];
      agents.vx[i] = agents.vy[i] = 0;
      ++back[b];
    }
    const auto from = static_cast<std::ptrdiff_t>(b * kBlock), to = static_cast<std::ptrdiff_t>(end);
    std::copy(agents.x.begin() + from, agents.x.begin() + to, agents.kept_x.begin() + from);
    std::copy(agents.y.begin() + from, agents.y.begin() + to, agents.kept_y.begin() + from);
  });
  std::size_t sum = 0;
  for (const std::size_t count : back) sum += count;
  return sum;
}

}  // namespace inhabit::crowd
