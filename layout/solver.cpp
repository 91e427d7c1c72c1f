#include "layout/solver.h"

#include <algorithm>
#include <chrono>

namespace inhabit::layout {
namespace {

constexpr double kSoftRate = 10;  ///< M of the decreasing schedule: soft constraints act fully for about ten iterations
constexpr double kHardRate = 1;   ///< M of the increasing schedule
constexpr int kStall = 8;         ///< iterations without clearly less overlap before a relocation
constexpr double kProgress = 0.85;  ///< what counts as clearly less: creeping on costs more than moving somebody
constexpr double kImprovement =
    1e-3;  ///< an energy lower by less than this share is no improvement (as TVCG 4.3 stops its annealing)
constexpr double kSettled = 1e-3;  ///< residual that nobody sees: 1 mm, 0.06 degrees
constexpr double kVisible = 4e-3;  ///< root mean square change of all residuals that nobody sees: 4 mm, 0.2 degrees
constexpr int kWindow = 4;         ///< iterations over which a settled layout's energy stays within that change
constexpr int kRefinements = 6;    ///< relocations that look for a better energy once a layout is feasible
constexpr int kSettling = 5;       ///< iterations after each
constexpr int kFruitless = 2;      ///< so many without success end the search
constexpr double kGood = 0.03;     ///< root mean square residual that needs none: 3 cm, 1.7 degrees
constexpr int kPolishEvery = 10;
constexpr double kPolishable = 0.1;  ///< metres: deeper overlaps take more than a polish
constexpr std::size_t kMany = 64;    ///< more bodies than this are relocated all at once
constexpr double kFeasible = 1e-3;   ///< metres (scene.md)

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

void Solver::begin() {
  const std::size_t n = p_.data.bodies.size();
  const Bounds& room = p_.room.extent();
  std::vector<bool> placed(n);
  std::vector<std::uint32_t> todo;
  for (std::uint32_t b = 0; b < n; ++b) {
    const BodyData& d = p_.data.bodies[b];
    const bool keep = p_.has_start[b] && (d.w == 0 || options_.start == Start::given);
    Pose pose = p_.start[b];
    if (!keep) {
      for (int i = 0; i < 32; ++i) {
        pose.p = {rng_.uniform(room.min.x, room.max.x), rng_.uniform(room.min.y, room.max.y)};
        if (p_.room.contains(pose.p)) break;
      }
    }
    if (d.turns && !(options_.start == Start::given && p_.has_angle[b])) pose.angle = rng_.uniform(-kPi, kPi);
    x_.place(b, pose.p, pose.angle);
    placed[b] = keep;
    if (!keep) todo.push_back(b);
  }
  if (todo.empty()) {
    settles_ = true;
    schedule_ = 20;  // warm: soft constraints correct, they do not rearrange
    return;
  }
  if (options_.start == Start::random) return;
  begin_curves(placed);
  std::erase_if(todo, [&](std::uint32_t b) { return placed[b]; });
  // Large before small, with some chance, so that starts differ. In a large scene equals go in the order of the
  // document: members of one tier are neighbours in the room and so in memory.
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t b : todo) {
    const double area = p_.data.bodies[b].area;
    order.emplace_back(-area * (n > kMany ? 1 : rng_.uniform(0.7, 1.3)), b);
  }
  std::ranges::sort(order);
  placer_->reset(placed);
  const int tries = n > kMany ? 16 : 32;
  for (const auto& [key, b] : order) placer_->place(b, rng_, tries);
}

/// Members of a curve start evenly along it.
void Solver::begin_curves(std::vector<bool>& placed) {
  for (const CurveTerm& c : p_.of<CurveTerm>()) {
    if (c.curve.medial_axis) continue;
    const double total = detail::curve_length(c.curve), n = static_cast<double>(c.members.size());
    const double step = c.spacing && *c.spacing * (n - 1) <= total ? *c.spacing : (n > 1 ? total / (n - 1) : 0);
    double at = (total - step * (n - 1)) / 2;
    for (const Anchor& m : c.members) {
      if (!m.group() && !placed[m.body] && x_.w(m) > 0) {
        x_.place(m.body, detail::curve_point(c.curve, at), x_.bodies[m.body].angle);
        placed[m.body] = true;
      }
      at += step;
    }
  }
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
  for (std::uint32_t i = 0; i < x_.boxes.size(); ++i) {
    const std::uint32_t body = p_.data.boxes[i].body;
    if (p_.data.bodies[body].w <= 0) continue;
    p_.room.for_each_violation(x_.boxes[i], [&](Vec2 n, double depth) { sink.shift(Anchor{body}, (k * depth) * n); });
  }
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
  if (p_.boundary) {
    for (std::uint32_t i = 0; i < x_.boxes.size(); ++i) {
      // What cannot move stands as it is given.
      if (p_.data.bodies[p_.data.boxes[i].body].w <= 0) continue;
      double deepest = 0;
      p_.room.for_each_violation(x_.boxes[i], [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
      s.violation += deepest;
      s.worst = std::max(s.worst, deepest);
      squares += p_.boundary_gamma * deepest * deepest;
    }
  }
  contacts_.refresh(x_);
  contacts_.score(x_, s, squares);
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
  Direct sink{x_};
  bool done = false;
  // In a large scene some spot is always jammed: who is still overlapping then moves elsewhere, a few at a time.
  int moves = placer_ && options_.relocation && p_.data.bodies.size() > kMany ? 4 : 0;
  double last = 1e300;
  for (int i = 0; i < 200 && !done; ++i) {
    if (i % 4 == 0) contacts_.refresh(x_);
    contacts_.project_collisions(x_, 1, sink);
    project_boundary(1, sink);
    if (i % 4 != 3) continue;
    const Score s = score();
    done = s.feasible();
    if (done) keep(s);
    if (s.violation > 0.9 * last) {
      if (moves-- <= 0) break;
      relocate();
      last = 1e300;
      continue;
    }
    last = s.violation;
  }
  x_.bodies = saved.bodies, x_.boxes = saved.boxes, x_.frames = saved.frames;
  return done;
}

std::vector<double> Solver::loads() const {
  std::vector<double> load(p_.data.bodies.size());
  contacts_.add_load(x_, load);
  for (std::uint32_t i = 0; i < x_.boxes.size() && p_.boundary; ++i) {
    if (p_.data.bodies[p_.data.boxes[i].body].w <= 0) continue;
    double deepest = 0;
    p_.room.for_each_violation(x_.boxes[i], [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
    load[p_.data.boxes[i].body] += deepest;
  }
  return load;
}

void Solver::relocate() {
  contacts_.refresh(x_);
  const std::vector<double> load = loads();
  placer_->reset(std::vector<bool>(p_.data.bodies.size(), true));
  if (p_.data.bodies.size() > kMany) {
    relocate_many(load);
  } else {
    relocate_few(load);
  }
}

/// Everybody who overlaps, the worst first, each to the best of some poses.
void Solver::relocate_many(const std::vector<double>& load) {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t b = 0; b < load.size(); ++b) {
    if (load[b] > kFeasible && p_.data.bodies[b].w > 0) order.emplace_back(-load[b], b);
  }
  std::ranges::sort(order);
  std::vector<std::pair<std::uint32_t, double>> hits;
  for (const auto& [key, b] : order) {
    // One of a pair moves away; the other may be free by then.
    placer_->overlaps(b, hits);
    double outside = 0;
    const BodyData& d = p_.data.bodies[b];
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes && p_.boundary; ++i)
      p_.room.for_each_violation(x_.boxes[i], [&](Vec2, double depth) { outside += depth; });
    if (hits.empty() && outside <= kFeasible) continue;
    const State::Body old = x_.bodies[b];
    const double cost = placer_->cost(b);
    placer_->lift(b);
    if (placer_->place(b, rng_, 32) > cost) {
      placer_->lift(b);
      x_.place(b, old.p, old.angle, old.front);
      placer_->drop(b);
    }
  }
}

/// Ruin and recreate: the worst object (now and then any), with up to four of those about it, comes out and goes back
/// in, the large ones first.
void Solver::relocate_few(const std::vector<double>& load) {
  std::vector<std::uint32_t> movable;
  double total = 0;
  for (std::uint32_t b = 0; b < load.size(); ++b) {
    if (p_.data.bodies[b].w > 0) movable.push_back(b), total += load[b];
  }
  if (movable.empty()) return;
  std::uint32_t worst = movable[rng_.index(static_cast<std::uint32_t>(movable.size()))];
  if (rng_.uniform() < 0.8) {
    double ticket = rng_.uniform(0, total);
    for (const std::uint32_t b : movable) {
      ticket -= load[b];
      if (load[b] > 0) worst = b;
      if (ticket < 0) break;
    }
  }
  std::vector<std::pair<double, std::uint32_t>> nearest;
  for (const std::uint32_t b : movable) nearest.emplace_back(length(x_.bodies[b].p - x_.bodies[worst].p), b);
  std::ranges::sort(nearest);
  const std::size_t count = std::min<std::size_t>(movable.size(), 1 + rng_.index(5));
  std::vector<std::pair<double, std::uint32_t>> out = {{-p_.data.bodies[worst].area * rng_.uniform(0.5, 2), worst}};
  for (std::size_t i = 1; i < count; ++i) {
    const std::uint32_t b =
        rng_.uniform() < 0.7 ? nearest[i].second : movable[rng_.index(static_cast<std::uint32_t>(movable.size()))];
    if (std::ranges::none_of(out, [b](const auto& o) { return o.second == b; }))
      out.emplace_back(-p_.data.bodies[b].area * rng_.uniform(0.5, 2), b);
  }
  std::ranges::sort(out);
  // Left behind, what stands on a table would hold it where it is.
  const bool along = rng_.uniform() < 0.6;
  for (std::size_t i = 0; i < out.size() && along; ++i) {
    for (const std::uint32_t f : p_.followers[out[i].second]) {
      if (std::ranges::none_of(out, [f](const auto& o) { return o.second == f; })) out.emplace_back(0, f);
    }
  }
  for (const auto& [key, b] : out) placer_->lift(b);
  for (const auto& [key, b] : out) placer_->place(b, rng_, 24);
}

/// After a feasible layout has settled with somebody far from where the constraints want him: takes out whom they cost
/// most, with neighbours, and keeps what comes out better.
void Solver::refine(int& iteration) {
  const double good = kGood * std::sqrt(total_gamma());
  for (int round = 0, fruitless = 0;
       round < kRefinements && fruitless < kFruitless && best_score_.energy > good && !cancelled(); ++round) {
    const double before = best_score_.energy;
    x_.bodies = best_.bodies, x_.boxes = best_.boxes, x_.frames = best_.frames;
    placer_->reset(std::vector<bool>(p_.data.bodies.size(), true));
    std::vector<double> load(p_.data.bodies.size());
    for (std::uint32_t b = 0; b < load.size(); ++b) load[b] = placer_->cost(b);
    relocate_few(load);
    schedule_ = 6;
    for (int i = 0; i < kSettling; ++i, ++iteration) {
      iterate();
      keep(score());
    }
    if (const Score s = score(); !s.feasible() && s.worst < kPolishable) polish();
    fruitless = best_score_.energy < before * (1 - kImprovement) ? 0 : fruitless + 1;
  }
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
    if (trace != nullptr) trace->push_back({start_, iteration, s.energy, s.violation, s.feasible(), relocated});
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
  out.start = start_;
  out.iterations = iteration;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return out;
}

}  // namespace inhabit::layout
