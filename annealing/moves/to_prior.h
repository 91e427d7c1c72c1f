#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// Takes an object to where its own prior costs nothing: to some place along the walls at the learned distance and
/// angle, or round its partner as learned; or, every second time, only turns it so where it is. An addition to the
/// paper's moves: which of such places is free remains for the cost to say.
struct ToPrior {
  static constexpr std::string_view kName = "to prior";
  static constexpr double kShare = 0.15;
  static bool possible(const Furniture& f) { return !f.walkers.empty(); }
  template <class Before>
  static bool make(Arrangement& x, const Scale&, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng);
    const Item& item = f.items[i];
    const bool turns_only = rng.index(2) == 0;
    if (!item.moves || !item.turns || item.hung) return false;
    Pose pose{x.position(i), x.angle(i)};
    if (const Relation* r = relation_of(f, i)) {
      pose = turns_only ? Pose{pose.p, facing(x, *r, pose.p)} : beside(x, *r, rng);
    } else if (item.has_wall) {
      const WallSpot spot = any_wall_spot(f, rng);
      if (turns_only) {
        const Vec2 away = direction(pose.angle + item.back_turn);
        const WallPoint w = f.room.nearest_wall(pose.p - item.back_half * away);
        pose.angle = wrap_angle(f.room.walls()[w.wall].angle + item.wall_angle - item.back_turn);
      } else {
        pose = pose_at_wall(f.room.walls()[spot.wall], spot.along, item.wall_distance, item.back_half, item.back_turn,
                            item.wall_angle);
      }
    } else {
      return false;
    }
    const std::vector<std::uint32_t> others = touch_with(x, i, true);
    before();
    place_rigidly(x, i, others, within(f.room.extent(), pose.p), pose.angle);
    return true;
  }

 private:
  static const Relation* relation_of(const Furniture& f, std::uint32_t i) {
    for (const std::uint32_t r : f.relations_of[i])
      if (f.relations[r].second == i) return &f.relations[r];
    return nullptr;
  }
  static double facing(const Arrangement& x, const Relation& r, Vec2 p) {
    return wrap_angle(angle_of(x.position(r.first) - p) + r.facing);
  }
  static Pose beside(const Arrangement& x, const Relation& r, Rng& rng) {
    const double any = rng.uniform(-kPi, kPi);
    const double bearing = r.bearing_strength > 0.5 ? x.angle(r.first) + r.bearing : any;
    const Vec2 p = x.position(r.first) + r.distance * direction(bearing);
    return {p, facing(x, r, p)};
  }
};

}  // namespace inhabit::annealing
