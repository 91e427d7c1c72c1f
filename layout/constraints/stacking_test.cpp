#include "layout/constraints/stacking.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"
#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// A plate 0.2 m square at `p` on a table 2 m wide and 1 m deep at (5, 5) that faces `angle`.
struct Table {
  World w;
  StackingTerm c;
  explicit Table(Vec2 p, double angle = 0, double plate = 0.2) {
    c.upper_size = {plate, plate, 0.1}, c.lower_size = {2, 1, 0.7};
    c.upper = w.add(p, angle, 1, c.upper_size), c.lower = w.add({5, 5}, angle, 9, c.lower_size);
    c.anywhere = true;
    w.pin(c.lower);
  }
  Vec2 end() const { return projected(c, w.x).position(c.upper); }
};

}  // namespace

TEST_CASE("stacking: centres meet in inverse proportion to the masses") {
  World w;
  StackingTerm c;
  c.upper = w.add({1, 0}, 0, 1), c.lower = w.add({0, 0}, 0, 9);
  CHECK(error(c, w.x) == 1);
  const State y = projected(c, w.x);
  CHECK(distance(y.position(c.upper), {0.1, 0}) < 1e-15);
  CHECK(distance(y.position(c.lower), {0.1, 0}) < 1e-15);
  CHECK(change(y, projected(c, y)) < 1e-15);
}

TEST_CASE("stacking: anywhere keeps the upper box on the top") {
  CHECK(Table({5.3, 5.8}).end() == Vec2{5.3, 5.8});
  CHECK(distance(Table({6, 5}).end(), {5.4, 5}) < 1e-14);
  CHECK(distance(Table({6, 7}).end(), {5.4, 5.9}) < 1e-14);
  // The table turned to +y: its depth of 1 m lies along y now.
  CHECK(distance(Table({6, 7}, kPi / 2).end(), {5.9, 5.4}) < 1e-14);
}

TEST_CASE("stacking: anywhere on a top that is too small means centred across it") {
  CHECK(distance(Table({5.3, 5.2}, 0, 1.5).end(), {5, 5.2}) < 1e-14);
  CHECK(distance(Table({5.3, 5.2}, 0, 3).end(), {5, 5}) < 1e-14);
}

TEST_CASE("stacking: coincident or pinned objects stay") {
  World w;
  StackingTerm c;
  c.upper = w.add({1, 0}), c.lower = w.add({1, 0});
  CHECK(change(w.x, projected(c, w.x)) == 0);
  c.lower = w.add({3, 0});
  w.pin(c.upper), w.pin(c.lower);
  CHECK(change(w.x, projected(c, w.x)) == 0);
}

TEST_CASE("stacking: heights add up along the stack in whatever order it is written") {
  Scene scene = empty_room(5, 5);
  const Ref cup = add(scene, "cup", {0.1, 0.1, 0.1}), book = add(scene, "book", {0.3, 0.2, 0.05});
  const Ref table = add(scene, "table", {1, 1, 0.7}), lamp = add(scene, "lamp", {0.2, 0.2, 0.4});
  Stacking upper, lower;
  upper.object = cup, upper.on = book;
  lower.object = book, lower.on = table, lower.anywhere = true;
  scene.constraints.add(upper);
  scene.constraints.add(lower);
  scene.objects[lamp.index].on = book;
  const auto problem = compile(scene);
  REQUIRE(problem.ok());
  CHECK(problem->base_of_object[table.index] == 0);
  CHECK(std::abs(problem->base_of_object[book.index] - 0.7) < 1e-15);
  CHECK(std::abs(problem->base_of_object[cup.index] - 0.75) < 1e-15);
  CHECK(std::abs(problem->base_of_object[lamp.index] - 0.75) < 1e-15);
  // The centred ones are one particle; what stands anywhere is held by a term.
  CHECK(problem->body_of_object[cup.index] == problem->body_of_object[book.index]);
  CHECK(problem->body_of_object[book.index] != problem->body_of_object[table.index]);
}

TEST_CASE("stacking: a stack that stands on itself is an error") {
  Scene scene = empty_room(5, 5);
  const Ref a = add(scene, "a", {1, 1, 1}), b = add(scene, "b", {1, 1, 1});
  scene.objects[a.index].on = b, scene.objects[b.index].on = a;
  CHECK_FALSE(compile(scene).ok());
}
