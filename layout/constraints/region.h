#pragma once
#include <memory>

#include "layout/constraint.h"

namespace inhabit::layout {

/// An object's box inside a polygon: a group's fixed zone of the layout space (thesis 5.2.4). C is how deep the box
/// reaches out, over the worst side.
struct RegionTerm : Term {
  Anchor a;
  Vec3 size;
  std::shared_ptr<const Room> zone;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant, .stiffness = 1};
};

namespace detail {
inline Box anchored_box(const Anchor& a, const Vec3& size, const State& x) {
  return {x.position(a), x.front(a), size.y / 2, size.x / 2};
}
}  // namespace detail

inline double error(const RegionTerm& c, const State& x) {
  double worst = 0;
  const Box box = detail::anchored_box(c.a, c.size, x);
  c.zone->for_each_violation(box, [&](Vec2, double depth) { worst = std::max(worst, depth); });
  return worst;
}

template <class Sink>
void project(const RegionTerm& c, const State& x, double k, Sink& sink) {
  if (x.w(c.a) <= 0) return;
  Box box = detail::anchored_box(c.a, c.size, x);
  const Vec2 start = box.center;
  c.zone->for_each_violation(box, [&](Vec2 n, double depth) { box.center += (k * depth) * n; });
  if (box.center != start) sink.shift(c.a, box.center - start);
}

template <class F>
void anchors(const RegionTerm& c, F f) {
  f(c.a);
}

template <class Out>
void expand(const scene::Region& c, Out& out) {
  RegionTerm term;
  term.zone = std::make_shared<const Room>(c.polygon, std::vector<Ring>{});
  for (const Ref m : out.objects(c.members)) {
    term.a = out.anchor(m), term.size = out.size(m);
    out.add(term, m, Ref{});
  }
}

}  // namespace inhabit::layout
