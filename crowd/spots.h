#pragma once
#include <optional>

#include "crowd/world.h"

/// Where there is room for one more. Coordinates are relative to the world's origin.
namespace inhabit::crowd {

/// Who touches by less than this share of the radii does not touch: grids of people shoulder to shoulder are meant.
constexpr float kTouch = 1e-3f;

/// True when a disc stands on the floor and reaches into no wall. Requires: radius <= the walls' reach.
bool clear_of_walls(const Walls& walls, float x, float y, float radius);
/// True when two discs do not overlap.
inline bool apart(float dx, float dy, float radii) {
  const float least = radii * (1 - kTouch);
  return dx * dx + dy * dy >= least * least;
}

/// Discs that stand somewhere, found by place: lists in a square grid over the floor.
class Spots {
 public:
  /// `widest`: the largest radius that will be added or asked about.
  Spots(const World& world, double widest);

  /// Room for this disc: clear of walls and of everybody added so far.
  bool free(float x, float y, float radius) const;
  void add(float x, float y, float radius);
  std::size_t size() const { return discs_.size(); }
  /// Forgets whoever was added last, until `size` are left.
  void shrink(std::size_t size);

  /// The free place nearest to (x, y), on a lattice half a radius wide, at most `farthest` metres away, and in sight
  /// when (x, y) is on the floor itself: nobody is put through a wall. Takes one off `budget` for every place looked
  /// at, and gives up when none is left.
  std::optional<Vec2> nearest_free(float x, float y, float radius, double farthest, std::size_t& budget) const;

 private:
  struct Disc {
    float x = 0, y = 0, radius = 0;
    std::int32_t next = -1;  ///< in the same cell
  };
  std::int32_t column(float x) const { return index((x - min_x_) * inverse_cell_, columns_); }
  std::int32_t row(float y) const { return index((y - min_y_) * inverse_cell_, rows_); }
  static std::int32_t index(float at, std::int32_t count);
  std::int32_t& head(float x, float y);

  const Walls* walls_;
  float min_x_ = 0, min_y_ = 0, inverse_cell_ = 1, widest_ = 0;
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::int32_t> heads_;  ///< per cell, the disc added last; -1: none
  std::vector<Disc> discs_;
};

}  // namespace inhabit::crowd
