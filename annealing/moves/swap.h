#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// (p_i, theta_i) <-> (p_j, theta_j) for two objects of the same tier (Yu et al. 4.2), with all that they carry; those
/// of the second tier change their carriers too. What hangs on a wall stays.
struct Swap {
  static constexpr std::string_view kName = "swap";
  static constexpr double kShare = 0.1;
  static bool possible(const Furniture& f) { return f.walkers.size() > 1; }
  template <class Before>
  static bool make(Arrangement& x, const Scale&, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng), j = any_walker(f, rng);
    const Item &a = f.items[i], &b = f.items[j];
    if (i == j || !(a.moves && a.turns && b.moves && b.turns) || a.hung || b.hung || a.carried != b.carried)
      return false;
    const std::uint32_t on_a = x.carrier(i), on_b = x.carrier(j);
    const bool changes = a.carried && on_a != on_b;
    if (changes &&
        !(std::ranges::binary_search(f.carriers[i], on_b) && std::ranges::binary_search(f.carriers[j], on_a)))
      return false;
    const Vec2 p = x.position(i), q = x.position(j);
    const double at_p = x.angle(i), at_q = x.angle(j);
    x.touch(i), x.touch(j);
    before();
    if (changes) x.carry(i, on_b), x.carry(j, on_a);
    x.place(i, q, at_q), x.place(j, p, at_p);
    return true;
  }
};

}  // namespace inhabit::annealing
