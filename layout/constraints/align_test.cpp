#include "layout/constraints/align.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"
#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

Vec2 first_end(double axis) {
  World w;
  AlignTerm c;
  c.a = w.add({1, 1}), c.b = w.add({5, 3}), c.normal = perp(direction(axis));
  return projected(c, w.x).position(c.a);
}

}  // namespace

TEST_CASE("align: two centres meet across the axis and keep their place along it") {
  CHECK(distance(first_end(0), {1, 2}) < 1e-14);
  CHECK(distance(first_end(kPi / 2), {3, 1}) < 1e-14);
  // Across the diagonal they are (4 - 2) / sqrt 2 apart: each goes half of it.
  CHECK(distance(first_end(kPi / 4), {1.5, 0.5}) < 1e-14);
}

TEST_CASE("align: the pinned one sets the line") {
  World w;
  AlignTerm c;
  c.a = w.add({1, 1}), c.b = w.add({5, 3});
  w.pin(c.a);
  CHECK(error(c, w.x) == -2);
  CHECK(distance(projected(c, w.x).position(c.b), {5, 1}) < 1e-15);
  w.pin(c.b);
  CHECK(change(w.x, projected(c, w.x)) == 0);
}

TEST_CASE("align: a list is held from neighbour to neighbour") {
  Scene scene = empty_room(9, 9);
  const Ref a = add(scene, "a", {1, 1, 1}, {1, 1}), b = add(scene, "b", {1, 1, 1}, {3, 2});
  const Ref d = add(scene, "d", {1, 1, 1}, {5, 4});
  Align align;
  align.members = list_of({a, b, d});
  scene.constraints.add(align);
  const Ready ready(scene);
  const auto& terms = ready.problem.of<AlignTerm>();
  REQUIRE(terms.size() == 2);
  CHECK(std::abs(error(terms[0], ready.x) + 1) < 1e-15);
  CHECK(std::abs(error(terms[1], ready.x) + 2) < 1e-15);
}
