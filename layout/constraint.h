#pragma once
#include "layout/particles.h"
#include "pbd/stiffness.h"

/// What the files in layout/constraints/ have in common.
///
/// A constraint of the scene document expands into terms: one scalar C over a few anchors each. A term type is a plain
/// struct that derives from Term and comes with four functions:
///
///   double error(const T&, const State&)               C, or the violated part of an inequality; 0 when satisfied
///   void project(const T&, const State&, double k, Sink&)   asks the sink for shifts and turns that satisfy C to first
///   order void anchors(const T&, F f)                        calls f(anchor) for every anchor that the term reads void
///   expand(const scene::Kind&, Out&)              the document's constraint in terms: out.add(term, a, b)
///
/// Shifts follow TVCG eq. 2, 3 with the minus sign that the print lost: dp_i = -k s w_i grad_i C, s = C / sum w_j
/// |grad_j C|^2. A sum of zero (all pinned, coincident points) asks for nothing. Turns are the smallest that satisfy C,
/// times k.
namespace inhabit::layout {

/// Passes of one iteration in which a term is projected (thesis table 5.1).
enum class Pass { others, walls };

/// A term holds what differs from one to the next, the small members first: in a theatre, terms are most of the memory.
struct Term {
  std::uint32_t slot = 0;  ///< which of the problem's slots: stiffness schedule and weight
};

/// The defaults of a term type; a document's `stiffness` and `weight` replace the last two.
struct TermTraits {
  Pass pass = Pass::others;
  pbd::Schedule schedule = pbd::Schedule::decreasing;
  bool angular = false;  ///< error in radians instead of metres
  double stiffness = 0.8;
  double gamma = 1;
};

/// Radians: a smaller error turns nobody. Sines and cosines are not free.
constexpr double kStill = 1e-9;

/// A sink that moves particles at once (Gauss–Seidel).
struct Direct {
  State& x;
  void shift(const Anchor& a, Vec2 d) { x.shift(a, d); }
  void turn(const Anchor& a, double by) {
    if (x.turns(a)) x.turn(a, by);
  }
};

/// Shifts a by -C w_a / (w_a + w_b) n and b by the opposite share: a scalar constraint whose gradients are n and -n.
template <class Sink>
void part(const Anchor& a, const Anchor& b, double wa, double wb, Vec2 n, double kc, Sink& sink) {
  const double sum = wa + wb;
  if (sum <= 0) return;
  if (wa > 0) sink.shift(a, (-kc * (wa / sum)) * n);
  if (wb > 0) sink.shift(b, (kc * (wb / sum)) * n);
}

/// A unit vector for two points that coincide: fixed, so that runs repeat, and different from pair to pair.
inline Vec2 tie_break(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t h = (a * 2654435761u) ^ (b * 40503u);
  return direction((h % 628) * 0.01);
}

}  // namespace inhabit::layout
