#include "layout/constraints/collision.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// Boxes 2 m wide (along x) and 0.4 m deep at x = 4 and `second`.
struct Two {
  Scene scene = empty_room(10, 10);
  Ref a, b;
  explicit Two(Vec2 second, Vec2 first = {4, 5}) {
    a = add(scene, "a", {2, 0.4, 1}, first), b = add(scene, "b", {2, 0.4, 1}, second);
  }
};

}  // namespace

TEST_CASE("collision: boxes part along the smallest translation") {
  const Two two({5.9, 5.1});
  Ready ready(two.scene);
  const Separation s = contact(ready.problem, ready.x, 0, 1);
  CHECK(std::abs(s.depth - 0.1) < 1e-14);
  CHECK(length(s.normal - Vec2{-1, 0}) < 1e-14);
  ready.project_collisions();
  CHECK(length(ready.at(two.a) - Vec2{3.95, 5}) < 1e-14);
  CHECK(length(ready.at(two.b) - Vec2{5.95, 5.1}) < 1e-14);
  CHECK(contact(ready.problem, ready.x, 0, 1).depth < 1e-14);
}

TEST_CASE("collision: half the stiffness parts them half as far and the pinned one stays") {
  Two two({5.9, 5.1});
  two.scene.objects[0].fixed = true;
  Ready ready(two.scene);
  ready.project_collisions(0.5);
  CHECK(ready.at(two.a) == Vec2{4, 5});
  CHECK(length(ready.at(two.b) - Vec2{5.95, 5.1}) < 1e-14);
}

TEST_CASE("collision: spheres part to the sum of the radii but only boxes that meet") {
  Two two({5.9, 5.1});
  Collision c;
  c.members = list_of({two.a, two.b}), c.mode = 1;
  two.scene.constraints.add(c);
  Ready ready(two.scene);
  ready.project_collisions();
  CHECK(std::abs(length(ready.at(two.a) - ready.at(two.b)) - 2 * std::hypot(1, 0.2)) < 1e-14);
  Two apart({4, 5.5});
  apart.scene.constraints.add(c);
  Ready still(apart.scene);
  still.project_collisions();
  CHECK(still.at(two.b) == Vec2{4, 5.5});
}

TEST_CASE("collision: none when it is off and none between heights that do not meet") {
  for (const bool all : {true, false}) {
    Two two({5.9, 5.1});
    Collision c;
    if (!all) c.members = list_of({two.a, two.b});
    c.mode = 2;
    two.scene.constraints.add(c);
    Ready ready(two.scene);
    ready.project_collisions();
    CHECK(ready.at(two.b) == Vec2{5.9, 5.1});
  }
  Two above({5.9, 5.1});
  above.scene.objects[1].position->z = 1;
  Ready ready(above.scene);
  ready.project_collisions();
  CHECK(ready.at(above.b) == Vec2{5.9, 5.1});
}

TEST_CASE("collision: coincident boxes part for good") {
  const Two two({4, 5});
  Ready ready(two.scene);
  ready.project_collisions();
  CHECK(contact(ready.problem, ready.x, 0, 1).depth < 1e-14);
  CHECK(std::abs(length(ready.at(two.a) - ready.at(two.b)) - 0.4) < 1e-14);
}

TEST_CASE("collision: two objects at one wall part along it as well") {
  Two two({5.5, 0.2}, {4, 0.2});
  WallDistance wall;
  wall.members = list_of({two.a, two.b});
  two.scene.constraints.add(wall);
  Ready ready(two.scene);
  // Shortest: 0.4 m away from the wall. Along it they overlap by half a metre.
  ready.project_collisions();
  CHECK(std::abs(ready.at(two.a).x - 3.75) < 1e-14);
  CHECK(std::abs(ready.at(two.b).x - 5.75) < 1e-14);
  CHECK(std::abs(std::abs(ready.at(two.a).y - ready.at(two.b).y) - 0.4) < 1e-14);
  Two free({5.5, 0.2}, {4, 0.2});
  Ready loose(free.scene);
  loose.project_collisions();
  CHECK(std::abs(loose.at(free.a).x - 4) < 1e-14);
}

TEST_CASE("collision: many boxes find the same pairs as few") {
  // Above 24 boxes pairs come from a grid.
  Rng rng(3);
  Scene scene = empty_room(12, 12);
  for (int i = 0; i < 80; ++i) {
    const double size = i == 0 ? 6 : rng.uniform(0.3, 1.5);
    add(scene, "o" + std::to_string(i), {size, rng.uniform(0.3, 1.5), 1}, {rng.uniform(0, 12), rng.uniform(0, 12)},
        rng.uniform(-180, 180));
  }
  Ready ready(scene);
  Contacts contacts(ready.problem);
  for (int round = 0; round < 20; ++round) {
    contacts.refresh(ready.x);
    Score s;
    double squares = 0, depth = 0;
    contacts.score_collisions(ready.x, s, squares);
    for (std::size_t i = 0; i < 80; ++i) {
      for (std::size_t j = i + 1; j < 80; ++j)
        depth += std::max(0.0, separation(ready.x.boxes[i], ready.x.boxes[j]).depth);
    }
    CHECK(s.violation == doctest::Approx(depth).epsilon(1e-12));
    for (std::uint32_t b = 0; b < 80; ++b) ready.x.shift(b, {rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)});
  }
}
