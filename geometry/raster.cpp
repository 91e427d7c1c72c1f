#include "geometry/raster.h"

#include <algorithm>

namespace inhabit::geometry {

Raster make_raster(const Bounds& area, double cell, std::size_t most) {
  Raster raster;
  const Vec2 size = area.size();
  raster.origin = area.min;
  raster.cell = std::max(cell, std::sqrt(size.x * size.y / static_cast<double>(most)));
  // The border may add a row and a column to the quotient, so the cells grow until they fit.
  for (;; raster.cell *= 1.01) {
    const double columns = std::max(1.0, std::ceil(size.x / raster.cell - 1e-9));
    const double rows = std::max(1.0, std::ceil(size.y / raster.cell - 1e-9));
    if (columns * rows > static_cast<double>(most)) continue;
    raster.columns = static_cast<int>(columns);
    raster.rows = static_cast<int>(rows);
    break;
  }
  raster.values.assign(static_cast<std::size_t>(raster.columns) * raster.rows, 0);
  return raster;
}

void fill(Raster& raster, std::span<const Vec2> ring, std::uint8_t value) {
  const Bounds b = bounds(ring);
  const detail::CellRange r = detail::cells(raster, b);
  std::vector<double> crossings;
  for (int row = r.row0; row <= r.row1; ++row) {
    // Where the row's centre line crosses the sides; between odd and even crossings it is inside.
    const double y = raster.center(0, row).y;
    crossings.clear();
    Vec2 p = ring.back();
    for (const Vec2 q : ring) {
      if ((p.y > y) != (q.y > y)) crossings.push_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
      p = q;
    }
    std::ranges::sort(crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double from = std::ceil((crossings[k] - raster.origin.x) / raster.cell - 0.5);
      const double to = std::floor((crossings[k + 1] - raster.origin.x) / raster.cell - 0.5);
      const int first = static_cast<int>(std::clamp(from, 0.0, static_cast<double>(raster.columns)));
      const int last = static_cast<int>(std::clamp(to, -1.0, raster.columns - 1.0));
      if (first <= last)
        std::fill(raster.values.begin() + static_cast<std::ptrdiff_t>(raster.at(first, row)),
                  raster.values.begin() + static_cast<std::ptrdiff_t>(raster.at(last, row)) + 1, value);
    }
  }
}

Components components(const Raster& raster, std::uint8_t value) {
  Components parts;
  parts.label.assign(raster.values.size(), -1);
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int column, int row, std::int32_t label) {
    const std::size_t k = raster.at(column, row);
    if (raster.values[k] != value || parts.label[k] >= 0) return;
    parts.label[k] = label;
    ++parts.size[static_cast<std::size_t>(label)];
    open.emplace_back(column, row);
  };
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      if (raster.values[raster.at(column, row)] != value || parts.label[raster.at(column, row)] >= 0) continue;
      const auto label = static_cast<std::int32_t>(parts.size.size());
      parts.size.push_back(0);
      visit(column, row, label);
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, raster.rows - 1); ++v)
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, raster.columns - 1); ++u) visit(u, v, label);
      }
    }
  return parts;
}

namespace detail {

CellRange cells(const Raster& raster, const Bounds& area) {
  const auto low = [&](double offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / raster.cell), 0.0, static_cast<double>(count)));
  };
  const auto high = [&](double offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / raster.cell), -1.0, count - 1.0));
  };
  return {low(area.min.x - raster.origin.x, raster.columns), high(area.max.x - raster.origin.x, raster.columns),
          low(area.min.y - raster.origin.y, raster.rows), high(area.max.y - raster.origin.y, raster.rows)};
}

}  // namespace detail
}  // namespace inhabit::geometry
