#pragma once
#include <cstdint>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// Finds which of many bounds meet a given one, or each other. A uniform grid about as fine as the median box, coarser
/// when that took more than four cells or sixteen entries per box; every answer is in the order of the cells, the same
/// at every run. Cost: linear for boxes of similar size that do not pile up.
class BoxGrid {
 public:
  explicit BoxGrid(std::vector<Bounds> boxes);

  std::size_t size() const { return boxes_.size(); }
  const Bounds& operator[](std::size_t i) const { return boxes_[i]; }

  /// Calls f(index) once for each box that meets `query` (touching counts).
  template <class F>
  void for_each_near(const Bounds& query, F&& f) const {
    if (boxes_.empty()) return;
    const Range r = range(query);
    for (std::uint32_t row = r.row0; row <= r.row1; ++row)
      for (std::uint32_t column = r.column0; column <= r.column1; ++column)
        for (const std::uint32_t i : cell(row, column))
          if (meets(boxes_[i], query) && first_common(i, r, row, column)) f(i);
  }

  /// Calls f(i, j), i < j, once for each pair that meets.
  template <class F>
  void for_each_pair(F&& f) const {
    for (std::uint32_t row = 0; row < rows_; ++row)
      for (std::uint32_t column = 0; column < columns_; ++column) {
        const auto here = cell(row, column);
        for (std::size_t k = 0; k < here.size(); ++k)
          for (std::size_t l = k + 1; l < here.size(); ++l)
            if (meets(boxes_[here[k]], boxes_[here[l]]) && first_common(here[k], range(boxes_[here[l]]), row, column))
              f(here[k], here[l]);
      }
  }

 private:
  struct Range {
    std::uint32_t row0 = 0, row1 = 0, column0 = 0, column1 = 0;
  };

  static bool meets(const Bounds& a, const Bounds& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
  }
  std::uint32_t index(double offset, std::uint32_t count) const {
    const double at = offset / cell_;
    return at > 0 ? std::min(static_cast<std::uint32_t>(std::min(at, 4e9)), count - 1) : 0;
  }
  Range range(const Bounds& b) const {
    return {index(b.min.y - origin_.y, rows_), index(b.max.y - origin_.y, rows_), index(b.min.x - origin_.x, columns_),
            index(b.max.x - origin_.x, columns_)};
  }
  /// Two boxes may share many cells; the pair belongs to the first of them.
  bool first_common(std::uint32_t i, const Range& other, std::uint32_t row, std::uint32_t column) const {
    const Range own = range(boxes_[i]);
    return row == std::max(own.row0, other.row0) && column == std::max(own.column0, other.column0);
  }
  std::span<const std::uint32_t> cell(std::uint32_t row, std::uint32_t column) const {
    const std::size_t k = static_cast<std::size_t>(row) * columns_ + column;
    return {items_.data() + start_[k], items_.data() + start_[k + 1]};
  }

  std::vector<Bounds> boxes_;
  Vec2 origin_;
  double cell_ = 1;
  std::uint32_t rows_ = 0, columns_ = 0;
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> items_;
};

}  // namespace inhabit::geometry
