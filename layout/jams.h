#pragma once
#include "layout/contacts.h"

namespace inhabit::layout {

/// Boundary and collisions projected again and again, but only where something may overlap: boxes that were apart, and
/// have not moved since, are apart. What is visited is visited in the order of whole sweeps, so the result is theirs,
/// and a jammed spot costs the same in a small hall and in a large one.
class Jams {
 public:
  /// Keeps references to both.
  Jams(const Problem& problem, Contacts& contacts) : p_(problem), contacts_(contacts) {}

  /// Brings the pairs up to date; everything counts as moved. Call it first, and after anybody else has moved things.
  void reset(const State& x);
  /// Collisions, then the boundary, at full stiffness.
  void sweep(State& x);
  /// Brings the pairs up to date and adds the overlaps and the boundary's violations to the sums of the score.
  void score(const State& x, Score& s, double& squares);

 private:
  /// Moves particles at once and notes who has moved.
  struct Noting {
    State& x;
    Jams& jams;
    void shift(const Anchor& a, Vec2 d) {
      x.shift(a.body, d);
      jams.note(a.body);
    }
  };
  void note(std::uint32_t body);
  void list_pairs();

  const Problem& p_;
  Contacts& contacts_;
  core::IndexSet pairs_;   ///< of Contacts: those that may overlap
  core::IndexSet bodies_;  ///< those that may be outside
  core::IndexSet moved_;   ///< bodies that have moved since the pairs were last seen to be up to date
  /// Pairs of each box, as ranges of `pairs_of_`.
  std::vector<std::uint32_t> first_, pairs_of_;
};

}  // namespace inhabit::layout
