#include "crowd/grid.h"

#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

/// Points are counted in so many blocks, whatever the number of threads, so that the order never depends on it.
constexpr std::size_t kBlocks = 8;
/// Below this the counting of one thread is faster than starting others.
constexpr std::size_t kSerial = 8192;

}  // namespace

void Grid::build(std::span<const float> x, std::span<const float> y, float cell, int threads) {
  const std::size_t n = x.size();
  float low_x = std::numeric_limits<float>::max(), low_y = low_x, high_x = -low_x, high_y = -low_x;
  for (std::size_t i = 0; i < n; ++i) {
    low_x = std::min(low_x, x[i]), high_x = std::max(high_x, x[i]);
    low_y = std::min(low_y, y[i]), high_y = std::max(high_y, y[i]);
  }
  if (n == 0) low_x = low_y = high_x = high_y = 0;
  const double width = static_cast<double>(high_x) - low_x, height = static_cast<double>(high_y) - low_y;
  const double budget = 4.0 * static_cast<double>(n) + 64;
  double wide = cell;
  while ((std::floor(width / wide) + 1) * (std::floor(height / wide) + 1) > budget) wide *= 1.25;
  cell_ = static_cast<float>(wide), inverse_cell_ = 1 / cell_;
  min_x_ = low_x, min_y_ = low_y;
  columns_ = static_cast<std::int32_t>(width / wide) + 1, rows_ = static_cast<std::int32_t>(height / wide) + 1;

  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  first_.assign(cells + 1, 0);
  order_.resize(n), cell_of_.resize(n);
  const std::size_t blocks = n < kSerial ? 1 : kBlocks;
  const auto begin = [&](std::size_t b) { return n * b / blocks; };
  core::parallel_for(blocks, n < kSerial ? 1 : threads, [&](std::size_t b) {
    for (std::size_t i = begin(b); i < begin(b + 1); ++i)
      cell_of_[i] = static_cast<std::uint32_t>(row(y[i]) * columns_ + column(x[i]));
  });
  for (const std::uint32_t c : cell_of_) ++first_[c + 1];
  for (std::size_t c = 0; c < cells; ++c) first_[c + 1] += first_[c];
  for (std::uint32_t i = 0; i < n; ++i) order_[first_[cell_of_[i]]++] = i;
  for (std::size_t c = cells; c > 0; --c) first_[c] = first_[c - 1];
  first_[0] = 0;
}

}  // namespace inhabit::crowd
