#include <algorithm>

#include "layout/solver.h"

/// The discrete moves between projections: who is taken out, and when what comes of it is kept.
namespace inhabit::layout {
namespace {

constexpr int kRefinements = 6;     ///< relocations that look for a better energy once a layout is feasible
constexpr int kSettling = 5;        ///< iterations after each
constexpr int kFruitless = 2;       ///< so many without success end the search
constexpr double kGood = 0.03;      ///< root mean square residual that needs none: 3 cm, 1.7 degrees
constexpr double kFeasible = 1e-3;  ///< metres (scene.md)

}  // namespace

std::vector<double> Solver::loads() const {
  std::vector<double> load(p_.data.bodies.size());
  contacts_.add_load(x_, load);
  if (!p_.boundary) return load;
  p_.for_each_movable_box([&](std::uint32_t i, std::uint32_t body) {
    double deepest = 0;
    p_.room.for_each_violation(x_.boxes[i], [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
    load[body] += deepest;
  });
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

}  // namespace inhabit::layout
