#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// A member's centre stays out of a lane that starts at another object.
///
///   C = |p - v(p)| - d >= 0,  v(p) the nearest point of the ray from p_j along theta_j + angle     [TVCG eq. 7, 8]
///
/// v(p) is a ghost rigidly attached to j and shares its inverse mass (0 to leave j alone). Deviation: behind the start
/// of the ray the nearest point is p_j itself, where the print projects onto the whole line. A centre exactly on the
/// lane leaves to the left.
struct TrafficLaneTerm : Term {
  Anchor member, from;
  bool from_fixed = true;
  Vec2 heading;  ///< of the lane, in the frame of `from`
  double clearance = 0;
  static constexpr TermTraits kTraits{};
};

namespace detail {
struct LaneOffset {
  Vec2 n;          ///< from the lane to the member
  double gap = 0;  ///< distance less clearance; 0 when that is positive
};
inline LaneOffset lane_offset(const TrafficLaneTerm& c, const State& x) {
  const Vec2 start = x.position(c.from), v = rotate(c.heading, x.front(c.from));
  const Vec2 p = x.position(c.member);
  const Vec2 r = p - (start + std::max(0.0, dot(p - start, v)) * v);
  const double square = dot(r, r);
  if (square >= c.clearance * c.clearance) return {};  // most members, most of the time: no root
  const double d = std::sqrt(square);
  return {d > 1e-9 ? (1 / d) * r : perp(v), d - c.clearance};
}
}  // namespace detail

inline double error(const TrafficLaneTerm& c, const State& x) { return detail::lane_offset(c, x).gap; }

template <class Sink>
void project(const TrafficLaneTerm& c, const State& x, double k, Sink& sink) {
  const detail::LaneOffset o = detail::lane_offset(c, x);
  if (o.gap < 0) part(c.member, c.from, x.w(c.member), c.from_fixed ? 0 : x.w(c.from), o.n, k * o.gap, sink);
}

template <class F>
void anchors(const TrafficLaneTerm& c, F f) {
  f(c.member), f(c.from);
}

template <class Out>
void expand(const scene::TrafficLane& c, Out& out) {
  TrafficLaneTerm term;
  term.from = out.anchor(c.from);
  term.heading = direction(c.angle);
  term.clearance = c.clearance;
  term.from_fixed = c.from_fixed;
  for (const Ref m : out.members(c.members)) {
    term.member = out.anchor(m);
    out.add(term, m, c.from);
  }
}

}  // namespace inhabit::layout
