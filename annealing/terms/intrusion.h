#pragma once
#include "annealing/arrangement.h"

namespace inhabit::annealing {

/// How far item i is inside space k of item j, when their boxes meet and so do their heights:
///
///   max(0, 1 - |p_i - a_jk| / (b_i + ad_jk))                        [Yu11 eq. 4, 5]
///
/// b and ad are half diagonals. Deviation: what belongs together (a pair, a rigid group, an object and what it carries)
/// may stand in each other's spaces, as `check` has it: a chair at its desk would otherwise be pushed away by one term
/// and drawn in by another.
inline double intrusion(const Arrangement& x, std::uint32_t i, std::uint32_t s) {
  const Furniture& f = x.furniture();
  const Space& space = f.spaces[s];
  const Solid &body = x.body(i), &free = x.space(s);
  const Vec2 d = body.box.center - free.box.center;
  // Parts of a pathway grow and shrink with it.
  const double reach = f.items[i].radius + (space.kind == Space::Kind::path ? free.box.radius() : space.radius);
  const double square = dot(d, d);
  if (square >= reach * reach || space.owner == i || !share_height(body, free)) return 0;
  if (space.owner != kNobody && (f.bound(i, space.owner) || x.carrier(i) == space.owner || x.carrier(space.owner) == i))
    return 0;
  if (separation(body.box, free.box).depth <= 0) return 0;
  return 1 - std::sqrt(square) / reach;
}

}  // namespace inhabit::annealing
