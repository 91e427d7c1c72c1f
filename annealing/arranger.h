#pragma once
#include "annealing/annealer.h"
#include "annealing/move_table.h"
#include "annealing/term_table.h"

namespace inhabit::annealing {

struct ArrangerOptions {
  double hot = 1;            ///< the schedule's highest temperature, at which moves are as large as these
  double position = 1;       ///< sigma_p there, metres
  double angle = kPi / 2;    ///< sigma_theta there
  bool paper_moves = false;  ///< without ToPrior
};

/// The furniture problem of Yu et al. as the annealer wants it: a random arrangement, moves of every kind, and what
/// each changes, evaluated over what it touches alone.
class Arranger {
 public:
  Arranger(const Furniture& furniture, const ArrangerOptions& options);

  /// Puts everything that can move at a random place and heading, on its carrier or its wall; `keep`: but for what has
  /// a place in the scene.
  void scatter(Rng& rng, bool keep);

  double propose(Rng& rng, double temperature);
  void accept();
  void reject() { x_.undo(); }
  double cost() const { return weighted(grid_cost(x_), x_.furniture().weights); }
  using Snapshot = Arrangement::Snapshot;
  Snapshot snapshot() const { return x_.snapshot(); }
  void restore(const Snapshot& s);

  const Arrangement& arrangement() const { return x_; }
  /// What each term comes to now, without weights: the increments added up.
  const Costs& costs() const { return costs_; }

 private:
  Scale scale(double temperature) const;

  Arrangement x_;
  ArrangerOptions options_;
  LocalCost local_;
  Costs costs_{}, change_{};
  std::array<double, Moves::size> share_{};  ///< summed up to each kind of move
};

}  // namespace inhabit::annealing
