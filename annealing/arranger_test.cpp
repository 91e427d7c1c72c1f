#include "annealing/arranger.h"

#include <doctest/doctest.h>

#include "annealing/test_room.h"

using namespace inhabit::annealing;
using namespace inhabit::annealing::testing;

TEST_CASE("the changes that moves report add up to the full cost whatever moves are made") {
  const Priors priors = some_priors();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scene scene = flat(seed % 2 == 0 ? 1 : 3);
    if (seed % 3 == 0) scene.space.outline.insert(scene.space.outline.begin() + 2, {{5, 2.5}, {5, 3}});
    const Targets targets = choose_targets(scene, priors, seed);
    const auto furniture = compile(scene, targets, {});
    REQUIRE(furniture.ok());
    Arranger arranger(*furniture, {});
    Rng rng(seed, 7);
    arranger.scatter(rng, false);
    double cost = arranger.cost();
    for (int k = 0; k < 3000; ++k) {
      const Arrangement::Snapshot before = arranger.snapshot();
      const double change = arranger.propose(rng, rng.uniform(0.01, 1.0));
      if (rng.index(2) == 0) {
        arranger.reject();
        REQUIRE(arranger.snapshot() == before);
      } else {
        arranger.accept();
        cost += change;
      }
      if (k % 50 != 0) continue;
      const Costs full = full_cost(arranger.arrangement()), grid = grid_cost(arranger.arrangement());
      // 3000 sums of numbers below 1e4: rounding errors of 1e-12 each.
      CHECK(std::abs(cost - weighted(full, furniture->weights)) < 1e-7);
      for (std::size_t t = 0; t < full.size(); ++t) {
        CHECK(std::abs(full[t] - grid[t]) < 1e-9);
        CHECK(std::abs(full[t] - arranger.costs()[t]) < 1e-7);
      }
    }
  }
}

TEST_CASE("a snapshot restored is the arrangement it was taken of") {
  const Priors priors = some_priors();
  const Scene scene = flat(2);
  const auto furniture = compile(scene, choose_targets(scene, priors, 3), {});
  REQUIRE(furniture.ok());
  Arranger arranger(*furniture, {});
  Rng rng(5);
  arranger.scatter(rng, false);
  const Arrangement::Snapshot taken = arranger.snapshot();
  const double cost = arranger.cost();
  for (int k = 0; k < 500; ++k) arranger.propose(rng, 1), arranger.accept();
  CHECK(arranger.snapshot() != taken);
  arranger.restore(taken);
  CHECK(arranger.snapshot() == taken);
  CHECK(std::abs(arranger.cost() - cost) < 1e-9);  // the same terms in another order
}

TEST_CASE("what stands on a table goes where the table goes") {
  const Priors priors = some_priors();
  const Scene scene = flat(1);
  const auto furniture = compile(scene, choose_targets(scene, priors, 1), {});
  REQUIRE(furniture.ok());
  Arrangement x(*furniture);
  const std::uint32_t table = 0, plate = 5;
  REQUIRE(scene.objects[plate].kind == "plate");
  REQUIRE(x.carrier(plate) == table);
  CHECK(x.body(plate).low == 0.75);
  x.touch(plate);
  x.place(plate, x.position(table) + Vec2{0.2, 0.1}, 0.5);
  x.settle();
  x.touch(table);
  CHECK(x.touched(plate));
  x.place(table, {2, 2}, kPi / 2);
  x.settle();
  CHECK(length(x.position(plate) - Vec2{1.9, 2.2}) < 1e-12);
  CHECK(std::abs(x.angle(plate) - (0.5 + kPi / 2)) < 1e-12);
}

TEST_CASE("a flat is furnished without overlaps and the same at any number of threads") {
  const Priors priors = some_priors();
  const Scene scene = flat(1);
  const Targets targets = choose_targets(scene, priors, 1);
  Options options;
  options.starts = 3, options.given = false, options.replicas = 2, options.iterations = 5000;
  options.threads = 1;
  const auto one = arrange(scene, targets, options);
  options.threads = 4;
  const auto four = arrange(scene, targets, options);
  REQUIRE(one.ok());
  REQUIRE(four.ok());
  CHECK(one->best.poses == four->best.poses);
  CHECK(one->best.paths == four->best.paths);
  CHECK(one->best.cost == four->best.cost);
  CHECK(one->best.fits);
}
