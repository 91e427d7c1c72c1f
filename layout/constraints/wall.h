#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// The centre of the back face at a distance from the nearest wall, or from a named one.
///
///   C = |b - p_wall| - d,  b the back face's centre                 [TVCG eq. 13]
///
/// Deviation: TVCG measures from the object's centre. Outside the room the distance counts as negative, so that an
/// object behind the wall is drawn in.
struct WallDistanceTerm : Term {
  Anchor a;
  double half_depth = 0, distance = 0;
  std::optional<int> wall;
  static constexpr TermTraits kTraits{
      .pass = Pass::walls, .schedule = pbd::Schedule::constant, .stiffness = 1, .gamma = 20};
};

/// The heading relative to the inward normal of the nearest wall (of the back face's centre): 0 = back to the wall.
///
///   C = theta - (normal's angle + angle)                            [TVCG eq. 17]
struct WallOrientationTerm : Term {
  Anchor a;
  double half_depth = 0, angle = 0;
  std::optional<int> wall;
  static constexpr TermTraits kTraits{
      .pass = Pass::walls, .schedule = pbd::Schedule::constant, .angular = true, .stiffness = 1, .gamma = 20};
};

namespace detail {
inline WallPoint wall_behind(const Anchor& a, double half_depth, std::optional<int> wall, const State& x) {
  return x.room->nearest_wall(x.position(a) - half_depth * x.front(a), wall);
}
}  // namespace detail

inline double error(const WallDistanceTerm& c, const State& x) {
  return detail::wall_behind(c.a, c.half_depth, c.wall, x).distance - c.distance;
}

template <class Sink>
void project(const WallDistanceTerm& c, const State& x, double k, Sink& sink) {
  if (x.w(c.a) <= 0) return;
  const Vec2 back = x.position(c.a) - c.half_depth * x.front(c.a);
  const WallPoint w = x.room->nearest_wall(back, c.wall);
  const double e = w.distance - c.distance;
  if (e == 0) return;
  // From the wall to the face, as the distance is counted; beside a wall's end it is not the normal.
  const Vec2 n = std::abs(w.distance) > 1e-9 ? (1 / w.distance) * (back - w.point) : x.room->walls()[w.wall].normal;
  sink.shift(c.a, (-k * e) * n);
}

inline double error(const WallOrientationTerm& c, const State& x) {
  const WallPoint w = detail::wall_behind(c.a, c.half_depth, c.wall, x);
  return wrap_angle(x.angle(c.a) - x.room->walls()[w.wall].angle - c.angle);
}

template <class Sink>
void project(const WallOrientationTerm& c, const State& x, double k, Sink& sink) {
  if (!x.turns(c.a)) return;
  const double e = error(c, x);
  if (std::abs(e) > kStill) sink.turn(c.a, -k * e);
}

template <class F>
void anchors(const WallDistanceTerm& c, F f) {
  f(c.a);
}
template <class F>
void anchors(const WallOrientationTerm& c, F f) {
  f(c.a);
}

template <class Out>
void expand(const scene::WallDistance& c, Out& out) {
  WallDistanceTerm term;
  term.distance = c.distance, term.wall = c.wall;
  for (const Ref m : out.solid_members(c.members)) {
    term.a = out.face_anchor(m), term.half_depth = out.size(m).y / 2;
    out.hold_to_wall(m);
    out.add(term, m, Ref{});
  }
}

template <class Out>
void expand(const scene::WallOrientation& c, Out& out) {
  WallOrientationTerm term;
  term.angle = c.angle, term.wall = c.wall;
  for (const Ref m : out.solid_members(c.members)) {
    term.a = out.face_anchor(m), term.half_depth = out.size(m).y / 2;
    out.add(term, m, Ref{});
  }
}

}  // namespace inhabit::layout
