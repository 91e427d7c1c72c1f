#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// (p_i, theta_i) -> (p_i + dp, theta_i), dp normal with sigma_p in x and y (Yu et al. 4.2); every fourth time with all
/// that belong to the object. What hangs on a wall is another move's (Slide).
struct Translate {
  static constexpr std::string_view kName = "translate";
  static constexpr double kShare = 0.4;
  static bool possible(const Furniture& f) { return !f.walkers.empty(); }
  template <class Before>
  static bool make(Arrangement& x, const Scale& scale, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng);
    const bool together = rng.index(4) == 0;
    if (!f.items[i].moves || f.items[i].hung) return false;
    double sigma = scale.position;
    if (f.items[i].carried && x.carrier(i) != kNobody) sigma = std::min(sigma, f.items[x.carrier(i)].radius / 2);
    const Vec2 shift = normal_shift(rng, sigma);
    const std::vector<std::uint32_t> others = touch_with(x, i, together);
    before();
    place_rigidly(x, i, others, within(f.room.extent(), x.position(i) + shift), x.angle(i));
    return true;
  }
};

}  // namespace inhabit::annealing
