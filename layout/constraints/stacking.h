#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// One object on another: centred on it, or anywhere on its top.
///
///   C = p_upper - p_lower = 0 in x and y                            [TVCG eq. 19]
///
/// z needs no projection: z_upper = z_lower + h_lower (TVCG eq. 18, with z the base here) is set once, since nothing
/// else moves objects vertically. `anywhere`: the box of the upper object stays on the top of the lower one where it
/// fits, otherwise its centre does.
struct StackingTerm : Term {
  Anchor upper, lower;
  bool anywhere = false;
  Vec3 upper_size, lower_size;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant, .stiffness = 1};
};

namespace detail {
/// From where the upper object should be to where it is.
inline Vec2 stacking_offset(const StackingTerm& c, const State& x) {
  const Vec2 d = x.position(c.upper) - x.position(c.lower);
  if (!c.anywhere) return d;
  const Vec2 f = x.front(c.lower), local = rotate_back(d, f);
  const Box upper{{}, x.front(c.upper), c.upper_size.y / 2, c.upper_size.x / 2};
  const double rx = std::max(0.0, c.lower_size.y / 2 - upper.extent(f));
  const double ry = std::max(0.0, c.lower_size.x / 2 - upper.extent(perp(f)));
  return rotate({local.x - std::clamp(local.x, -rx, rx), local.y - std::clamp(local.y, -ry, ry)}, f);
}
}  // namespace detail

inline double error(const StackingTerm& c, const State& x) { return length(detail::stacking_offset(c, x)); }

template <class Sink>
void project(const StackingTerm& c, const State& x, double k, Sink& sink) {
  const Vec2 off = detail::stacking_offset(c, x);
  const double d = length(off);
  if (d > 0) part(c.upper, c.lower, x.w(c.upper), x.w(c.lower), (1 / d) * off, k * d, sink);
}

template <class F>
void anchors(const StackingTerm& c, F f) {
  f(c.upper), f(c.lower);
}

template <class Out>
void expand(const scene::Stacking& c, Out& out) {
  StackingTerm term;
  term.upper = out.anchor(c.object), term.lower = out.anchor(c.on);
  term.upper_size = out.size(c.object), term.lower_size = out.size(c.on);
  term.anywhere = c.anywhere;
  out.add(term, c.object, c.on);
}

}  // namespace inhabit::layout
