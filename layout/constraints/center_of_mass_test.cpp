#include "layout/constraints/center_of_mass.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"
#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

CenterTerm center(CenterTerm::Target target, const std::vector<Anchor>& members, const std::vector<double>& masses) {
  CenterTerm c;
  c.target = target, c.members = members, c.masses = masses;
  for (const double m : masses) c.mass += m;
  return c;
}

}  // namespace

TEST_CASE("heat point: unequal masses move alike until their centre is there") {
  World w;
  const Anchor a = w.add({0, 0}, 0, 1), b = w.add({4, 0}, 0, 3);
  CenterTerm c = center(CenterTerm::Target::point, {a, b}, {1, 3});
  c.point = {3, 1};
  CHECK(center_of_mass(c, w.x) == Vec2{3, 0});
  CHECK(error(c, w.x) == 1);
  const State y = projected(c, w.x);
  CHECK(distance(y.position(a), {0, 1}) < 1e-15);
  CHECK(distance(y.position(b), {4, 1}) < 1e-15);
  CHECK(distance(projected(c, w.x, 0.25).position(b), {4, 0.25}) < 1e-15);
}

TEST_CASE("heat point: members that are pinned leave their part to the others - at most four times their own") {
  World w;
  const Anchor a = w.add({0, 0}, 0, 1), b = w.add({4, 0}, 0, 3);
  CenterTerm c = center(CenterTerm::Target::point, {a, b}, {1, 3});
  c.point = {3, 1};
  w.pin(b);
  State y = projected(c, w.x);
  CHECK(distance(y.position(a), {0, 4}) < 1e-14);
  CHECK(error(c, y) < 1e-14);
  c.masses = {1, 9}, c.mass = 10, c.point = center_of_mass(c, w.x) + Vec2{0, 1};
  y = projected(c, w.x);
  CHECK(distance(y.position(a), {0, 4}) < 1e-14);
  CHECK(std::abs(error(c, y) - 0.6) < 1e-14);
  w.pin(a);
  CHECK(change(w.x, projected(c, w.x)) == 0);
}

TEST_CASE("heat point: on a parent the point is in its frame and moves with it") {
  World w;
  const Anchor parent = w.add({5, 5}, kPi / 2), a = w.add({5, 5});
  CenterTerm c = center(CenterTerm::Target::point, {a}, {1});
  c.point = {1, 0.5}, c.on = parent;
  CHECK(distance(projected(c, w.x).position(a), {4.5, 6}) < 1e-14);
  w.x.shift(parent, {1, 1});
  const State y = projected(c, w.x);
  CHECK(distance(y.position(a), {5.5, 7}) < 1e-14);
  CHECK(y.position(parent) == Vec2{6, 6});
}

TEST_CASE("heat point: a centre that is there and no members at all ask for nothing") {
  World w;
  const Anchor a = w.add({1, 1}), b = w.add({3, 3});
  CenterTerm c = center(CenterTerm::Target::point, {a, b}, {1, 1});
  c.point = {2, 2};
  CHECK(error(c, w.x) == 0);
  CHECK(change(w.x, projected(c, w.x)) == 0);
  CenterTerm none = center(CenterTerm::Target::point, {}, {});
  none.point = {2, 2};
  CHECK(change(w.x, projected(none, w.x)) == 0);
}

TEST_CASE("focal symmetry: the members' centre moves onto the front ray") {
  World w;
  const Anchor focal = w.add({0, 5}, 0, 2), a = w.add({2, 6}), b = w.add({4, 6});
  CenterTerm c = center(CenterTerm::Target::front_ray, {a, b}, {1, 1});
  c.on = focal;
  CHECK(error(c, w.x) == 1);
  const State y = projected(c, w.x);
  CHECK(distance(y.position(a), {2, 5}) < 1e-15);
  CHECK(distance(y.position(b), {4, 5}) < 1e-15);
  CHECK(y.position(focal) == Vec2{0, 5});
  c.on_fixed = false;
  const State z = projected(c, w.x);
  CHECK(distance(z.position(a), {2, 5.5}) < 1e-15);
  CHECK(distance(z.position(focal), {0, 5.5}) < 1e-15);
  CHECK(error(c, z) < 1e-15);
}

TEST_CASE("focal symmetry: behind the focal object the ray's nearest point is its start") {
  World w;
  const Anchor focal = w.add({5, 5}, kPi / 2), a = w.add({6, 2});
  CenterTerm c = center(CenterTerm::Target::front_ray, {a}, {1});
  c.on = focal;
  CHECK(std::abs(error(c, w.x) - std::sqrt(10)) < 1e-14);
  CHECK(distance(projected(c, w.x).position(a), {5, 5}) < 1e-14);
}

TEST_CASE("visual balance: an L-shaped room has its centre where its area has it") {
  World w(l_shape());
  CHECK(distance(w.room().center(), {5.0 / 3, 5.0 / 3}) < 1e-14);
  CHECK(std::abs(w.room().area() - 12) < 1e-12);
  const Anchor a = w.add({1, 1}), b = w.add({3, 1});
  const CenterTerm c = center(CenterTerm::Target::room, {a, b}, {1, 1});
  CHECK(distance(projected(c, w.x).position(a), {2.0 / 3, 5.0 / 3}) < 1e-14);
  const World hole(rectangle(4, 4), {{{2, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {2, 3.5}}});
  // 16 m2 at (2, 2) less 4.5 m2 at (2.75, 2).
  CHECK(distance(hole.room().center(), {(32 - 4.5 * 2.75) / 11.5, 2}) < 1e-14);
}

TEST_CASE("visual balance: footprints weigh and the absence of members means everything") {
  Scene scene = empty_room(8, 4);
  add(scene, "a", {1, 1, 5}, {1, 1}), add(scene, "b", {2, 1, 1}, {4, 1});
  scene.constraints.add(VisualBalance{});
  const Ready ready(scene);
  const auto& terms = ready.problem.of<CenterTerm>();
  REQUIRE(terms.size() == 1);
  CHECK(terms[0].masses == std::vector<double>{1, 2});
  CHECK(distance(center_of_mass(terms[0], ready.x), {3, 1}) < 1e-15);
  CHECK(std::abs(error(terms[0], ready.x) - std::sqrt(2)) < 1e-15);
}
