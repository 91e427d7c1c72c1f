#pragma once
#include <cstdint>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::annealing {
using geometry::Bounds;
using geometry::Vec2;

/// Who covers which cell of a uniform grid, kept up to date as things move. What lies beyond the border counts to the
/// border's cells.
class Cells {
 public:
  struct Range {
    std::uint16_t row0 = 0, row1 = 0, column0 = 0, column1 = 0;
    friend bool operator==(const Range&, const Range&) = default;
  };

  Cells(const Bounds& extent, double cell)
      : origin_(extent.min), cell_(cell), columns_(count(extent.size().x)), rows_(count(extent.size().y)) {
    items_.resize(static_cast<std::size_t>(columns_) * rows_);
  }

  Range range(const Bounds& b) const { return {row(b.min.y), row(b.max.y), column(b.min.x), column(b.max.x)}; }
  void insert(std::uint32_t id, const Range& r) {
    for_each_cell(r, [&](std::vector<std::uint32_t>& cell) { cell.push_back(id); });
  }
  void erase(std::uint32_t id, const Range& r) {
    for_each_cell(r, [&](std::vector<std::uint32_t>& cell) {
      for (std::uint32_t& k : cell) {
        if (k != id) continue;
        k = cell.back();
        cell.pop_back();
        return;
      }
    });
  }
  /// Calls f(id) for everything in the cells, more than once for what covers several.
  template <class F>
  void visit(const Range& r, F&& f) const {
    for (std::uint32_t i = r.row0; i <= r.row1; ++i)
      for (std::uint32_t j = r.column0; j <= r.column1; ++j)
        for (const std::uint32_t id : items_[static_cast<std::size_t>(i) * columns_ + j]) f(id);
  }

 private:
  static constexpr double kMost = 255;  ///< cells a side
  std::uint16_t count(double size) const {
    return static_cast<std::uint16_t>(std::clamp(std::ceil(size / cell_), 1.0, kMost));
  }
  std::uint16_t row(double y) const { return at(y - origin_.y, rows_); }
  std::uint16_t column(double x) const { return at(x - origin_.x, columns_); }
  std::uint16_t at(double offset, std::uint16_t count) const {
    return static_cast<std::uint16_t>(std::clamp(offset / cell_, 0.0, count - 1.0));
  }
  template <class F>
  void for_each_cell(const Range& r, F&& f) {
    for (std::uint32_t i = r.row0; i <= r.row1; ++i)
      for (std::uint32_t j = r.column0; j <= r.column1; ++j) f(items_[static_cast<std::size_t>(i) * columns_ + j]);
  }

  Vec2 origin_;
  double cell_ = 1;
  std::uint16_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> items_;
};

}  // namespace inhabit::annealing
