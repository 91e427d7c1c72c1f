#include "annealing/targets.h"

#include <doctest/doctest.h>

#include <set>

#include "annealing/test_room.h"

using namespace inhabit::annealing;
using namespace inhabit::annealing::testing;

TEST_CASE("each object gets one of its kind's wall modes in proportion to their examples") {
  Priors priors;
  priors.kinds.push_back(at_wall("shelf", 0));
  priors.kinds[0].wall = {{0.0, 0, 0.01, 0.01, 30}, {1.5, kPi, 0.01, 0.01, 10}};
  Scene scene = empty_room();
  for (int k = 0; k < 400; ++k) scene.objects.push_back(thing("s" + std::to_string(k), "shelf", {1, 0.3, 2}));
  const Targets a = choose_targets(scene, priors, 5), b = choose_targets(scene, priors, 5),
                c = choose_targets(scene, priors, 6);
  int first = 0, differ = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    REQUIRE(a.objects[i].wall.has_value());
    CHECK(a.objects[i].wall == b.objects[i].wall);
    first += a.objects[i].wall->distance == 0 ? 1 : 0;
    differ += a.objects[i].wall == c.objects[i].wall ? 0 : 1;
  }
  // 300 expected, binomial deviation 8.7: five of them.
  CHECK(std::abs(first - 300) < 44);
  CHECK(differ > 50);
}

TEST_CASE("the places round a table are shared out one each") {
  Priors priors;
  PairPrior seats{"table", "chair", {}, 4, false, 20, 5, 0.02, false};
  for (int k = 0; k < 4; ++k) seats.modes.push_back({0.8, k * kPi / 2, 0, 0.02, 0.05, 0.05, 5});
  priors.pairs.push_back(seats);
  Scene scene = empty_room();
  for (int k = 0; k < 2; ++k) scene.objects.push_back(thing("t" + std::to_string(k), "table", {1, 1, 0.75}));
  for (int k = 0; k < 8; ++k) scene.objects.push_back(thing("c" + std::to_string(k), "chair", {0.4, 0.4, 0.9}));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Targets targets = choose_targets(scene, priors, seed);
    REQUIRE(targets.pairs.size() == 8);
    for (std::uint32_t table = 0; table < 2; ++table) {
      std::set<double> bearings;
      for (const PairTarget& p : targets.pairs)
        if (p.first == table) bearings.insert(p.mode.bearing);
      CHECK(bearings.size() == 4);
    }
  }
}

TEST_CASE("plates stand on the table of their chair") {
  const Priors priors = some_priors();
  Scene scene = flat(2);
  const Targets targets = choose_targets(scene, priors, 1);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].kind != "plate") continue;
    const auto own = std::ranges::find_if(targets.pairs, [&](const PairTarget& p) { return p.second == i; });
    REQUIRE(own != targets.pairs.end());
    const auto seat = std::ranges::find_if(targets.pairs, [&](const PairTarget& p) { return p.second == own->first; });
    REQUIRE(seat != targets.pairs.end());
    CHECK(targets.objects[i].carrier == seat->first);
    CHECK(targets.objects[i].carriers.size() == 2);
  }
}

TEST_CASE("what the scene says goes before what was learned") {
  const Priors priors = some_priors();
  Scene scene = flat(1);
  Object& sofa = scene.objects[9];
  REQUIRE(sofa.kind == "sofa");
  sofa.clearance.back = 0.3;
  const Targets targets = choose_targets(scene, priors, 1);
  CHECK(targets.objects[9].access == std::array<double, 4>{0.3, 0, 0, 0});
  CHECK(targets.objects[7].access == std::array<double, 4>{0, 0, 0.5, 0});
}

TEST_CASE("unknown kinds and missing carriers and weak priors are told of") {
  Priors priors = some_priors();
  Scene scene = empty_room();
  scene.objects = {thing("g", "gizmo", {1, 1, 1}), thing("p", "plate", {0.2, 0.2, 0.1}),
                   thing("l", "lamp", {0.3, 0.3, 1.5})};
  priors.kinds[2].count = 1, priors.kinds[2].by_hand = false;
  const Targets targets = choose_targets(scene, priors, 1);
  REQUIRE(targets.warnings.size() == 3);
  CHECK(targets.warnings[0].find("no table to carry it") != std::string::npos);
  CHECK(targets.warnings[1].find("\"gizmo\"") != std::string::npos);
  CHECK(targets.warnings[2].find("one example") != std::string::npos);
  CHECK(targets.objects[1].carrier == kNobody);
}
