#pragma once
#include "layout/furnish.h"
#include "layout/placer.h"

namespace inhabit::layout {

/// Puts every particle where the start of these options has it before anything is placed with care: given ones there,
/// the others at random. Marks who stands where the scene says.
void scatter(const Problem& problem, const Options& options, Rng& rng, State& x, std::vector<bool>& given);

/// One start of the solver: everything it needs, nothing shared, so that starts run side by side.
///
/// Between the rounds of projection (thesis table 5.1, with the schedules of pbd/stiffness.h) come three things that
/// the papers do not have, each because it measured better (docs/results.md): a start that places one object after the
/// other; relocation of what has stopped getting freer; and a last polish by boundary and collisions alone.
class Solver {
 public:
  /// `start` is the number of the random restart; the same (seed, start) gives the same bits.
  Solver(const Problem& problem, const Options& options, int start);

  /// Runs to the end, appending to `trace` if the options ask for it.
  Layout run(std::vector<TraceRow>* trace);

 private:
  /// An energy lower by less than this share is no improvement (as TVCG 4.3 stops its annealing).
  static constexpr double kImprovement = 1e-3;
  static constexpr double kPolishable = 0.1;  ///< metres: deeper overlaps take more than a polish
  static constexpr std::size_t kMany = 64;    ///< more bodies than this are relocated all at once

  void begin();
  void begin_curves(std::vector<bool>& placed);
  void iterate();
  void set_stiffness();
  template <class Sink>
  void pass(bool walls, bool others, Sink& sink);
  template <class Sink>
  void sweep(Sink& sink);
  template <class Sink>
  void project_boundary(double k, Sink& sink);
  Score score();
  double total_gamma() const;
  void keep(const Score& s);
  /// Boundary and collisions alone, from where things are; the result counts when it is feasible.
  bool polish();
  /// Takes the worst objects out and puts them back where they fit best.
  void relocate();
  void relocate_few(const std::vector<double>& load);
  void relocate_many(const std::vector<double>& load);
  std::vector<double> loads() const;
  void refine(int& iteration);
  /// Large scenes get fewer iterations, never below 1000 unless asked: what one costs grows with the scene.
  int iteration_limit() const;
  bool cancelled() const { return options_.cancel != nullptr && options_.cancel->requested(); }

  const Problem& p_;
  Options options_;
  int start_ = 0;
  core::Rng rng_;
  State x_;
  Contacts contacts_;
  std::optional<Placer> placer_;
  std::vector<double> k_;  ///< stiffness of each slot in this iteration
  bool settles_ = false;   ///< everything has a position: small moves only
  int schedule_ = 1;       ///< l of the schedules
  State best_;
  Score best_score_;
  bool has_best_ = false;
  /// Before the last relocation, to go back to when it did not help.
  std::optional<State> before_;
  double before_violation_ = 0;
};

}  // namespace inhabit::layout
