#include "crowd/safety.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

/// Agents that are one thread's work, and that are looked at together.
constexpr std::size_t kBlock = 8192, kPart = 256;
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

/// flags[k]: agent begin + k moved at most the reach and has a velocity. False for what is no number.
void moved_little(const Agents& agents, std::size_t begin, std::size_t count, float reach_squared,
                  std::array<std::uint8_t, kPart>& flags) {
  const float *x = &agents.x[begin], *y = &agents.y[begin], *kx = &agents.kept_x[begin], *ky = &agents.kept_y[begin];
  const float *vx = &agents.vx[begin], *vy = &agents.vy[begin];
  std::array<std::int32_t, kPart> good;
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - kx[k], dy = y[k] - ky[k];
    good[k] = static_cast<std::int32_t>(dx * dx + dy * dy <= reach_squared) &
              static_cast<std::int32_t>(vx[k] * vx[k] + vy[k] * vy[k] < kFastest * kFastest);
  }
  for (std::size_t k = 0; k < count; ++k) flags[k] = static_cast<std::uint8_t>(good[k]);
}

}  // namespace

std::size_t keep_on_floor(Agents& agents, const Walls& walls, int threads) {
  const std::size_t n = agents.size(), blocks = (n + kBlock - 1) / kBlock;
  const float reach = walls.empty() ? kFastest : walls.reach();
  const float reach_squared = reach * reach;
  std::vector<std::size_t> back(blocks, 0);
  core::parallel_for(blocks, threads, [&](std::size_t b) {
    const std::size_t end = std::min(n, (b + 1) * kBlock);
    std::array<std::uint8_t, kPart> open, good;
    for (std::size_t begin = b * kBlock; begin < end; begin += kPart) {
      const std::size_t count = std::min(kPart, end - begin);
      walls.in_the_open({&agents.x[begin], count}, {&agents.y[begin], count}, open);
      moved_little(agents, begin, count, reach_squared, good);
      // In the open after less than the reach: no wall was on the way.
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = begin + k;
        if ((open[k] & good[k]) != 0 || !lost(agents, i, walls, reach_squared)) continue;
        agents.x[i] = agents.kept_x[i], agents.y[i] = agents.kept_y[i];
        agents.vx[i] = agents.vy[i] = 0;
        ++back[b];
      }
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
