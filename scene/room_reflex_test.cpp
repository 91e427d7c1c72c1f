#include <doctest/doctest.h>

#include "core/rng.h"
#include "geometry/containment.h"
#include "scene/room.h"

using namespace inhabit::scene;

namespace {
constexpr double kTolerance = 1e-6;

double deepest(const Room& room, const Box& box) {
  double depth = 0;
  room.for_each_violation(box, [&](Vec2, double d) { depth = std::max(depth, d); });
  return depth;
}

Box box_at(Vec2 p, double angle, double depth, double width) { return {p, direction(angle), depth / 2, width / 2}; }

const Ring kCorner = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
}  // namespace

TEST_CASE(
    "a box that lies along one wall of a reflex corner and through the other is outside by what it reaches beyond") {
  const Room room(kCorner, {});
  // Its lower edge in line with the wall y = 2, its left part behind the wall x = 2.
  CHECK(deepest(room, box_at({2.3, 2.05}, 0, 1, 0.1)) > 0.09);
  CHECK(deepest(room, box_at({1.5, 2.05}, 0, 1, 0.1)) < kTolerance);
}

TEST_CASE("at a reflex corner the pushes are there exactly when the box is outside and bring it in") {
  const Room room(kCorner, {});
  const Floor floor = make_floor(kCorner, {});
  inhabit::core::Rng rng(7, 0);
  for (int i = 0; i < 20000; ++i) {
    Box box = box_at({rng.uniform(0.5, 3.5), rng.uniform(0.5, 3.5)}, rng.index(2) == 0 ? 0 : rng.uniform(-kPi, kPi),
                     rng.uniform(0.05, 0.9), rng.uniform(0.05, 0.9));
    const double outside = outside_depth(floor, box), depth = deepest(room, box);
    CHECK((depth > kTolerance) == (outside > kTolerance));
    for (int round = 0; round < 60 && deepest(room, box) > kTolerance; ++round)
      room.for_each_violation(box, [&](Vec2 n, double d) { box.center += d * n; });
    CHECK(outside_depth(floor, box) < 2 * kTolerance);
  }
}
