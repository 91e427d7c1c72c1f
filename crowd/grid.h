#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

/// Agents sorted by the cell they are in, so that everybody near a place stands in a few contiguous runs of the arrays.
namespace inhabit::crowd {

class Grid {
 public:
  /// Lays a grid of square cells over the points, at least `cell` metres wide; wider when the points are so scattered
  /// that there would be more than four cells for each. `order()` then says who belongs where: after
  /// agents.permute(grid.order()) the run of cell c is the indices first(c) … first(c + 1) - 1. A stable counting sort:
  /// the same order at any number of threads.
  void build(std::span<const float> x, std::span<const float> y, float cell, int threads);
  std::span<const std::uint32_t> order() const { return order_; }

  float cell() const { return cell_; }
  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  std::int32_t column(float x) const { return clamp((x - min_x_) * inverse_cell_, columns_); }
  std::int32_t row(float y) const { return clamp((y - min_y_) * inverse_cell_, rows_); }
  /// Where a row of cells begins, metres.
  float low_y(std::int32_t row) const { return min_y_ + static_cast<float>(row) * cell_; }
  std::uint32_t first(std::int32_t row, std::int32_t column) const {
    return first_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  /// Calls f(begin, end) for each run of indices that may hold points within `reach` of (x, y): one per row of cells,
  /// in ascending order. Requires: the points have been permuted, and have not left their cells by more than the
  /// caller has added to `reach`.
  template <class F>
  void for_each_run(float x, float y, float reach, F&& f) const {
    const std::int32_t c0 = column(x - reach), c1 = column(x + reach), r1 = row(y + reach);
    for (std::int32_t r = row(y - reach); r <= r1; ++r) {
      const std::uint32_t begin = first(r, c0), end = first(r, c1 + 1);
      if (begin < end) f(begin, end);
    }
  }

 private:
  static std::int32_t clamp(float at, std::int32_t count) {
    return at > 0 ? std::min(static_cast<std::int32_t>(std::min(at, 1e9f)), count - 1) : 0;
  }
  float min_x_ = 0, min_y_ = 0, cell_ = 1, inverse_cell_ = 1;
  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  ///< rows * columns + 1; a row's last cell ends where the next row begins
  std::vector<std::uint32_t> order_, cell_of_;
};

}  // namespace inhabit::crowd
