#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// Two centres apart by a distance in [low, high] metres; an equality when both are the same.
///
///   C = |p_a - p_b| - d                                             [TVCG eq. 4-6]
///
/// The focal distance (TVCG 3.3.2) is the same for every member; its focal object may be pinned. Coincident centres are
/// parted along a fixed direction.
struct DistanceTerm : Term {
  Anchor a, b;
  bool b_pinned = false;
  double low = 0, high = 0;
  static constexpr TermTraits kTraits{};
};

inline double error(const DistanceTerm& c, const State& x) {
  const double d = length(x.position(c.a) - x.position(c.b));
  return d < c.low ? d - c.low : d > c.high ? d - c.high : 0;
}

template <class Sink>
void project(const DistanceTerm& c, const State& x, double k, Sink& sink) {
  const Vec2 v = x.position(c.a) - x.position(c.b);
  const double d = length(v);
  const double e = d < c.low ? d - c.low : d > c.high ? d - c.high : 0;
  if (e == 0) return;
  const Vec2 n = d > 1e-9 ? (1 / d) * v : tie_break(c.a.body, c.b.body);
  part(c.a, c.b, x.w(c.a), c.b_pinned ? 0 : x.w(c.b), n, k * e, sink);
}

template <class F>
void anchors(const DistanceTerm& c, F f) {
  f(c.a), f(c.b);
}

template <class Scene, class Out>
void expand_distance(const Scene& c, Ref a, Ref b, bool b_pinned, Out& out) {
  DistanceTerm term;
  term.a = out.anchor(a), term.b = out.anchor(b);
  term.low = c.distance.value_or(c.min.value_or(0));
  term.high = c.distance.value_or(c.max.value_or(1e300));
  term.b_pinned = b_pinned;
  out.add(term, a, b);
}

template <class Out>
void expand(const scene::Distance& c, Out& out) {
  expand_distance(c, c.between[0], c.between[1], false, out);
}

template <class Out>
void expand(const scene::FocalDistance& c, Out& out) {
  for (const Ref m : out.members(c.members)) expand_distance(c, m, c.focal, c.focal_fixed, out);
}

}  // namespace inhabit::layout
