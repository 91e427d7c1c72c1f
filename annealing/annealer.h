#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/core.h"
#include "core/distributions.h"
#include "core/parallel.h"
#include "core/progress.h"

/// Simulated annealing with Metropolis's criterion (Yu et al. 2011, 4.1), of anything that can propose a move, say what
/// it changes, and take it back.
namespace inhabit::annealing {
using namespace core;

/// What is annealed. Copies are independent of each other.
template <class S>
concept Annealable = requires(S s, const S c, Rng& rng, double temperature) {
  /// Makes a random move and returns by how much it changed the cost.
  { s.propose(rng, temperature) } -> std::convertible_to<double>;
  s.accept();  ///< the move stays
  s.reject();  ///< the move is taken back, to the bit
  /// The cost of the present state from scratch: what the changes should have added up to.
  { c.cost() } -> std::convertible_to<double>;
  { c.snapshot() } -> std::same_as<typename S::Snapshot>;
  s.restore(c.snapshot());
};

/// How the temperature falls, 1 / beta of Yu et al. eq. 1, in units of the cost.
struct Schedule {
  enum class Shape {
    geometric,  ///< by the same share in each of 1024 stages
    linear      ///< evenly spaced (TVCG 4.3)
  } shape = Shape::geometric;
  double hot = 1, cold = 1e-3;  ///< Requires: hot >= cold; cold > 0 when geometric
};

/// The temperature at every moment. The stages' ratio comes from square roots, which round alike everywhere.
class Cooling {
 public:
  explicit Cooling(const Schedule& schedule);
  /// Requires: 0 <= iteration < total.
  double at(std::int64_t iteration, std::int64_t total) const {
    return stage_[static_cast<std::size_t>(iteration * static_cast<std::int64_t>(kStages) / total)];
  }

 private:
  static constexpr std::size_t kStages = 1024;
  std::array<double, kStages> stage_{};
};

struct AnnealOptions {
  std::int64_t iterations = 20000;
  Schedule schedule;
  std::uint64_t seed = 1, stream = 0;  ///< every random number follows from them
  /// Ends when the least cost has not fallen by more than the share `improvement` in so many iterations; 0: never
  /// (TVCG 4.3: 1500, 0.1 %).
  std::int64_t patience = 0;
  double improvement = 1e-3;
  /// Replica exchange: chain r runs at temperature T spread^r; neighbours trade temperatures every `exchange_every`
  /// iterations. Iterations count per chain.
  int replicas = 1;
  double spread = 1.5;
  int exchange_every = 256;
  int threads = 1;  ///< 0: all there are; never changes the result
  core::Progress progress;
  const core::Cancel* cancel = nullptr;
};

struct AnnealResult {
  double cost = 0;              ///< of the best state seen
  std::int64_t iterations = 0;  ///< of each chain
  std::int64_t proposed = 0, accepted = 0;
  std::int64_t exchanges = 0;  ///< trades that were accepted
  bool cancelled = false;
};

/// Looks at the coldest chain: iteration, temperature, present cost, the system. Called every `every` iterations (once
/// per block with replicas), at the beginning and at the end.
template <class S>
struct Observer {
  std::int64_t every = 0;  ///< 0: never
  std::function<void(std::int64_t, double, double, const S&)> look;
};

namespace detail {

/// One chain: a system with its own random numbers.
template <Annealable S>
struct Chain {
  S system;
  Rng rng;
  double cost = 0, best = 0;
  typename S::Snapshot best_state;
  std::int64_t proposed = 0, accepted = 0;

  Chain(const S& s, Rng r) : system(s), rng(r), cost(s.cost()), best(cost), best_state(s.snapshot()) {}

  /// One move, accepted with probability min(1, exp(beta (C - C')))   [Yu11 eq. 3]; an exponential variate instead of
  /// the exponential function, which does not round alike everywhere.
  void step(double temperature) {
    const double change = system.propose(rng, temperature);
    ++proposed;
    if (change > 0 && (temperature <= 0 || change >= temperature * core::exponential(rng))) return system.reject();
    system.accept();
    ++accepted;
    cost += change;
    if (cost < best) best = cost, best_state = system.snapshot();
  }
  /// Changes added up drift from the cost by rounding: now and then it is taken anew.
  void resync() { cost = system.cost(); }
};

/// Stops a search that no longer improves.
class Patience {
 public:
  Patience(std::int64_t patience, double improvement) : patience_(patience), share_(improvement) {}
  bool over(std::int64_t iteration, double best) {
    if (patience_ <= 0) return false;
    if (best < mark_ - share_ * std::abs(mark_)) mark_ = best, since_ = iteration;
    return iteration - since_ >= patience_;
  }

 private:
  std::int64_t patience_ = 0, since_ = 0;
  double share_ = 0, mark_ = 1e300;
};

/// Trades of temperature between neighbours on the ladder, from random numbers of their own: chains run side by side,
/// trades one after the other.
template <class S>
std::int64_t trade(std::vector<Chain<S>>& chains, std::vector<std::size_t>& at_rung, double temperature, double spread,
                   Rng& rng, bool odd) {
  std::int64_t accepted = 0;
  double t = odd ? temperature * spread : temperature;
  for (std::size_t r = odd ? 1 : 0; r + 1 < at_rung.size(); r += 2, t *= spread * spread) {
    const double gain = (1 / t - 1 / (t * spread)) * (chains[at_rung[r]].cost - chains[at_rung[r + 1]].cost);
    // Accepted with min(1, exp(gain)).
    const double threshold = core::exponential(rng);
    if (gain < 0 && -gain >= threshold) continue;
    std::swap(at_rung[r], at_rung[r + 1]);
    ++accepted;
  }
  return accepted;
}

}  // namespace detail

/// Anneals `system` and leaves it at the best state seen. The same seed gives the same bytes at any number of threads.
/// Requires: iterations > 0, replicas > 0, spread > 1 with replicas.
template <Annealable S>
AnnealResult anneal(S& system, const AnnealOptions& options, const Observer<S>& observer = {}) {
  const Cooling cooling(options.schedule);
  const auto count = static_cast<std::size_t>(std::max(1, options.replicas));
  std::vector<detail::Chain<S>> chains;
  chains.reserve(count);
  std::vector<std::size_t> at_rung(count);
  for (std::size_t r = 0; r < count; ++r) {
    chains.emplace_back(system, Rng(options.seed, options.stream * 4096 + r));
    at_rung[r] = r;
  }
  Rng trades(options.seed, options.stream * 4096 + 4095);
  detail::Patience patience(options.patience, options.improvement);
  AnnealResult result;
  const std::int64_t block = count > 1 ? std::max(1, options.exchange_every) : 64;
  const auto best = [&] { return std::ranges::min_element(chains, {}, [](const auto& c) { return c.best; }); };
  const auto observe = [&](std::int64_t i) {
    const detail::Chain<S>& cold = chains[at_rung.front()];
    observer.look(i, cooling.at(std::min(i, options.iterations - 1), options.iterations), cold.cost, cold.system);
  };
  if (observer.every > 0) observe(0);
  std::int64_t i = 0, seen = 0;
  for (std::int64_t round = 0; i < options.iterations; ++round) {
    if (options.cancel != nullptr && options.cancel->requested()) {
      result.cancelled = true;
      break;
    }
    const std::int64_t end = std::min(i + block, options.iterations);
    const auto run = [&](std::size_t rung) {
      detail::Chain<S>& chain = chains[at_rung[rung]];
      double factor = 1;
      for (std::size_t k = 0; k < rung; ++k) factor *= options.spread;
      for (std::int64_t k = i; k < end; ++k) chain.step(factor * cooling.at(k, options.iterations));
      if (round % 64 == 63) chain.resync();
    };
    if (count == 1) {
      run(0);
    } else {
      core::parallel_for(count, options.threads, run);
      result.exchanges += detail::trade(chains, at_rung, cooling.at(end - 1, options.iterations), options.spread,
                                        trades, round % 2 == 1);
    }
    i = end;
    if (observer.every > 0 && i - seen >= observer.every) seen = i, observe(i);
    if (options.progress && round % 64 == 0)
      options.progress(static_cast<double>(i) / static_cast<double>(options.iterations), "annealing");
    if (patience.over(i, best()->best)) break;
  }
  if (observer.every > 0 && seen != i) observe(i);
  result.iterations = i;
  for (const auto& chain : chains) result.proposed += chain.proposed, result.accepted += chain.accepted;
  system.restore(best()->best_state);
  result.cost = system.cost();
  return result;
}

}  // namespace inhabit::annealing
