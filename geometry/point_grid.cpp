#include "geometry/point_grid.h"

namespace inhabit::geometry {

PointGrid::PointGrid(std::span<const Vec2> points, double cell) : cell_(cell > 0 ? cell : 1) {
  first_.assign(1, 0);
  if (points.empty()) return;
  const Bounds b = bounds(points);
  min_ = b.min;
  const Vec2 size = b.size();
  const double most = 4 * static_cast<double>(points.size()) + 16;
  const auto count = [&] { return (std::floor(size.x / cell_) + 1) * (std::floor(size.y / cell_) + 1); };
  while (count() > most) cell_ *= 1.5;
  columns_ = floor_cell(size.x) + 1, rows_ = floor_cell(size.y) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  std::vector<std::uint32_t> cell_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t column = std::min(floor_cell(points[i].x - min_.x), columns_ - 1);
    const std::int32_t row = std::min(floor_cell(points[i].y - min_.y), rows_ - 1);
    cell_of[i] = static_cast<std::uint32_t>(row * columns_ + column);
    ++first_[cell_of[i] + 1];
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  items_.resize(points.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) items_[next[cell_of[i]]++] = static_cast<std::uint32_t>(i);
}

}  // namespace inhabit::geometry
