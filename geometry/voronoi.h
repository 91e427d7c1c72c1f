#pragma once
#include <optional>
#include <span>
#include <vector>

#include "geometry/containment.h"
#include "geometry/overlay.h"

namespace inhabit::geometry {

/// The ground that is shared out among points: everybody gets what is nearer to them than to anybody else.
class VoronoiGround {
 public:
  /// `walkable` empty: the plane, and then `cut_off` must be > 0. `cut_off`: nobody's cell reaches farther than a disc
  /// of this radius, metres (a regular polygon of kCutOffCorners corners with the disc's area); 0: no limit.
  explicit VoronoiGround(std::vector<Area> walkable, double cut_off = 0);
  static constexpr int kCutOffCorners = 32;

  /// One cell for each point: of the part of the ground that is nearest to the point, the connected piece that the
  /// point is in. A cell is convex except at reflex corners of the ground. Points that do not stand on the ground get
  /// an empty cell and take nothing from the others; points at the same place get the same cell each. Exact but for
  /// rounding (1e-9 m). Cost O(n k) for k neighbours of a cell; cells at reflex corners are cut by GEOS and cost some
  /// 30 µs.
  std::vector<Area> cells(std::span<const Vec2> points) const;
  /// The same, but cells that surely do not meet `where` stay empty: who is farther from it than its farthest place is
  /// from anybody owns none of it.
  std::vector<Area> cells_meeting(std::span<const Vec2> points, const Bounds& where) const;

  const std::vector<Area>& walkable() const { return walkable_; }
  bool on_ground(Vec2 p) const;

 private:
  struct Wall {
    Vec2 a, b;  ///< the ground is on its left
  };
  class Cutter;
  std::vector<Area> cells(std::span<const Vec2> points, const Bounds* where) const;

  std::vector<Area> walkable_;
  double cut_off_ = 0;
  std::vector<Floor> floors_;
  std::vector<Wall> walls_;
  Ring start_;  ///< the cut-off round the origin, or empty
  Bounds bounds_;
};

}  // namespace inhabit::geometry
