#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// (p_i, theta_i) -> (p_i, theta_i + dtheta), dtheta normal with sigma_theta (Yu et al. 4.2); every fourth time with
/// all that belong to the object, round its centre.
struct Rotate {
  static constexpr std::string_view kName = "rotate";
  static constexpr double kShare = 0.2;
  static bool possible(const Furniture& f) { return !f.walkers.empty(); }
  template <class Before>
  static bool make(Arrangement& x, const Scale& scale, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng);
    const bool together = rng.index(4) == 0;
    if (!f.items[i].turns || f.items[i].hung) return false;
    const double turn = scale.angle * core::standard_normal(rng);
    const std::vector<std::uint32_t> others = touch_with(x, i, together);
    before();
    place_rigidly(x, i, others, x.position(i), wrap_angle(x.angle(i) + turn));
    return true;
  }
};

}  // namespace inhabit::annealing
