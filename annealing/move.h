#pragma once
#include "annealing/arrangement.h"
#include "core/distributions.h"

namespace inhabit::annealing {

/// How large moves are at this temperature. Yu et al. 4.2: "variances … proportional to the temperature"; deviation:
/// the standard deviations are (annealing.md), so that the last moves are millimetres where the first cross the room.
struct Scale {
  double position = 1;  ///< sigma_p, metres
  double angle = 1;     ///< sigma_theta, radians
};

/// The centre of what is put back inside the room's extent: a move beyond the walls has no chance.
inline Vec2 within(const Bounds& extent, Vec2 p) {
  return {std::clamp(p.x, extent.min.x, extent.max.x), std::clamp(p.y, extent.min.y, extent.max.y)};
}

inline Vec2 normal_shift(Rng& rng, double sigma) {
  const double x = sigma * core::standard_normal(rng);
  return {x, sigma * core::standard_normal(rng)};
}

/// Some item that can be moved on its own; kNobody when there is none.
inline std::uint32_t any_walker(const Furniture& f, Rng& rng) {
  return f.walkers.empty() ? kNobody : f.walkers[rng.index(static_cast<std::uint32_t>(f.walkers.size()))];
}

/// An item with those that belong to it (chairs to their table), which may be moved as one: "an object i or a subset of
/// objects" (Yu et al. 4.2).
template <class F>
void for_each_partner(const Arrangement& x, std::uint32_t i, F&& f) {
  const Furniture& furniture = x.furniture();
  for (const std::uint32_t r : furniture.relations_of[i]) {
    const Relation& c = furniture.relations[r];
    const Item& other = furniture.items[c.second];
    if (c.first == i && other.moves && other.turns && !other.attached && !other.carried) f(c.second);
  }
}

/// Turns and shifts an item and, rigidly with it, the others given. Requires: all are touched.
inline void place_rigidly(Arrangement& x, std::uint32_t i, std::span<const std::uint32_t> others, Vec2 p,
                          double angle) {
  const Vec2 from = x.position(i);
  const double turn = wrap_angle(angle - x.angle(i));
  const Vec2 r = direction(turn);
  x.place(i, p, angle);
  for (const std::uint32_t k : others)
    x.place(k, p + rotate(x.position(k) - from, r), turn == 0 ? x.angle(k) : wrap_angle(x.angle(k) + turn));
}

/// Touches an item and, when they are to move `together`, its partners; returns the partners that do not go with it
/// anyway.
inline std::vector<std::uint32_t> touch_with(Arrangement& x, std::uint32_t i, bool together) {
  std::vector<std::uint32_t> others;
  x.touch(i);
  if (!together) return others;
  for_each_partner(x, i, [&](std::uint32_t k) {
    if (x.touched(k)) return;
    x.touch(k);
    others.push_back(k);
  });
  return others;
}

/// Where something with its back `gap` away stands on a wall, `along` metres from its first corner.
inline Pose pose_at_wall(const Wall& wall, double along, double gap, double back_half, double back_turn, double turn) {
  const double angle = wrap_angle(wall.angle + turn - back_turn);
  const Vec2 away = direction(angle + back_turn);
  // The back face's centre is `gap` from the wall, the centre back_half further along the turned heading.
  return {wall.a + along * wall.along + gap * wall.normal + back_half * away, angle};
}

/// A wall by its length, and a place along it.
struct WallSpot {
  std::uint32_t wall = 0;
  double along = 0;
};
inline WallSpot any_wall_spot(const Furniture& f, Rng& rng) {
  const double at = rng.uniform() * f.wall_sums.back();
  std::uint32_t k = 0;
  while (k + 1 < f.wall_sums.size() && f.wall_sums[k] <= at) ++k;
  return {k, at - (k == 0 ? 0 : f.wall_sums[k - 1])};
}

}  // namespace inhabit::annealing
