#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// What hangs on a wall and may move stays on walls with its back to them: along its own by sigma_p, or, every eighth
/// time, to some place of any wall. The paper leaves such objects where they are.
struct Slide {
  static constexpr std::string_view kName = "slide";
  static constexpr double kShare = 0.1;
  static bool possible(const Furniture& f) {
    return std::ranges::any_of(f.walkers, [&](std::uint32_t i) { return f.items[i].hung; });
  }
  static void hang(Arrangement& x, std::uint32_t i, const WallSpot& spot) {
    const Item& item = x.furniture().items[i];
    const Wall& wall = x.furniture().room.walls()[spot.wall];
    // No further than where it still hangs on the wall, should it be long enough.
    const double edge = std::min(item.half_width, wall.length / 2);
    const Pose pose = pose_at_wall(wall, std::clamp(spot.along, edge, wall.length - edge), 0, item.half_depth, 0, 0);
    x.place(i, pose.p, pose.angle);
  }
  template <class Before>
  static bool make(Arrangement& x, const Scale& scale, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng);
    const bool far = rng.index(8) == 0;
    if (!f.items[i].moves || !f.items[i].hung) return false;
    WallSpot spot;
    if (far) {
      spot = any_wall_spot(f, rng);
    } else {
      const Box& box = x.body(i).box;
      const WallPoint at = f.room.nearest_wall(box.center - box.half_depth * box.front);
      const Wall& wall = f.room.walls()[at.wall];
      spot = {at.wall, dot(at.point - wall.a, wall.along) + scale.position * core::standard_normal(rng)};
    }
    x.touch(i);
    before();
    hang(x, i, spot);
    return true;
  }
};

}  // namespace inhabit::annealing
