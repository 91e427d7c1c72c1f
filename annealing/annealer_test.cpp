#include "annealing/annealer.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace inhabit::annealing;

namespace {

/// A walk on the whole numbers -20 … 20 in a cost with a poor well at -12 and a good one at 12.
struct Wells {
  int at = -12, before = -12;
  static double cost_at(int x) { return std::min(2 + 0.5 * std::abs(x + 12), 0.5 * std::abs(x - 12)); }
  double propose(Rng& rng, double) {
    before = at;
    at += rng.index(2) == 0 ? 1 : -1;
    if (at < -20 || at > 20) at = before;
    return cost_at(at) - cost_at(before);
  }
  void accept() {}
  void reject() { at = before; }
  double cost() const { return cost_at(at); }
  using Snapshot = int;
  int snapshot() const { return at; }
  void restore(int x) { at = x; }
};

}  // namespace

TEST_CASE("temperatures fall from hot to cold by equal shares or by equal steps") {
  const Cooling geometric({Schedule::Shape::geometric, 8, 0.5});
  CHECK(geometric.at(0, 1000) == 8);
  // Half way on a geometric scale; 512 stages of rounding.
  CHECK(std::abs(geometric.at(500, 1000) - 2) < 1e-9);
  CHECK(geometric.at(999, 1000) < 0.51);
  const Cooling linear({Schedule::Shape::linear, 8, 0});
  CHECK(linear.at(0, 1000) == 8);
  CHECK(linear.at(500, 1000) == 4);
  CHECK(linear.at(999, 1000) < 0.02);
}

TEST_CASE("at one temperature states are visited as often as Boltzmann says") {
  // 200,000 visits of 41 states at T = 2: shares below 0.1 have a standard error of less than 0.01 even if only every
  // two hundredth visit is independent of the last.
  detail::Chain<Wells> chain(Wells{}, Rng(3));
  std::vector<double> seen(41);
  constexpr int kVisits = 200000;
  for (int k = 0; k < kVisits; ++k) {
    chain.step(2);
    seen[static_cast<std::size_t>(chain.system.at + 20)] += 1.0 / kVisits;
  }
  double sum = 0;
  for (int x = -20; x <= 20; ++x) sum += std::exp(-Wells::cost_at(x) / 2);
  for (int x = -20; x <= 20; ++x) {
    CAPTURE(x);
    CHECK(std::abs(seen[static_cast<std::size_t>(x + 20)] - std::exp(-Wells::cost_at(x) / 2) / sum) < 0.03);
  }
}

TEST_CASE("annealing leaves the poor well and quenching does not") {
  AnnealOptions options;
  options.iterations = 20000;
  int found = 0, quenched = 0;
  for (options.seed = 1; options.seed <= 20; ++options.seed) {
    options.schedule = {Schedule::Shape::geometric, 5, 0.01};
    Wells hot;
    found += anneal(hot, options).cost == 0 ? 1 : 0;
    options.schedule = {Schedule::Shape::geometric, 0.01, 0.01};
    Wells cold;
    quenched += anneal(cold, options).cost == 0 ? 1 : 0;
  }
  CHECK(found >= 17);  // a matter of chance: 19 with these seeds
  CHECK(quenched == 0);
}

TEST_CASE("replicas trade temperatures and come to the same at any number of threads") {
  AnnealOptions options;
  options.iterations = 4000, options.replicas = 4, options.exchange_every = 50;
  // The coldest chain never leaves its well by itself.
  options.schedule = {Schedule::Shape::geometric, 0.3, 0.05};
  options.spread = 3;
  Wells one, eight;
  options.threads = 1;
  const AnnealResult a = anneal(one, options);
  options.threads = 8;
  const AnnealResult b = anneal(eight, options);
  CHECK(one.at == eight.at);
  CHECK(a.accepted == b.accepted);
  CHECK(a.exchanges == b.exchanges);
  CHECK(a.exchanges > 0);
  CHECK(a.proposed == 16000);
  CHECK(one.cost() == 0);
}

TEST_CASE("a search that no longer improves ends and a cancelled one keeps its best") {
  AnnealOptions options;
  options.iterations = 1000000, options.patience = 1500;
  Wells wells;
  const AnnealResult result = anneal(wells, options);
  CHECK(result.iterations < 100000);
  CHECK(result.iterations >= 1500);
  inhabit::core::Cancel cancel;
  cancel.request();
  options.cancel = &cancel;
  Wells stopped;
  const AnnealResult none = anneal(stopped, options);
  CHECK(none.cancelled);
  CHECK(none.iterations == 0);
  CHECK(stopped.at == -12);
}

TEST_CASE("an observer sees the first and the last iteration") {
  AnnealOptions options;
  options.iterations = 1000;
  std::vector<std::int64_t> seen;
  Observer<Wells> observer{100, [&](std::int64_t i, double, double, const Wells&) { seen.push_back(i); }};
  Wells wells;
  static_cast<void>(anneal(wells, options, observer));
  CHECK(seen.front() == 0);
  CHECK(seen.back() == 1000);
  CHECK(seen.size() >= 8);
}
