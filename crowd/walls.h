#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/containment.h"

/// Everything that people cannot walk through: the borders of the floor, as segments in a grid.
namespace inhabit::crowd {
using namespace core;
using namespace geometry;

/// A piece of a border; the floor is on its left.
struct WallSegment {
  float ax = 0, ay = 0, bx = 0, by = 0;
};

/// The nearest point of a segment to (x, y), and the segment's inward normal.
struct WallPoint {
  float x = 0, y = 0;
};
inline WallPoint nearest_point(const WallSegment& s, float x, float y) {
  const float dx = s.bx - s.ax, dy = s.by - s.ay;
  const float dd = dx * dx + dy * dy;
  float t = dd > 0 ? ((x - s.ax) * dx + (y - s.ay) * dy) / dd : 0.0f;
  t = t < 0 ? 0.0f : t > 1 ? 1.0f : t;
  return {s.ax + t * dx, s.ay + t * dy};
}

class Walls {
 public:
  Walls() = default;
  /// The borders of `floors` (outline and holes), seen from `origin`. `reach`: the farthest that near() will be asked
  /// about, metres; it decides the grid.
  Walls(const std::vector<Floor>& floors, Vec2 origin, double reach);

  bool empty() const { return segments_.empty(); }
  std::span<const WallSegment> segments() const { return segments_; }

  /// Calls f(segment, index) once for each segment that may be within `reach` of (x, y), in order of index.
  template <class F>
  void for_each_near(float x, float y, F&& f) const {
    for (const std::uint32_t k : near(x, y)) f(segments_[k], k);
  }
  /// Indices of the segments that may be within the reach of (x, y), ascending: those that meet the cell grown by
  /// reach.
  std::span<const std::uint32_t> near(float x, float y) const;

  /// True where no wall is within the reach and the floor is all around: one look at a byte. Never true for numbers
  /// that are no numbers.
  bool in_the_open(float x, float y) const {
    std::uint8_t flag = 0;
    in_the_open({&x, 1}, {&y, 1}, {&flag, 1});
    return flag != 0;
  }
  /// The same for many: flags[k] is 1 or 0.
  void in_the_open(std::span<const float> x, std::span<const float> y, std::span<std::uint8_t> flags) const;
  /// True when the way from a, which is on the floor, to b leaves the floor. Standing on a border is on the floor.
  /// Exact for the floats given. Requires: |b - a| <= the reach.
  bool leaves(float ax, float ay, float bx, float by) const;

  /// The reach that it was made for, metres.
  float reach() const { return reach_; }

  /// True on a floor, borders included. Walls that are empty allow everything.
  bool on_floor(float x, float y) const;
  /// True when the straight way from a to b meets no wall and both ends are on the floor.
  bool sees(float ax, float ay, float bx, float by) const;

 private:
  std::vector<WallSegment> segments_;
  float min_x_ = 0, min_y_ = 0, inverse_cell_ = 1;
  float reach_ = 0;
  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_, items_;  ///< per cell, the segments near it
  /// What a cell is: nothing, floor, crossed by a border (ask the floors), floor without a wall in reach.
  enum : std::uint8_t { kSolid, kFloor, kBorder, kOpen };
  std::vector<std::uint8_t> inside_;  ///< per cell
  std::vector<Floor> floors_;         ///< seen from the origin
};

}  // namespace inhabit::crowd
