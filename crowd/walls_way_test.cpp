#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/test_rooms.h"
#include "crowd/walls.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("short ways leave the floor exactly when they end off it or cross something thin") {
  // A room with a partition a millimetre thick, and a reflex corner.
  const Ring outline = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const std::vector<Floor> floors = {make_floor(outline, {rectangle(0.5, 1, 1.5, 1.001)})};
  const Walls walls(floors, {}, 0.5);
  CHECK(walls.leaves(1, 0.9f, 1, 1.1f));
  CHECK_FALSE(walls.leaves(1, 0.9f, 1.2f, 0.95f));
  CHECK_FALSE(walls.leaves(1.6f, 0.9f, 1.6f, 1.1f));
  CHECK_FALSE(walls.leaves(1, 0.1f, 1, 0));  // the border belongs to the floor
  CHECK(walls.leaves(1, 0, 1, -1e-6f));
  core::Rng rng(11);
  for (int k = 0; k < 20000; ++k) {
    const auto x = static_cast<float>(rng.uniform(0, 4)), y = static_cast<float>(rng.uniform(0, 4));
    const auto tx = static_cast<float>(x + rng.uniform(-0.35, 0.35)),
               ty = static_cast<float>(y + rng.uniform(-0.35, 0.35));
    if (!walls.on_floor(x, y)) continue;
    if (walls.in_the_open(x, y)) CHECK(walls.on_floor(x, y));
    REQUIRE(walls.leaves(x, y, tx, ty) == !walls.sees(x, y, tx, ty));
  }
}

TEST_CASE("in the open there is no wall within the reach") {
  const std::vector<Floor> floors = {make_floor(rectangle(0, 0, 20, 20), {rectangle(9, 9, 11, 11)})};
  const Walls walls(floors, {10, 10}, 1);
  int open = 0;
  core::Rng rng(5);
  for (int k = 0; k < 5000; ++k) {
    const auto x = static_cast<float>(rng.uniform(-11, 11)), y = static_cast<float>(rng.uniform(-11, 11));
    if (!walls.in_the_open(x, y)) continue;
    ++open;
    float nearest = 1e9f;
    for (const WallSegment& s : walls.segments()) {
      const WallPoint p = nearest_point(s, x, y);
      nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
    }
    REQUIRE(nearest >= 1);
  }
  CHECK(open > 2000);
  CHECK_FALSE(walls.in_the_open(std::nanf(""), 0));
  CHECK(Walls().in_the_open(1e6f, 0));
  CHECK_FALSE(Walls().in_the_open(std::nanf(""), 0));
}
