#pragma once
#include "annealing/arrangement.h"

namespace inhabit::annealing {
namespace detail {

struct AtWall {
  double distance = 0, angle = 0;
};
/// How an item stands to its nearest wall: the distance of its back face's centre, and the heading of the face opposite
/// to it from the wall's inward normal.
inline AtWall at_wall(const Arrangement& x, std::uint32_t i) {
  const Item& item = x.furniture().items[i];
  const Box& box = x.body(i).box;
  const Vec2 away = item.back_turn == 0 ? box.front : rotate(box.front, direction(item.back_turn));
  const WallPoint w = x.furniture().room.nearest_wall(box.center - item.back_half * away);
  return {w.distance, wrap_angle(x.angle(i) + item.back_turn - x.furniture().room.walls()[w.wall].angle)};
}

}  // namespace detail

/// C_pr^d: the distance to the nearest wall is the one that was learned, |d_i - d_i mean| [Yu11 eq. 6].
///
/// Deviation: from the back face's centre instead of the object's, so that the mean holds for every depth.
struct PriorDistance {
  static constexpr std::string_view kName = "wall distance";
  static double weight(const Weights& w) { return w.learned.wall_distance; }
  static double of_item(const Arrangement& x, std::uint32_t i) {
    const Item& item = x.furniture().items[i];
    return item.has_wall ? std::abs(detail::at_wall(x, i).distance - item.wall_distance) : 0;
  }
};

/// C_pr^theta: so is the angle to it, |theta_i - theta_i mean|, the shorter way round [Yu11 eq. 7].
///
/// Deviation: angles whose examples disagree count less (angle_strength).
struct PriorAngle {
  static constexpr std::string_view kName = "wall angle";
  static double weight(const Weights& w) { return w.learned.wall_angle; }
  static double of_item(const Arrangement& x, std::uint32_t i) {
    const Item& item = x.furniture().items[i];
    if (!item.has_wall || item.wall_angle_strength <= 0) return 0;
    return item.wall_angle_strength * std::abs(wrap_angle(detail::at_wall(x, i).angle - item.wall_angle));
  }
};

}  // namespace inhabit::annealing
