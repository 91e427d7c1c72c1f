#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// "The translation of a pathway control point" (Yu et al. 4.2): one of the inner two; the ends stay in their doors.
struct PathPoint {
  static constexpr std::string_view kName = "pathway point";
  static constexpr double kShare = 0.1;
  static bool possible(const Furniture& f) { return !f.paths.empty(); }
  template <class Before>
  static bool make(Arrangement& x, const Scale& scale, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t path = rng.index(static_cast<std::uint32_t>(f.paths.size())), k = rng.index(2);
    ControlPoints points = x.points(path);
    points[k] = within(f.room.extent(), points[k] + normal_shift(rng, scale.position));
    x.touch_path(path);
    before();
    x.set_points(path, points);
    return true;
  }
};

}  // namespace inhabit::annealing
