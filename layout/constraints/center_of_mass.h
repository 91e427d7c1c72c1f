#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// The centre of mass mu of some particles at a target: a point (heat point), the nearest point of a focal object's
/// front ray (focal symmetry), the room's centroid with footprints for masses (visual balance).
///
///   C = |mu - t|,  every member moves by -k (mu - t)                [TVCG eq. 9-12, thesis eq. 5.8, 5.10, 5.13]
///
/// Deviation: TVCG's C = |mu - t|^2 / 2 only halves the distance at each projection, and the thesis's gradient (1, 1)
/// is no gradient. Members that are pinned leave their part to the others, at most four times their own.
struct CenterTerm : Term {
  enum class Target { point, front_ray, room } target = Target::point;
  Vec2 point;
  std::optional<Anchor> on;  ///< `point` is in its frame, or whose front ray
  bool on_fixed = true;
  std::vector<Anchor> members;
  std::vector<double> masses;
  double mass = 0;
  static constexpr TermTraits kTraits{};
};

namespace detail {
inline Vec2 center_target(const CenterTerm& c, const State& x, Vec2 mu) {
  if (c.target == CenterTerm::Target::room) return x.room->center();
  if (!c.on) return c.point;
  const Vec2 p = x.position(*c.on), f = x.front(*c.on);
  if (c.target == CenterTerm::Target::point) return p + rotate(c.point, f);
  return p + std::max(0.0, dot(mu - p, f)) * f;
}
}  // namespace detail

inline Vec2 center_of_mass(const CenterTerm& c, const State& x) {
  Vec2 sum;
  for (std::size_t i = 0; i < c.members.size(); ++i) sum += c.masses[i] * x.position(c.members[i]);
  return c.mass > 0 ? (1 / c.mass) * sum : Vec2{};
}

inline double error(const CenterTerm& c, const State& x) {
  const Vec2 mu = center_of_mass(c, x);
  return length(mu - detail::center_target(c, x, mu));
}

template <class Sink>
void project(const CenterTerm& c, const State& x, double k, Sink& sink) {
  const Vec2 mu = center_of_mass(c, x), off = mu - detail::center_target(c, x, mu);
  if (off == Vec2{}) return;
  double movable = 0;
  for (std::size_t i = 0; i < c.members.size(); ++i) movable += x.w(c.members[i]) > 0 ? c.masses[i] : 0;
  // The members move as one particle of mass `movable`; the focal object takes its part unless it is pinned.
  const double w_focal = c.on && !c.on_fixed ? x.w(*c.on) : 0, w_members = movable > 0 ? 1 / movable : 0;
  if (w_focal + w_members <= 0) return;
  const double part_of_members = w_members / (w_focal + w_members);
  if (w_focal > 0) sink.shift(*c.on, (k * (1 - part_of_members)) * off);
  if (movable <= 0) return;
  const Vec2 step = (-k * part_of_members * std::min(4.0, c.mass / movable)) * off;
  for (const Anchor& m : c.members) {
    if (x.w(m) > 0) sink.shift(m, step);
  }
}

template <class F>
void anchors(const CenterTerm& c, F f) {
  for (const Anchor& m : c.members) f(m);
  if (c.on) f(*c.on);
}

template <class Out>
void add_center(CenterTerm term, const std::vector<Ref>& members, bool by_footprint, Ref on, Out& out) {
  for (const Ref m : members) {
    term.members.push_back(out.anchor(m));
    term.masses.push_back(by_footprint ? out.footprint(m) : out.mass(m));
    term.mass += term.masses.back();
  }
  if (!term.members.empty()) out.add(std::move(term), members.front(), on);
}

template <class Out>
void expand(const scene::HeatPoint& c, Out& out) {
  CenterTerm term;
  term.point = c.point;
  if (!c.on.none()) term.on = out.anchor(c.on);
  term.on_fixed = c.on_fixed;
  add_center(std::move(term), out.members(c.members), false, c.on, out);
}

template <class Out>
void expand(const scene::FocalSymmetry& c, Out& out) {
  CenterTerm term;
  term.target = CenterTerm::Target::front_ray;
  term.on = out.anchor(c.focal);
  term.on_fixed = c.focal_fixed;
  add_center(std::move(term), out.members(c.members), false, c.focal, out);
}

template <class Out>
void expand(const scene::VisualBalance& c, Out& out) {
  CenterTerm term;
  term.target = CenterTerm::Target::room;
  add_center(std::move(term), c.members.empty() ? out.all_objects() : out.members(c.members), true, {}, out);
}

}  // namespace inhabit::layout
