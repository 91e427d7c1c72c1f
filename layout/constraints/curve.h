#pragma once
#include <algorithm>
#include <numeric>

#include "layout/constraint.h"

namespace inhabit::layout {

/// The members of a curve group on their segment or arc, evenly spaced in the order of the curve's parameter (TVCG 3.2).
/// The nearest point of the curve has infinite mass; spacing is a distance between neighbours, odd pairs first, then even
/// ones. A segment without end points is the medial axis of the members' bounding box.
struct CurveTerm : Term {
  std::uint32_t group = 0;
  std::vector<Anchor> members;
  Curve curve;
  std::optional<double> spacing;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant};
};

namespace detail {

/// The curve where its group has been carried to; `medial_axis` worked out.
inline Curve placed_curve(const CurveTerm& c, const State& x) {
  Curve curve = c.curve;
  if (curve.medial_axis) {
    Bounds b;
    for (const Anchor& m : c.members) b.add(x.position(m));
    const Vec2 s = b.size(), mid = b.center();
    const Vec2 half = s.x >= s.y ? Vec2{s.x / 2, 0} : Vec2{0, s.y / 2};
    curve.start = mid - half, curve.end = mid + half;
    return curve;
  }
  const Pose& frame = x.frames[c.group];
  if (frame == Pose{}) return curve;
  const Vec2 r = direction(frame.angle);
  for (Vec2* p : {&curve.start, &curve.end, &curve.center}) *p = frame.p + rotate(*p, r);
  return curve;
}

struct OnCurve {
  Vec2 point;
  double parameter = 0;  ///< grows along the curve from its start: metres on a segment, quarter turns or so on an arc
};

/// Grows from 0 to 4 with the counter-clockwise angle from r to q, without its cost.
inline double turn_order(Vec2 q, Vec2 r) {
  const double c = dot(q, r), s = cross(r, q), sum = std::abs(c) + std::abs(s);
  if (sum == 0) return 0;
  const double t = s / sum;
  return c >= 0 ? (s >= 0 ? t : 4 + t) : 2 - t;
}

/// Angle from the arc's start to its end, counter-clockwise, in (0, 2 pi].
inline double arc_sweep(const Curve& c) {
  const double a = wrap_angle(angle_of(c.end - c.center) - angle_of(c.start - c.center));
  return a <= 0 ? a + 2 * kPi : a;
}

inline double curve_length(const Curve& c) {
  return c.kind == Curve::Kind::segment ? length(c.end - c.start) : arc_sweep(c) * length(c.start - c.center);
}

inline Vec2 curve_point(const Curve& c, double parameter) {
  if (c.kind == Curve::Kind::segment) return c.start + parameter * unit(c.end - c.start);
  const Vec2 r = c.start - c.center;
  const double radius = length(r);
  return c.center + rotate(r, direction(wrap_angle(radius > 0 ? parameter / radius : 0)));
}

inline OnCurve nearest_on_curve(const Curve& c, Vec2 p) {
  if (c.kind == Curve::Kind::segment) {
    const Vec2 q = nearest_on_segment(c.start, c.end, p);
    return {q, length(q - c.start)};
  }
  const Vec2 r = c.start - c.center, e = c.end - c.center, v = p - c.center;
  const double radius = length(r), distance = length(v);
  // Within the sweep: counter-clockwise of the start and clockwise of the end; for more than half a turn, either of them.
  const bool after_start = cross(r, v) >= 0, before_end = cross(v, e) >= 0;
  const bool within = cross(r, e) >= 0 && !(cross(r, e) == 0 && dot(r, e) > 0) ? after_start && before_end : after_start || before_end;
  if (distance > 0 && within) {
    const Vec2 q = (radius / distance) * v;
    return {c.center + q, turn_order(q, r)};
  }
  const bool to_start = dot(v, r) >= dot(v, e);
  return {to_start ? c.start : c.end, turn_order(to_start ? r : e, r)};
}

/// Members in the order of their parameter; ties by their place in the group.
inline std::vector<std::uint32_t> curve_order(const CurveTerm& c, const Curve& curve, const State& x) {
  std::vector<std::pair<double, std::uint32_t>> keys(c.members.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {nearest_on_curve(curve, x.position(c.members[i])).parameter, i};
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order(keys.size());
  std::ranges::transform(keys, order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace detail

/// Calls f(type, residual, a, b) for every member's distance from the curve and every neighbour's from its spacing.
template <class F>
void for_each_residual(const CurveTerm& c, const State& x, F f) {
  const Curve curve = detail::placed_curve(c, x);
  for (std::uint32_t i = 0; i < c.members.size(); ++i) {
    const Vec2 p = x.position(c.members[i]);
    f("curve", length(p - detail::nearest_on_curve(curve, p).point), i, i);
  }
  if (!c.spacing) return;
  const auto order = detail::curve_order(c, curve, x);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const double d = length(x.position(c.members[order[i]]) - x.position(c.members[order[i - 1]]));
    f("spacing", d - *c.spacing, order[i - 1], order[i]);
  }
}

/// Root of the summed squares of all residuals: a curve's share of the energy.
inline double error(const CurveTerm& c, const State& x) {
  double sum = 0;
  for_each_residual(c, x, [&](const char*, double e, std::uint32_t, std::uint32_t) { sum += e * e; });
  return std::sqrt(sum);
}

template <class Sink>
void project(const CurveTerm& c, const State& x, double k, Sink& sink) {
  const Curve curve = detail::placed_curve(c, x);
  for (const Anchor& m : c.members) {
    if (x.w(m) <= 0) continue;
    const Vec2 p = x.position(m), q = detail::nearest_on_curve(curve, p).point;
    if (p != q) sink.shift(m, k * (q - p));
  }
  if (!c.spacing) return;
  const auto order = detail::curve_order(c, curve, x);
  for (const std::size_t parity : {std::size_t{1}, std::size_t{2}}) {
    for (std::size_t i = parity; i < order.size(); i += 2) {
      const Anchor &a = c.members[order[i - 1]], &b = c.members[order[i]];
      const Vec2 v = x.position(a) - x.position(b);
      const double d = length(v), e = d - *c.spacing;
      if (e == 0) continue;
      part(a, b, x.w(a), x.w(b), d > 1e-9 ? (1 / d) * v : tie_break(a.body, b.body), k * e, sink);
    }
  }
}

template <class F>
void anchors(const CurveTerm& c, F f) {
  for (const Anchor& m : c.members) f(m);
}

}  // namespace inhabit::layout
