#pragma once
#include "annealing/arrangement.h"

namespace inhabit::annealing {

/// Metres that a touch counts in itself: at the end no overlap is too small to be worth leaving.
constexpr double kTouch = 0.05;
constexpr double kNothing = 1e-4;  ///< metres of overlap that nobody sees (`check` lets pass ten times that)

/// Deviation: a term of its own for bodies that intersect, which "must not" (annealing.md); the depth of the
/// separating-axis test where heights overlap, and kTouch. The paper leaves it to accessible spaces, which only tend to
/// keep bodies apart.
struct Overlap {
  static constexpr std::string_view kName = "overlap";
  static double weight(const Weights& w) { return w.overlap; }
  static double of_items(const Arrangement& x, std::uint32_t i, std::uint32_t j) {
    const Furniture& f = x.furniture();
    const Solid &a = x.body(i), &b = x.body(j);
    const Vec2 d = a.box.center - b.box.center;
    const double reach = f.items[i].radius + f.items[j].radius;
    if (dot(d, d) >= reach * reach || !share_height(a, b)) return 0;
    if (f.may_overlap(i, j) || x.carrier(i) == j || x.carrier(j) == i) return 0;
    const double depth = separation(a.box, b.box).depth;
    return depth > kNothing ? depth + kTouch : 0;
  }
};

/// Deviation: objects stay in the room, out of its pillars, and on what carries them; the depth of what sticks out, and
/// kTouch. The paper says only that second-tier objects move "on the supporting surfaces".
struct Inside {
  static constexpr std::string_view kName = "inside";
  static double weight(const Weights& w) { return w.inside; }
  static double of_item(const Arrangement& x, std::uint32_t i) {
    const Furniture& f = x.furniture();
    const Item& item = f.items[i];
    if (!item.moves) return 0;  // stands as it is given
    double sum = 0;
    if (item.carried && x.carrier(i) != kNobody) {
      // Its box stays on the top where it fits, its centre where it does not (as layout's stacking).
      const Box &top = x.body(x.carrier(i)).box, &box = x.body(i).box;
      const Vec2 local = rotate_back(box.center - top.center, top.front);
      const double beyond_x = std::abs(local.x) - std::max(0.0, top.half_depth - box.extent(top.front));
      const double beyond_y = std::abs(local.y) - std::max(0.0, top.half_width - box.extent(top.left()));
      sum = std::max(beyond_x, 0.0) + std::max(beyond_y, 0.0);
    } else {
      f.room.for_each_violation(x.body(i).box, [&](Vec2, double depth) { sum += depth; });
    }
    return sum > kNothing ? sum + kTouch : 0;
  }
};

}  // namespace inhabit::annealing
