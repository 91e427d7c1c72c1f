#include "layout/solver.h"

#include <algorithm>
#include <chrono>

#include "layout/jams.h"

namespace inhabit::layout {
namespace {

constexpr double kSoftRate = 10;  ///< M of the decreasing schedule: soft constraints act fully for about ten iterations
constexpr double kHardRate = 1;   ///< M of the increasing schedule
constexpr int kStall = 8;         ///< iterations without clearly less overlap before a relocation
constexpr double kProgress = 0.85;  ///< what counts as clearly less: creeping on costs more than moving somebody
constexpr double kSettled = 1e-3;   ///< residual that nobody sees: 1 mm, 0.06 degrees
constexpr double kVisible = 4e-3;   ///< root mean square change of all residuals that nobody sees: 4 mm, 0.2 degrees
constexpr int kWindow = 4;          ///< iterations over which a settled layout's energy stays within that change
constexpr int kPolishEvery = 10;

/// Averages the corrections of a set per particle, times 1.2 (TVCG 3.1).
struct Averaged {
  State& x;
  std::vector<Vec2> shift_sum;
  std::vector<double> turn_sum;
  std::vector<std::uint32_t> shifts, turns;

  explicit Averaged(State& s)
      : x(s), shift_sum(s.bodies.size()), turn_sum(s.bodies.size()), shifts(s.bodies.size()), turns(s.bodies.size()) {}
  void shift(const Anchor& a, Vec2 d) {
    if (a.group()) {
      for (const std::uint32_t b : x.data->groups[a.index()].bodies) {
        if (x.data->bodies[b].w > 0) shift_sum[b] += d, ++shifts[b];
      }
    } else {
      shift_sum[a.body] += d, ++shifts[a.body];
    }
  }
  void turn(const Anchor& a, double by) {
    if (a.group()) {
      x.turn(a, by);
    } else if (x.turns(a)) {
      turn_sum[a.body] += by, ++turns[a.body];
    }
  }
  void flush() {
    for (std::uint32_t b = 0; b < shifts.size(); ++b) {
      if (shifts[b] > 0) x.shift(b, (pbd::kAveraging / std::max(1.2, 1.0 * shifts[b])) * shift_sum[b]);
      if (turns[b] > 0) x.turn(Anchor{b}, pbd::kAveraging / std::max(1.2, 1.0 * turns[b]) * turn_sum[b]);
      shift_sum[b] = {}, turn_sum[b] = 0, shifts[b] = turns[b] = 0;
    }
  }
};

void flush(Direct&) {}
void flush(Averaged& s) { s.flush(); }

}  // namespace

Solver::Solver(const Problem& problem, const Options& options, int start)
    : p_(problem),
      options_(options),
      start_(start),
      rng_(options.seed, static_cast<std::uint64_t>(start)),
      x_(problem.data, problem.room),
      contacts_(problem),
      k_(problem.slots.size()),
      best_(problem.data, problem.room) {
  if (options_.paper) options_.start = Start::random, options_.relocation = false;
  if (!options_.paper && (options_.relocation || options_.start != Start::random)) placer_.emplace(p_, x_);
}

void Solver::set_stiffness() {
  for (std::size_t s = 0; s < k_.size(); ++s) {
    const Slot& slot = p_.slots[s];
    const double rate = slot.schedule == pbd::Schedule::increasing ? kHardRate : kSoftRate;
    k_[s] = pbd::stiffness(slot.schedule, slot.k0, rate, schedule_);
  }
}

template <class Sink>
void Solver::project_boundary(double k, Sink& sink) {
  if (!p_.boundary) return;
  p_.for_each_movable_box([&](std::uint32_t i, std::uint32_t body) {
    p_.room.for_each_violation(x_.boxes[i], [&](Vec2 n, double depth) { sink.shift(Anchor{body}, (k * depth) * n); });
  });
}

template <class Sink>
void Solver::pass(bool walls, bool others, Sink& sink) {
  const auto terms = [&](Pass which) {
    for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
      if (T::kTraits.pass != which) return;
      for (const T& term : p_.of<T>()) project(term, x_, k_[term.slot], sink);
      flush(sink);
    });
  };
  if (others) {
    terms(Pass::others);
    contacts_.project_zones(x_, k_, options_.paper, sink);
    flush(sink);
  }
  if (walls) {
    terms(Pass::walls);
    project_boundary(1, sink);
    flush(sink);
  }
  contacts_.project_collisions(x_, k_[p_.collision_slot], sink);
  flush(sink);
}

/// One iteration in the order of thesis table 5.1. Pairs are those of its beginning: what comes near within one
/// iteration meets in the next, and score() looks afresh.
template <class Sink>
void Solver::sweep(Sink& sink) {
  contacts_.refresh(x_);
  pass(false, false, sink);
  pass(false, true, sink);
  pass(true, false, sink);
  pass(false, true, sink);
  pass(false, false, sink);
  pass(true, true, sink);
}

void Solver::iterate() {
  set_stiffness();
  if (options_.scheme == Scheme::averaged) {
    Averaged sink(x_);
    sweep(sink);
  } else {
    Direct sink{x_};
    sweep(sink);
  }
  ++schedule_;
}

double Solver::total_gamma() const {
  double sum = 0;
  p_.for_each_term([&](const auto& term, TermId) { sum += p_.gamma(term); });
  return sum;
}

Score Solver::score() {
  Score s;
  double squares = 0;
  for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
    for (const T& term : p_.of<T>()) {
      const double e = error(term, x_);
      squares += p_.gamma(term) * e * e;
      s.slack = std::max(s.slack, std::abs(e));
    }
  });
  for (std::uint32_t b = 0; b < p_.data.bodies.size(); ++b) score_boundary(p_, x_, b, s, squares);
  contacts_.refresh(x_);
  contacts_.score_collisions(x_, s, squares);
  contacts_.score_zones(x_, s, squares);
  s.energy = std::sqrt(squares);
  return s;
}

void Solver::keep(const Score& s) {
  if (has_best_ && !s.better_than(best_score_)) return;
  best_score_ = s, has_best_ = true;
  best_.bodies = x_.bodies, best_.boxes = x_.boxes, best_.frames = x_.frames;
}

bool Solver::polish() {
  const State saved = x_;
  Jams jams(p_, contacts_);
  jams.reset(x_);
  bool done = false;
  // In a large scene some spot is always jammed: who is still overlapping then moves elsewhere, a few at a time.
  int moves = placer_ && options_.relocation && p_.data.bodies.size() > kMany ? 4 : 0;
  double last = 1e300;
  for (int i = 0; i < 200 && !done; ++i) {
    jams.sweep(x_);
    if (i % 4 != 3) continue;
    Score s;
    double squares = 0;
    jams.score(x_, s, squares);
    done = s.feasible();
    if (done) keep(score());
    if (s.violation > 0.9 * last) {
      if (moves-- <= 0) break;
      relocate();
      jams.reset(x_);
      last = 1e300;
      continue;
    }
    last = s.violation;
  }
  x_.bodies = saved.bodies, x_.boxes = saved.boxes, x_.frames = saved.frames;
  return done;
}

int Solver::iteration_limit() const {
  const double n = static_cast<double>(p_.data.bodies.size());
  return n <= kMany
             ? options_.max_iterations
             : std::max(std::min(1000, options_.max_iterations), static_cast<int>(options_.max_iterations * kMany / n));
}

Layout Solver::run(std::vector<TraceRow>* trace) {
  const auto clock = std::chrono::steady_clock::now();
  begin();
  const bool relocates = placer_.has_value() && options_.relocation;
  const double visible = options_.paper ? 0 : kVisible * std::sqrt(total_gamma());
  const int limit = iteration_limit();
  int iteration = 0, since_energy = 0, since_violation = 0;
  double energy_mark = 1e300, violation_mark = 1e300;
  std::array<double, kWindow + 1> window;
  window.fill(1e300), window[0] = 0;
  bool relocated = false;
  // What is there already counts: a warm start may be as good as it gets.
  const Score first = score();
  keep(first);
  const bool settled = !options_.paper && first.feasible() && first.slack < kSettled;
  while (!settled && iteration < limit && !cancelled()) {
    iterate();
    ++iteration;
    const Score s = score();
    const bool was_feasible = has_best_ && best_score_.feasible();
    keep(s);
    if (trace != nullptr) trace->push_back({start_ + 1, iteration, s.energy, s.violation, s.feasible(), relocated});
    relocated = false;
    if (best_score_.feasible() != was_feasible) energy_mark = 1e300;
    ++since_energy, ++since_violation;
    if (best_score_.energy < energy_mark - std::max(visible, energy_mark * kImprovement))
      energy_mark = best_score_.energy, since_energy = 0;
    if (s.violation < kProgress * violation_mark) violation_mark = s.violation, since_violation = 0;
    if (s.feasible() && s.slack < kSettled) break;
    // Overlaps that soft constraints keep opening fade only as 1 / l: see now and then whether they can be had at once.
    const bool tries_polish = !options_.paper && !s.feasible() && s.worst < kPolishable;
    if (tries_polish && iteration % kPolishEvery == 0) polish();
    window[static_cast<std::size_t>(iteration) % window.size()] = s.energy;
    const auto [low, high] = std::ranges::minmax(window);
    if (high - low <= visible && !options_.paper) {
      if (tries_polish) polish();
      if (best_score_.feasible()) break;
    }
    if (best_score_.feasible() || !relocates) {
      if (since_energy >= options_.patience) break;
      continue;
    }
    if (since_violation < kStall) continue;
    if (s.worst < 2 * kPolishable && polish()) continue;
    if (before_ && s.violation > before_violation_ * 1.02 + 1e-3 && rng_.uniform() < 0.9) {
      x_ = *before_;
    } else {
      before_ = x_, before_violation_ = s.violation;
    }
    relocate();
    relocated = true;
    schedule_ = std::min(schedule_, 6);
    violation_mark = 1e300, since_violation = 0;
  }
  if (!options_.paper && !best_score_.feasible() && has_best_) {
    x_.bodies = best_.bodies, x_.boxes = best_.boxes, x_.frames = best_.frames;
    polish();
  }
  if (relocates && best_score_.feasible() && !settles_ && p_.data.bodies.size() <= kMany) refine(iteration);
  Layout out;
  out.placement = placement_of(p_, best_);
  out.feasible = best_score_.feasible();
  out.energy = best_score_.energy;
  out.violation = best_score_.violation;
  out.start = start_ + 1;
  out.iterations = iteration;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return out;
}

}  // namespace inhabit::layout
