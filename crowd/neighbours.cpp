#include "crowd/neighbours.h"

#include <cmath>

namespace inhabit::crowd {

void NearestNeighbours::offer(const Agents& agents, Neighbour candidate) {
  const auto before = [&](const Neighbour& a, const Neighbour& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && agents.id[a.index] < agents.id[b.index]);
  };
  int k = size_;
  if (size_ < count_) {
    ++size_;
  } else if (before(candidate, found_[static_cast<std::size_t>(--k)])) {
    // The farthest makes room.
  } else {
    return;
  }
  for (; k > 0 && before(candidate, found_[static_cast<std::size_t>(k - 1)]); --k)
    found_[static_cast<std::size_t>(k)] = found_[static_cast<std::size_t>(k - 1)];
  found_[static_cast<std::size_t>(k)] = candidate;
  if (size_ == count_) bound2_ = std::min(bound2_, found_[static_cast<std::size_t>(size_ - 1)].distance2);
}

void NearestNeighbours::search_row(const Grid& grid, const Agents& agents, std::size_t i, std::int32_t row, float gap) {
  // Half the chord of the circle of search at the row's near edge; a little more, for the rounding of cells' edges.
  const float half = std::sqrt(std::max(bound2_ - gap * gap, 0.0f)) + 1e-3f * grid.cell();
  const float x = agents.x[i], y = agents.y[i];
  const std::uint32_t end = grid.first(row, grid.column(x + half) + 1);
  for (std::uint32_t j = grid.first(row, grid.column(x - half)); j < end; ++j) {
    const float dx = agents.x[j] - x, dy = agents.y[j] - y, d2 = dx * dx + dy * dy;
    if (d2 <= bound2_ && j != i) offer(agents, {d2, j});
  }
}

std::span<const Neighbour> NearestNeighbours::find(const Grid& grid, const Agents& agents, std::size_t i, float reach,
                                                   int count) {
  INHABIT_ASSERT(count >= 0 && count <= kMost);
  size_ = 0, count_ = count, bound2_ = reach * reach;
  if (count == 0) return {};
  const float y = agents.y[i], slack = 1e-3f * grid.cell();
  const std::int32_t home = grid.row(y);
  search_row(grid, agents, i, home, 0);
  bool below = true, above = true;
  for (std::int32_t k = 1; below || above; ++k) {
    if (below) {
      const float gap = std::max(y - grid.low_y(home - k + 1) - slack, 0.0f);
      below = home - k >= 0 && gap * gap <= bound2_;
      if (below) search_row(grid, agents, i, home - k, gap);
    }
    if (above) {
      const float gap = std::max(grid.low_y(home + k) - y - slack, 0.0f);
      above = home + k < grid.rows() && gap * gap <= bound2_;
      if (above) search_row(grid, agents, i, home + k, gap);
    }
  }
  return {found_.data(), static_cast<std::size_t>(size_)};
}

}  // namespace inhabit::crowd
