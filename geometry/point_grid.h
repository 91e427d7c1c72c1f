#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// Points sorted into square cells, for asking who is near. The points are not copied: they must outlive the grid.
class PointGrid {
 public:
  /// Cells of `cell` metres, wider when there would be more than four of them for each point. Requires: finite points.
  PointGrid(std::span<const Vec2> points, double cell);

  double cell() const { return cell_; }

  /// Calls f(index) for every point whose cell lies in ring `k` round the cell of p (ring 0 is the cell itself), row by
  /// row. All points nearer to p than k * cell() are in the rings 0 … k. False when the ring lies wholly outside.
  template <class F>
  bool for_each_in_ring(Vec2 p, std::int32_t k, F&& f) const {
    const std::int32_t column = floor_cell(p.x - min_.x), row = floor_cell(p.y - min_.y);
    if (column - k < 0 && column + k >= columns_ && row - k < 0 && row + k >= rows_) return false;
    const std::int32_t r0 = std::max(row - k, 0), r1 = std::min(row + k, rows_ - 1);
    for (std::int32_t r = r0; r <= r1; ++r) {
      const bool whole = r == row - k || r == row + k;
      for (std::int32_t c = column - k; c <= column + k; c += whole || k == 0 ? 1 : 2 * k)
        if (c >= 0 && c < columns_) run(r, c, f);
    }
    return true;
  }

  /// Calls f(index) for every point that may be within `reach` of p, row by row, in order of index in each cell.
  template <class F>
  void for_each_near(Vec2 p, double reach, F&& f) const {
    const std::int32_t c0 = std::max(floor_cell(p.x - reach - min_.x), 0);
    const std::int32_t c1 = std::min(floor_cell(p.x + reach - min_.x), columns_ - 1);
    const std::int32_t r0 = std::max(floor_cell(p.y - reach - min_.y), 0);
    const std::int32_t r1 = std::min(floor_cell(p.y + reach - min_.y), rows_ - 1);
    for (std::int32_t r = r0; r <= r1; ++r)
      for (std::int32_t c = c0; c <= c1; ++c) run(r, c, f);
  }

 private:
  std::int32_t floor_cell(double d) const {
    return static_cast<std::int32_t>(std::clamp(std::floor(d / cell_), -1e9, 1e9));
  }
  template <class F>
  void run(std::int32_t row, std::int32_t column, F&& f) const {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + column;
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) f(static_cast<std::size_t>(items_[k]));
  }

  Vec2 min_;
  double cell_ = 1;
  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_, items_;
};

/// Calls f(i, j) with i < j for every pair of points nearer than `reach`, in order of i, then as the grid has them.
template <class F>
void for_each_close_pair(std::span<const Vec2> points, double reach, F&& f) {
  const PointGrid grid(points, reach);
  for (std::size_t i = 0; i < points.size(); ++i) {
    grid.for_each_near(points[i], reach, [&](std::size_t j) {
      const Vec2 d = points[j] - points[i];
      if (j > i && dot(d, d) < reach * reach) f(i, j);
    });
  }
}

}  // namespace inhabit::geometry
