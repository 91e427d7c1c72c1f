#include "crowd/overlap.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"
#include "crowd/people.h"
#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("overlaps of pairs and with walls by hand") {
  const Walls walls({make_floor(rectangle(0, 0, 10, 10), {})}, {}, 1);
  Agents agents;
  OverlapMeter meter;
  CHECK(meter.measure(agents, walls, 1).depth == 0);
  add_person(agents, {0.5f, 1, 1, 1}, 0, 0, 5, 5);
  add_person(agents, {0.25f, 1, 1, 1}, 1, 0, 5.625f, 5);  // 1/8 m deep, 1/6 of the radii
  add_person(agents, {0.25f, 1, 1, 1}, 2, 0, 8, 5);
  add_person(agents, {0.25f, 1, 1, 1}, 3, 0, 8.4375f, 5);  // 1/16 m deep, 1/8 of the radii
  add_person(agents, {0.5f, 1, 1, 1}, 4, 0, 1, 0.375f);    // 1/8 m in the wall
  const Overlap overlap = meter.measure(agents, walls, 1);
  CHECK(overlap.depth == doctest::Approx(0.125));
  CHECK(overlap.share == doctest::Approx(1.0 / 6));
  CHECK(overlap.wall == doctest::Approx(0.125));
}

TEST_CASE("overlaps of a crowd are those of all pairs at any number of threads") {
  Agents agents;
  core::Rng rng(4);
  for (std::uint32_t k = 0; k < 6000; ++k)
    add_person(agents, {static_cast<float>(rng.uniform(0.05, 1)), 1, 1, 1}, k, 0,
               static_cast<float>(rng.uniform(0, 400)), static_cast<float>(rng.uniform(0, 400)));
  double depth = 0, share = 0;
  for (std::size_t i = 0; i < agents.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double radii = agents.radius[i] + agents.radius[j];
      const double d = radii - std::hypot(agents.x[i] - agents.x[j], agents.y[i] - agents.y[j]);
      depth = std::max(depth, d), share = std::max(share, d / radii);
    }
  OverlapMeter meter;
  for (const int threads : {1, 2, 8}) {
    const Overlap overlap = meter.measure(agents, Walls(), threads);
    CHECK(overlap.depth == doctest::Approx(depth));
    CHECK(overlap.share == doctest::Approx(share));
  }
}
