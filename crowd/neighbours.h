#pragma once
#include <array>

#include "core/parallel.h"
#include "crowd/agents.h"
#include "crowd/grid.h"

/// Who is near whom, for models that look at one agent after the other. Every function that takes a grid requires
/// that the agents stand as `sort_by_cell` left them.
namespace inhabit::crowd {

/// Lays the grid over the agents and permutes them into its order: one agent's neighbours are then runs of the arrays.
inline void sort_by_cell(Agents& agents, Grid& grid, float cell, int threads) {
  grid.build(agents.x, agents.y, cell, threads);
  agents.permute(grid.order(), threads);
}

/// Agents that one call of a parallel loop looks at: enough to hide the call, few enough to share the work evenly.
constexpr std::size_t kAgentBlock = 128;
/// So few agents are faster on one thread.
constexpr std::size_t kFewAgents = 256;
inline std::size_t block_count(std::size_t agents) { return (agents + kAgentBlock - 1) / kAgentBlock; }

/// Calls f(block, begin, end) for consecutive blocks of 0 … count - 1, on several threads. The blocks do not depend on
/// the number of threads.
template <class F>
void for_each_block(std::size_t count, int threads, F&& f) {
  core::parallel_for(block_count(count), count <= kFewAgents ? 1 : threads, [&](std::size_t block) {
    f(block, block * kAgentBlock, std::min(count, (block + 1) * kAgentBlock));
  });
}

/// Calls f(j, dx, dy, d2) for every other agent j whose centre is at most `reach` metres from agent i's, in ascending
/// order; (dx, dy) leads from j to i and d2 is its square.
template <class F>
void for_each_within(const Grid& grid, const Agents& agents, std::size_t i, float reach, F&& f) {
  const float x = agents.x[i], y = agents.y[i], reach2 = reach * reach;
  // A little farther than reach: what float rounds must not decide in which cells we look.
  grid.for_each_run(x, y, 1.0001f * reach, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t j = begin; j < end; ++j) {
      const float dx = x - agents.x[j], dy = y - agents.y[j], d2 = dx * dx + dy * dy;
      if (d2 <= reach2 && j != i) f(j, dx, dy, d2);
    }
  });
}

struct Neighbour {
  float distance2 = 0;  ///< between the centres, squared
  std::uint32_t index = 0;
};

/// The nearest few of an agent's neighbours. Give each thread its own.
class NearestNeighbours {
 public:
  static constexpr int kMost = 64;

  /// The `count` other agents nearest to agent i, not farther than `reach` metres; nearest first, equally far ones in
  /// order of their id, so that the order of the agents in memory does not matter. Requires: 0 <= count <= kMost.
  /// Rows of cells are searched outwards and narrowed to the farthest of the nearest so far: the cost depends on count,
  /// hardly on reach.
  std::span<const Neighbour> find(const Grid& grid, const Agents& agents, std::size_t i, float reach, int count);

 private:
  void search_row(const Grid& grid, const Agents& agents, std::size_t i, std::int32_t row, float gap);
  void offer(const Agents& agents, Neighbour candidate);

  std::array<Neighbour, kMost> found_;
  int size_ = 0, count_ = 0;
  float bound2_ = 0;  ///< whoever is farther does not count
};

}  // namespace inhabit::crowd
