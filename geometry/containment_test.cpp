#include "geometry/containment.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace inhabit::geometry;

namespace {

/// An L: the square [0, 4] x [0, 4] without its upper right quarter.
Floor l_shape() { return make_floor({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, {}); }
Floor with_pillar(double half) {
  return make_floor({{0, 0}, {6, 0}, {6, 6}, {0, 6}},
                    {{{3 - half, 3 - half}, {3 + half, 3 - half}, {3 + half, 3 + half}, {3 - half, 3 + half}}});
}
Box box(double x, double y, double depth, double width, double angle = 0) {
  return {{x, y}, direction(angle), depth / 2, width / 2};
}

}  // namespace

TEST_CASE("a box inside an L or flush with its walls is not outside") {
  CHECK(outside_depth(l_shape(), box(1, 1, 2, 2)) == 0);
  CHECK(outside_depth(l_shape(), box(1, 3, 2, 2)) == 0);
  CHECK(outside_depth(l_shape(), box(2, 1, 4, 2)) == 0);
  CHECK(outside_depth(l_shape(), box(1, 1, 1, 1, 0.7)) == 0);
}

TEST_CASE("a box through a straight wall is outside by what sticks out") {
  CHECK(outside_depth(l_shape(), box(0.4, 1, 1, 1)) == doctest::Approx(0.1));
  CHECK(outside_depth(l_shape(), box(-2, 1, 1, 1)) == doctest::Approx(2.5));
  // Turned by 45 degrees its corner reaches sqrt(2) / 2 from the centre.
  CHECK(outside_depth(l_shape(), box(0.5, 1, 1, 1, kPi / 4)) == doctest::Approx(std::sqrt(0.5) - 0.5));
}

TEST_CASE("a reflex corner inside a box counts though no corner of the box is outside") {
  // The box's corner lies in the notch; turned, only the notch's corner lies in the box.
  CHECK(outside_depth(l_shape(), box(1.6, 1.6, 1, 1)) == doctest::Approx(0.1));
  const Box turned = box(2 - 0.3, 2 - 0.3, 1, 3, kPi / 4);
  CHECK(outside_depth(l_shape(), turned) == doctest::Approx(0.5 - 0.3 * std::sqrt(2.0)));
}

TEST_CASE("a thin pillar wholly inside a box counts by the way it has to go to leave the box") {
  // Its farthest corner is 1 m minus half the pillar from the nearest face; the middle of its sides is the deepest.
  CHECK(outside_depth(with_pillar(0.05), box(3, 3, 2, 2)) == doctest::Approx(0.95));
  CHECK(outside_depth(with_pillar(0.05), box(4.02, 3, 2, 2)) == doctest::Approx(0.03));
  CHECK(outside_depth(with_pillar(0.05), box(4.05, 3, 2, 2)) == doctest::Approx(0));
}

TEST_CASE("a box in a pillar of its own size is outside") {
  CHECK(outside_depth(with_pillar(0.5), box(3, 3, 1, 1)) == doctest::Approx(0.5));
  CHECK(outside_depth(with_pillar(0.5), box(3, 3, 0.2, 0.2)) == doctest::Approx(0.5));
}

TEST_CASE("a partition that crosses a box counts though no corner lies in the other") {
  const Floor floor = make_floor({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{1, 2.95}, {5, 2.95}, {5, 3.05}, {1, 3.05}}});
  CHECK(outside_depth(floor, box(3, 3, 2, 1)) == doctest::Approx(0.45));
}

TEST_CASE("outside_depth is zero exactly when no sample of the box is off the floor") {
  const Floor floor =
      make_floor({{0, 0}, {5, 0}, {5, 2}, {3, 1.5}, {2, 4}, {0, 4}}, {{{0.8, 2}, {1, 2.1}, {0.9, 2.3}}});
  inhabit::core::Rng rng(41);
  int inside = 0, outside = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Box b{{rng.uniform(-0.5, 5.5), rng.uniform(-0.5, 4.5)},
                direction(rng.uniform(-kPi, kPi)),
                rng.uniform(0.05, 0.8),
                rng.uniform(0.05, 0.8)};
    double deepest = 0;
    constexpr int kSteps = 20;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        const Vec2 p = b.center + (2.0 * i / kSteps - 1) * b.half_depth * b.front +
                       (2.0 * j / kSteps - 1) * b.half_width * b.left();
        deepest = std::max(deepest, outside_distance(floor, p));
      }
    const double depth = outside_depth(floor, b);
    if (deepest > 1e-12) CHECK(depth > 0);
    if (depth == 0) CHECK(deepest < 1e-12);
    (depth == 0 ? inside : outside)++;
  }
  CHECK(inside > 300);
  CHECK(outside > 300);
}

TEST_CASE("area and contains know the holes") {
  CHECK(area(with_pillar(0.5)) == doctest::Approx(35));
  CHECK_FALSE(contains(with_pillar(0.5), {3, 3}));
  CHECK(contains(with_pillar(0.5), {3.5, 3}));
  CHECK(contains(with_pillar(0.5), {1, 1}));
  CHECK_FALSE(contains(with_pillar(0.5), {7, 1}));
}
