#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// Object a looks at `to` (plus an angle), or runs parallel to it.
///
///   C = theta_a - (bearing from a to `to` + angle),  or  theta_a - (theta_to + angle)      [TVCG eq. 16]
///
/// Only a turns, by the shortest way; positions stay (TVCG 3.3.10). Coincident objects ask for nothing.
struct OrientationTerm : Term {
  Anchor a, to;
  bool parallel = false;
  double angle = 0;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant, .angular = true, .stiffness = 1};
};

inline double error(const OrientationTerm& c, const State& x) {
  if (c.parallel) return wrap_angle(x.angle(c.a) - x.angle(c.to) - c.angle);
  const Vec2 d = x.position(c.to) - x.position(c.a);
  return d == Vec2{} ? 0 : wrap_angle(x.angle(c.a) - angle_of(d) - c.angle);
}

template <class Sink>
void project(const OrientationTerm& c, const State& x, double k, Sink& sink) {
  if (!x.turns(c.a)) return;
  const double e = error(c, x);
  if (std::abs(e) > kStill) sink.turn(c.a, -k * e);
}

template <class F>
void anchors(const OrientationTerm& c, F f) {
  f(c.a), f(c.to);
}

template <class Out>
void expand(const scene::Orientation& c, Out& out) {
  OrientationTerm term;
  term.to = out.anchor(c.to), term.angle = c.angle, term.parallel = c.relative == 1;
  for (const Ref m : out.members(c.members)) {
    term.a = out.anchor(m);
    out.add(term, m, c.to);
  }
}

}  // namespace inhabit::layout
