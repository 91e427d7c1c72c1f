#pragma once
#include <cstdint>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// Square cells over a rectangle; a cell stands for its centre. Row 0 lies at the lowest y.
struct Raster {
  Vec2 origin;         ///< lower left corner of cell (0, 0)
  double cell = 0.02;  ///< side, metres
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> values;

  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
  Vec2 center(int column, int row) const { return {origin.x + (column + 0.5) * cell, origin.y + (row + 0.5) * cell}; }
};

/// A raster of zeros over `area` whose cells are `cell` metres, or as much larger as it takes to need at most `most`
/// cells.
Raster make_raster(const Bounds& area, double cell, std::size_t most);

/// Sets the cells whose centres lie inside the ring (even-odd rule; not necessarily convex or simple).
void fill(Raster& raster, std::span<const Vec2> ring, std::uint8_t value);

/// Calls f(column, row) for every cell whose centre is nearer than `radius` to the box, or inside it.
template <class F>
void for_each_near(const Raster& raster, const Box& box, double radius, F&& f);
/// The same for the segment ab.
template <class F>
void for_each_near(const Raster& raster, Vec2 a, Vec2 b, double radius, F&& f);

/// The connected parts of the cells that hold `value`; diagonal neighbours are connected.
struct Components {
  std::vector<std::int32_t> label;  ///< per cell: -1 for other values, else the part's number in order of first cells
  std::vector<std::size_t> size;    ///< cells per part
};
Components components(const Raster& raster, std::uint8_t value);

namespace detail {
struct CellRange {
  int column0, column1, row0, row1;
};
CellRange cells(const Raster& raster, const Bounds& area);
}  // namespace detail

template <class F>
void for_each_near(const Raster& raster, const Box& box, double radius, F&& f) {
  const Vec2 half{box.extent({1, 0}) + radius, box.extent({0, 1}) + radius};
  const detail::CellRange r = detail::cells(raster, {box.center - half, box.center + half});
  for (int row = r.row0; row <= r.row1; ++row)
    for (int column = r.column0; column <= r.column1; ++column) {
      const Vec2 d = rotate_back(raster.center(column, row) - box.center, box.front);
      const double x = std::max(std::abs(d.x) - box.half_depth, 0.0), y = std::max(std::abs(d.y) - box.half_width, 0.0);
      if (x * x + y * y < radius * radius || (x == 0 && y == 0)) f(column, row);
    }
}

template <class F>
void for_each_near(const Raster& raster, Vec2 a, Vec2 b, double radius, F&& f) {
  const Vec2 middle = 0.5 * (a + b), d = b - a;
  const Box line{middle, unit(d), length(d) / 2, 0};
  for_each_near(raster, line, radius, f);
}

}  // namespace inhabit::geometry
