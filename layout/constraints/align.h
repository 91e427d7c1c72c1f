#pragma once
#include "layout/constraint.h"

namespace inhabit::layout {

/// Two centres in one line along an axis: C = (p_a - p_b) . n, n across the axis. A list of members is held pair by
/// pair.
struct AlignTerm : Term {
  Anchor a, b;
  Vec2 normal{0, 1};
  static constexpr TermTraits kTraits{};
};

inline double error(const AlignTerm& c, const State& x) { return dot(x.position(c.a) - x.position(c.b), c.normal); }

template <class Sink>
void project(const AlignTerm& c, const State& x, double k, Sink& sink) {
  part(c.a, c.b, x.w(c.a), x.w(c.b), c.normal, k * error(c, x), sink);
}

template <class F>
void anchors(const AlignTerm& c, F f) {
  f(c.a), f(c.b);
}

template <class Out>
void expand(const scene::Align& c, Out& out) {
  AlignTerm term;
  term.normal = perp(direction(c.axis));
  const std::vector<Ref> members = out.members(c.members);
  for (std::size_t i = 1; i < members.size(); ++i) {
    term.a = out.anchor(members[i - 1]), term.b = out.anchor(members[i]);
    out.add(term, members[i - 1], members[i]);
  }
}

}  // namespace inhabit::layout
