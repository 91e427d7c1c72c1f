#include "geometry/box_grid.h"

#include <algorithm>

namespace inhabit::geometry {

BoxGrid::BoxGrid(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  Bounds all;
  std::vector<double> extents;
  extents.reserve(boxes_.size());
  for (const Bounds& b : boxes_) {
    all.add(b.min), all.add(b.max);
    extents.push_back(std::max(b.size().x, b.size().y));
  }
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  origin_ = all.min;
  // As fine as the median box, unless that made too many cells for the boxes there are.
  const Vec2 size = all.size();
  const double most = 4.0 * static_cast<double>(boxes_.size()) + 64;
  cell_ = std::max({*middle, std::sqrt(size.x * size.y / most), std::max(size.x, size.y) / most, 1e-9});
  // Nor so fine that the large ones among them fill memory with their cells.
  const auto entries = [&] {
    double sum = 0;
    for (const Bounds& b : boxes_) sum += (b.size().x / cell_ + 1) * (b.size().y / cell_ + 1);
    return sum;
  };
  while (entries() > 16.0 * static_cast<double>(boxes_.size()) + 4096) cell_ *= 1.5;
  columns_ = static_cast<std::uint32_t>(size.x / cell_) + 1;
  rows_ = static_cast<std::uint32_t>(size.y / cell_) + 1;

  // Counting sort of the boxes into the cells that they cover: the cells of Teschner03 without its hashing, since
  // these are few.
  start_.assign(static_cast<std::size_t>(rows_) * columns_ + 1, 0);
  const auto for_each_cell = [&](const Bounds& b, auto&& visit) {
    const Range r = range(b);
    for (std::size_t row = r.row0; row <= r.row1; ++row)
      for (std::size_t column = r.column0; column <= r.column1; ++column) visit(row * columns_ + column);
  };
  for (const Bounds& b : boxes_) for_each_cell(b, [&](std::size_t k) { ++start_[k + 1]; });
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  items_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    for_each_cell(boxes_[i], [&](std::size_t k) { items_[next[k]++] = i; });
}

}  // namespace inhabit::geometry
