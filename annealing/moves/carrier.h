#pragma once
#include "annealing/move.h"

namespace inhabit::annealing {

/// "A second-tier object changes its first-tier parent" (Yu et al. 3.1): to another that may carry it, at the same
/// place and heading in that one's frame, with its base on that one's top.
struct ChangeCarrier {
  static constexpr std::string_view kName = "carrier";
  static constexpr double kShare = 0.05;
  static bool possible(const Furniture& f) {
    return std::ranges::any_of(f.carriers, [](const auto& list) { return list.size() > 1; });
  }
  template <class Before>
  static bool make(Arrangement& x, const Scale&, Rng& rng, Before&& before) {
    const Furniture& f = x.furniture();
    const std::uint32_t i = any_walker(f, rng);
    const auto& carriers = f.carriers[i];
    if (!f.items[i].moves || !f.items[i].carried || carriers.size() < 2) return false;
    const std::uint32_t from = x.carrier(i), to = carriers[rng.index(static_cast<std::uint32_t>(carriers.size()))];
    if (to == from || to == i) return false;
    const Box &old_top = x.body(from).box, &new_top = x.body(to).box;
    const Vec2 local = rotate_back(x.position(i) - old_top.center, old_top.front);
    const double angle = wrap_angle(x.angle(i) - x.angle(from) + x.angle(to));
    x.touch(i);
    before();
    x.carry(i, to);
    x.place(i, new_top.center + rotate(local, new_top.front), f.items[i].turns ? angle : x.angle(i));
    return true;
  }
};

}  // namespace inhabit::annealing
