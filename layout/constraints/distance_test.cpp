#include "layout/constraints/distance.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"
#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

DistanceTerm between(Anchor a, Anchor b, double low, double high) {
  DistanceTerm term;
  term.a = a, term.b = b, term.low = low, term.high = high;
  return term;
}

}  // namespace

TEST_CASE("distance: equal masses meet each other half way") {
  World w;
  const Anchor a = w.add({0, 0}), b = w.add({4, 0});
  const DistanceTerm c = between(a, b, 2, 2);
  CHECK(error(c, w.x) == 2);
  const State y = projected(c, w.x);
  CHECK(distance(y.position(a), {1, 0}) < 1e-15);
  CHECK(distance(y.position(b), {3, 0}) < 1e-15);
  CHECK(distance(projected(c, w.x, 0.5).position(a), {0.5, 0}) < 1e-15);
}

TEST_CASE("distance: the heavier one moves less by the ratio of the masses") {
  World w;
  const Anchor a = w.add({0, 0}, 0, 1), b = w.add({4, 0}, 0, 3);
  const State y = projected(between(a, b, 2, 2), w.x);
  CHECK(distance(y.position(a), {1.5, 0}) < 1e-15);
  CHECK(distance(y.position(b), {3.5, 0}) < 1e-15);
}

TEST_CASE("distance: a minimum and a maximum ask for nothing between them") {
  World w;
  const Anchor a = w.add({0, 0}), b = w.add({4, 0});
  CHECK(error(between(a, b, 3, 5), w.x) == 0);
  CHECK(change(w.x, projected(between(a, b, 3, 5), w.x)) == 0);
  CHECK(error(between(a, b, 5, 1e300), w.x) == -1);
  CHECK(distance(projected(between(a, b, 5, 1e300), w.x).position(b), {4.5, 0}) < 1e-15);
  CHECK(error(between(a, b, 0, 3), w.x) == 1);
  CHECK(distance(projected(between(a, b, 0, 3), w.x).position(b), {3.5, 0}) < 1e-15);
}

TEST_CASE("distance: a pinned focal object leaves the whole way to the member") {
  World w;
  const Anchor a = w.add({0, 0}), b = w.add({4, 0});
  DistanceTerm c = between(a, b, 1, 1);
  c.b_pinned = true;
  State y = projected(c, w.x);
  CHECK(y.position(b) == Vec2{4, 0});
  CHECK(distance(y.position(a), {3, 0}) < 1e-15);
  c.b_pinned = false;
  w.pin(a);
  y = projected(c, w.x);
  CHECK(y.position(a) == Vec2{0, 0});
  CHECK(distance(y.position(b), {1, 0}) < 1e-15);
  w.pin(b);
  CHECK(change(w.x, projected(c, w.x)) == 0);
}

TEST_CASE("distance: coincident centres part along a direction that is always the same") {
  World w;
  const Anchor a = w.add({3, 3}), b = w.add({3, 3});
  const DistanceTerm c = between(a, b, 1, 1);
  CHECK(error(c, w.x) == -1);
  const State y = projected(c, w.x);
  CHECK(std::abs(distance(y.position(a), y.position(b)) - 1) < 1e-14);
  CHECK(change(y, projected(c, w.x)) == 0);
  CHECK(change(w.x, projected(between(a, b, 0, 1), w.x)) == 0);
}

TEST_CASE("distance: a document's constraints become one term per pair") {
  Scene scene = empty_room(9, 9);
  const Ref a = add(scene, "a", {1, 1, 1}, {1, 1}), b = add(scene, "b", {1, 1, 1}, {4, 1});
  const Ref c = add(scene, "c", {1, 1, 1}, {1, 5});
  FocalDistance focal;
  focal.focal = a, focal.members = list_of({b, c}), focal.min = 2, focal.focal_fixed = true;
  scene.constraints.add(focal);
  Distance pair;
  pair.between = {b, c}, pair.max = 1, pair.stiffness = 0.25, pair.weight = 7;
  scene.constraints.add(pair);
  const Ready ready(scene);
  const auto& terms = ready.problem.of<DistanceTerm>();
  REQUIRE(terms.size() == 3);
  CHECK(terms[0].low == 0);
  CHECK(terms[0].high == 1);
  CHECK(ready.problem.gamma(terms[0]) == 7);
  CHECK(ready.problem.slots[terms[0].slot] == Slot{inhabit::pbd::Schedule::decreasing, 0.25, 7});
  CHECK(terms[1].low == 2);
  CHECK(terms[1].high == 1e300);
  CHECK(terms[1].b_pinned);
  CHECK(ready.problem.gamma(terms[2]) == 1);
  CHECK(std::abs(error(terms[0], ready.x) - 4) < 1e-15);
}
