#pragma once
#include "annealing/annealer.h"
#include "layout/contacts.h"
#include "layout/furnish.h"
#include "layout/problem.h"

/// Simulated annealing of the position-based method's own problem: the baseline that its papers compare with
/// ("SA-McMC", TVCG 4.3).
namespace inhabit::session {

/// The state of a layout as the annealer wants it: "the proposal function shifts an attribute of one layout object in
/// each state-search step", and the cost is the energy of TVCG eq. 1, of which a step re-evaluates what its object
/// takes part in. The papers print neither the size of the shifts nor the temperatures: normal shifts with a deviation
/// that falls with the temperature, as Yu et al. 2011 have it.
class LayoutWalk {
 public:
  /// At the random start that the solver of this seed has, too. `hot`: the schedule's highest temperature, at which
  /// the shifts have a deviation of `shift` times the longer side of the room, and of a quarter turn.
  LayoutWalk(const layout::Problem& problem, std::uint64_t seed, double hot, double shift);

  double propose(core::Rng& rng, double temperature);
  void accept() { squares_ = std::max(0.0, squares_ + change_); }
  void reject();
  /// E of TVCG eq. 1.
  double cost() const { return std::sqrt(score_all().second); }
  using Snapshot = std::vector<layout::State::Body>;
  Snapshot snapshot() const { return x_.bodies; }
  void restore(const Snapshot& bodies);

  /// Hard violations and energy.
  layout::Score score() const { return score_all().first; }
  const layout::State& state() const { return x_; }

 private:
  /// Everything that a body takes part in, squared and weighted.
  double squares_of(std::uint32_t body) const;
  double collisions_of(std::uint32_t body) const;
  double zones_of(std::uint32_t body) const;
  double zone_square(std::uint32_t z, std::uint32_t box) const;
  std::pair<layout::Score, double> score_all() const;

  const layout::Problem* p_;
  layout::State x_;
  std::vector<std::uint32_t> movable_;
  double hot_ = 1, reach_ = 1;
  double squares_ = 0, change_ = 0;
  std::uint32_t moved_ = 0;
  layout::State::Body before_;
};

struct BaselineOptions {
  std::uint64_t seed = 1;
  std::int64_t iterations = 20000;  ///< "linear, evenly-spaced schedules for about 20,000 iterations"
  /// "… in case the energy function value did not improve by more than 0.1 percent during the previous 1,500".
  std::int64_t patience = 1500;
  // The papers print neither; the best over their scenes of shifts of 0.03, 0.1, 0.25 and of 0.0001 … 0.1 (with these,
  // the stopping rule ends hotter searches before they have cooled).
  double hot = 0.001;   ///< first temperature, as a share of the random start's energy
  double shift = 0.25;  ///< deviation of the first shifts, as a share of the longer side of the room
  std::vector<layout::TraceRow>* trace = nullptr;
  std::int64_t trace_every = 64;
  const core::Cancel* cancel = nullptr;
};

/// One run from the random start of `seed`. Errors: compile()'s.
core::Result<layout::Layout> anneal_layout(const layout::Scene& scene, const BaselineOptions& options);

}  // namespace inhabit::session
