#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec2.h"

/// Distances on foot over a grid: the eikonal equation |grad T| = cost, solved by fast marching.
namespace inhabit::geometry {

/// Square cells; what is said of a cell is said of its centre. Cell (0, 0) is the lowest left one.
struct Lattice {
  Vec2 origin;      ///< lower left corner of cell (0, 0)
  double cell = 1;  ///< metres
  std::int32_t columns = 0, rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t at(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  std::int32_t column_of(std::size_t k) const {
    return static_cast<std::int32_t>(k % static_cast<std::size_t>(columns));
  }
  std::int32_t row_of(std::size_t k) const { return static_cast<std::int32_t>(k / static_cast<std::size_t>(columns)); }
  Vec2 center(std::int32_t column, std::int32_t row) const {
    return {origin.x + (column + 0.5) * cell, origin.y + (row + 0.5) * cell};
  }
  Vec2 center(std::size_t k) const { return center(column_of(k), row_of(k)); }
};

/// A cell whose distance is known.
struct MarchSeed {
  std::uint32_t cell = 0;
  float distance = 0;  ///< metres
};

/// T of every cell, metres: seeds have theirs (the smallest, where a cell is given twice), all others follow by
/// |grad T| = cost. Cells of infinite cost are closed; they and what no way leads to are infinite. Second-order upwind
/// differences (Sethian's fast marching with his second-order scheme) where two known cells stand in a row,
/// first order elsewhere. Ties are broken by the cell's number. Cost O(n log n). Requires: one cost > 0 for each cell.
std::vector<float> march(const Lattice& lattice, std::span<const float> cost, std::span<const MarchSeed> seeds);

/// The unit vector of steepest descent of T at a cell, by the differences that march() solved with; the null vector
/// where T is infinite or no neighbour is lower.
Vec2 descent(const Lattice& lattice, std::span<const float> distance, std::size_t cell);

}  // namespace inhabit::geometry
