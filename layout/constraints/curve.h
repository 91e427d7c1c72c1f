#pragma once
#include <algorithm>
#include <numeric>

#include "layout/constraint.h"

namespace inhabit::layout {

/// The members of a curve group on their segment or arc, evenly spaced in the order of the curve's parameter
/// (TVCG 3.2). The nearest point of the curve has infinite mass; spacing is a distance between neighbours, odd pairs
/// first, then even ones. A segment without end points is the medial axis of the members' bounding box.
struct CurveTerm : Term {
  std::uint32_t group = 0;
  std::vector<Anchor> members;
  Curve curve;
  std::optional<double> spacing;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant};
};

namespace detail {

/// A curve with what its nearest points need worked out.
struct PlacedCurve {
  Curve::Kind kind = Curve::Kind::segment;
  Vec2 start, end, center;
  Vec2 r, e;            ///< arc: from the centre to its ends
  double radius = 0;    ///< of the arc
  bool reflex = false;  ///< the arc spans more than half a turn
  Vec2 along;           ///< segment: unit
  double length = 0;    ///< of the segment

  explicit PlacedCurve(const Curve& c) : kind(c.kind), start(c.start), end(c.end), center(c.center) {
    if (kind == Curve::Kind::segment) {
      length = geometry::length(end - start), along = unit(end - start);
    } else {
      r = start - center, e = end - center, radius = geometry::length(r);
      reflex = cross(r, e) < 0 || (cross(r, e) == 0 && dot(r, e) > 0);
    }
  }
};

/// The curve where its group has been carried to; `medial_axis` worked out.
inline PlacedCurve placed_curve(const CurveTerm& c, const State& x) {
  Curve curve = c.curve;
  if (curve.medial_axis) {
    Bounds b;
    for (const Anchor& m : c.members) b.add(x.position(m));
    const Vec2 s = b.size(), mid = b.center();
    const Vec2 half = s.x >= s.y ? Vec2{s.x / 2, 0} : Vec2{0, s.y / 2};
    curve.start = mid - half, curve.end = mid + half;
  } else if (const Pose& frame = x.frames[c.group]; frame != Pose{}) {
    const Vec2 r = direction(frame.angle);
    for (Vec2* p : {&curve.start, &curve.end, &curve.center}) *p = frame.p + rotate(*p, r);
  }
  return PlacedCurve(curve);
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

/// The point `at` metres along the curve.
inline Vec2 curve_point(const Curve& c, double at) {
  if (c.kind == Curve::Kind::segment) return c.start + at * unit(c.end - c.start);
  const Vec2 r = c.start - c.center;
  const double radius = length(r);
  return c.center + rotate(r, direction(wrap_angle(radius > 0 ? at / radius : 0)));
}

inline OnCurve nearest_on_curve(const PlacedCurve& c, Vec2 p) {
  if (c.kind == Curve::Kind::segment) {
    const double t = std::clamp(dot(p - c.start, c.along), 0.0, c.length);
    return {c.start + t * c.along, t};
  }
  const Vec2 v = p - c.center;
  const double distance = length(v);
  // Within the sweep: counter-clockwise of the start and clockwise of the end; for more than half a turn, either of
  // them.
  const bool after_start = cross(c.r, v) >= 0, before_end = cross(v, c.e) >= 0;
  if (distance > 0 && (c.reflex ? after_start || before_end : after_start && before_end)) {
    // Of v, not of the point: its cross product with r has the sign that was tested.
    return {c.center + (c.radius / distance) * v, turn_order(v, c.r)};
  }
  const bool to_start = dot(v, c.r) >= dot(v, c.e);
  return {to_start ? c.start : c.end, turn_order(to_start ? c.r : c.e, c.r)};
}

/// Members in the order of their parameter; ties by their place in the group.
inline std::vector<std::uint32_t> curve_order(const std::vector<double>& parameters) {
  std::vector<std::uint32_t> order(parameters.size());
  std::iota(order.begin(), order.end(), 0u);
  if (!std::ranges::is_sorted(parameters)) {
    std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
      return parameters[i] != parameters[j] ? parameters[i] < parameters[j] : i < j;
    });
  }
  return order;
}

}  // namespace detail

/// Calls f(type, residual, a, b) for every member's distance from the curve and every neighbour's from its spacing.
template <class F>
void for_each_residual(const CurveTerm& c, const State& x, F f) {
  const detail::PlacedCurve curve = detail::placed_curve(c, x);
  std::vector<double> parameters;
  for (std::uint32_t i = 0; i < c.members.size(); ++i) {
    const Vec2 p = x.position(c.members[i]);
    const detail::OnCurve q = detail::nearest_on_curve(curve, p);
    f("curve", length(p - q.point), i, i);
    if (c.spacing) parameters.push_back(q.parameter);
  }
  if (!c.spacing) return;
  const auto order = detail::curve_order(parameters);
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
  const detail::PlacedCurve curve = detail::placed_curve(c, x);
  std::vector<double> parameters;
  for (const Anchor& m : c.members) {
    const Vec2 p = x.position(m);
    const detail::OnCurve q = detail::nearest_on_curve(curve, p);
    if (p != q.point && x.w(m) > 0) sink.shift(m, k * (q.point - p));
    if (c.spacing) parameters.push_back(q.parameter);
  }
  if (!c.spacing) return;
  const auto order = detail::curve_order(parameters);
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
