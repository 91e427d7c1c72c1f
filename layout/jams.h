#pragma once
#include <map>

#include "layout/contacts.h"

namespace inhabit::layout {

/// Boundary and collisions projected again and again, but only where something may overlap: boxes that were apart, and
/// have not moved since, are apart. What is visited is visited in the order of whole sweeps, so the result is theirs,
/// and a jammed spot costs the same in a small hall and in a large one.
class Jams {
 public:
  /// Keeps references to both.
  Jams(const Problem& problem, Contacts& contacts) : p_(problem), contacts_(contacts) {}

  /// Takes the pairs from Contacts, brought up to date; everything counts as moved. Call it first, and after anybody
  /// else has moved things.
  void reset(const State& x);
  /// Collisions, then the boundary, at full stiffness.
  void sweep(State& x);
  /// Adds the overlaps and the boundary's violations to the sums of the score. Finds the pairs of who has strayed.
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
  template <class F>
  void for_each_pair_of(std::uint32_t box, F&& f) const;
  void note(std::uint32_t body);
  void relist(const State& x, std::uint32_t box);

  const Problem& p_;
  Contacts& contacts_;
  std::vector<Contacts::Pair> pairs_;  ///< those of Contacts, then those found here; dead ones reach nowhere
  std::vector<Vec2> listed_at_;        ///< where each box was when its pairs were found; none: all pairs are listed
  core::IndexSet overlapping_;         ///< pairs that may overlap
  core::IndexSet outside_;             ///< bodies that may be outside
  core::IndexSet moved_;               ///< bodies that have moved since the last score
  /// Pairs of each box, as ranges of `pairs_of_`, and those found here.
  std::vector<std::uint32_t> first_, pairs_of_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> more_of_;
  std::vector<std::uint32_t> strays_;  ///< boxes listed anew here
  core::IndexSet stray_;
};

}  // namespace inhabit::layout
