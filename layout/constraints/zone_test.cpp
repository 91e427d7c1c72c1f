#include "layout/constraints/zone.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

Accessibility face_of(Ref object, Choice face, double depth = 0.6) {
  Accessibility c;
  c.object = object, c.face = face, c.depth = depth;
  return c;
}

/// A desk 2 m wide and 1 m deep at (5, 5) that looks along +y and cannot move, with one face kept free, and a box 1 m
/// square at `p`.
struct Desk {
  Ref desk, box;
  Scene scene = empty_room(10, 10);
  Desk(Choice face, Vec2 p) {
    desk = add(scene, "desk", {2, 1, 1}, {5, 5}), box = add(scene, "box", {1, 1, 1}, p);
    scene.objects[desk.index].fixed = true;
    scene.constraints.add(face_of(desk, face));
  }
  Vec2 end() const {
    Ready ready(scene);
    ready.project_zones();
    return ready.at(box);
  }
};

Vec2 end_of(const Scene& scene, Ref object) {
  Ready ready(scene);
  ready.project_zones();
  return ready.at(object);
}

}  // namespace

TEST_CASE("accessibility: the space lies in front of the face that is named") {
  // Faces 1 back, 2 left, 3 front, 4 right of something that looks along +y.
  const std::array<Vec2, 4> centers = {{{5, 4.2}, {3.7, 5}, {5, 5.8}, {6.3, 5}}};
  const std::array<Vec2, 4> half = {{{1, 0.3}, {0.3, 0.5}, {1, 0.3}, {0.3, 0.5}}};
  for (std::size_t face = 0; face < 4; ++face) {
    CAPTURE(face);
    const Desk desk(static_cast<Choice>(face), {1, 1});
    const Ready ready(desk.scene);
    REQUIRE(ready.problem.zones.size() == 1);
    const Box box = zone_box(ready.problem.zones[0], ready.x);
    CHECK(length(box.center - centers[face]) < 1e-14);
    CHECK(std::abs(box.extent({1, 0}) - half[face].x) < 1e-14);
    CHECK(std::abs(box.extent({0, 1}) - half[face].y) < 1e-14);
  }
}

TEST_CASE("accessibility: who stands in the space leaves it by the shortest way") {
  CHECK(length(Desk(2, {5, 6.4}).end() - Vec2{5, 6.6}) < 1e-14);
  CHECK(length(Desk(0, {5, 3.6}).end() - Vec2{5, 3.4}) < 1e-14);
  CHECK(length(Desk(1, {3, 5}).end() - Vec2{2.9, 5}) < 1e-14);
  CHECK(length(Desk(3, {7, 5}).end() - Vec2{7.1, 5}) < 1e-14);
  CHECK(Desk(2, {5, 6.7}).end() == Vec2{5, 6.7});
}

TEST_CASE("accessibility: owner and guest part by the ratio of their masses") {
  Desk desk(2, {5, 6.4});
  desk.scene.objects[desk.desk.index].fixed = false;
  Ready ready(desk.scene);
  ready.project_zones();
  CHECK(length(ready.at(desk.box) - Vec2{5, 6.5}) < 1e-14);
  CHECK(length(ready.at(desk.desk) - Vec2{5, 4.9}) < 1e-14);
}

TEST_CASE("accessibility: the papers' spheres push to the sum of the half diagonals") {
  const Desk desk(2, {5, 6.4});
  Ready ready(desk.scene);
  ready.project_zones(true);
  const double reach = std::sqrt(0.5) + std::hypot(1, 0.3);
  CHECK(length(ready.at(desk.box) - Vec2{5, 5.8 + reach}) < 1e-14);
}

TEST_CASE("accessibility: it concerns its members only and never what is bound to the owner") {
  Desk desk(2, {5, 6.4});
  const Ref other = add(desk.scene, "other", {1, 1, 1}, {9, 9});
  Accessibility narrow = face_of(desk.desk, 2);
  narrow.members = list_of({other});
  desk.scene.constraints = {};
  desk.scene.constraints.add(narrow);
  CHECK(desk.end() == Vec2{5, 6.4});
  desk.scene.constraints.add(face_of(desk.desk, 2));
  CHECK(desk.end() != Vec2{5, 6.4});
  Orientation looks;
  looks.members = list_of({desk.box}), looks.to = desk.desk;
  desk.scene.constraints.add(looks);
  CHECK(desk.end() == Vec2{5, 6.4});
}

TEST_CASE("accessibility: what hangs above the owner's top is not in its way") {
  Desk desk(2, {5, 6.4});
  desk.scene.objects[desk.box.index].position->z = 1.5;
  CHECK(desk.end() == Vec2{5, 6.4});
}

TEST_CASE("accessibility: an object's clearance asks for the same without a constraint") {
  Desk desk(2, {5, 6.4});
  desk.scene.constraints = {};
  CHECK(desk.end() == Vec2{5, 6.4});
  desk.scene.objects[desk.desk.index].clearance.front = 0.6;
  CHECK(length(desk.end() - Vec2{5, 6.6}) < 1e-14);
}

TEST_CASE("door: its leaf and the way to it stay free") {
  for (const auto& [swing, y] : {std::pair{Door::Swing::in, 1.5}, std::pair{Door::Swing::out, 1.1}}) {
    Scene scene = empty_room(9, 9);
    add_door(scene, 0, 4, 1, swing);
    const Ref box = add(scene, "box", {1, 1, 1}, {4.5, 0.9});
    CHECK(length(end_of(scene, box) - Vec2{4.5, y}) < 1e-14);
    scene.objects[0].fixed = true;
    CHECK(end_of(scene, box) == Vec2{4.5, 0.9});
  }
}

TEST_CASE("keep-out: a box leaves a convex zone by the shortest way") {
  Scene scene = empty_room(9, 9);
  const Ref box = add(scene, "box", {1, 1, 1}, {5.4, 4.5}), free = add(scene, "free", {1, 1, 1}, {4.5, 4.5});
  KeepOut c;
  c.members = list_of({box}), c.polygon = {{4, 4}, {4, 5}, {5, 5}, {5, 4}};
  scene.constraints.add(c);
  CHECK(length(end_of(scene, box) - Vec2{5.5, 4.5}) < 1e-14);
  CHECK(end_of(scene, free) == Vec2{4.5, 4.5});
}

TEST_CASE("keep-out: a zone that is not convex is left from nearly everywhere") {
  Scene scene = empty_room(12, 12);
  const Ref box = add(scene, "box", {1, 0.5, 1}, {6, 6});
  KeepOut c;
  c.polygon = {{4, 4}, {8, 4}, {8, 6}, {6, 6}, {6, 8}, {4, 8}};
  scene.constraints.add(c);
  Rng rng(7);
  int stuck = 0;
  for (int n = 0; n < 300; ++n) {
    Ready ready(scene);
    ready.x.place(0, {rng.uniform(3, 9), rng.uniform(3, 9)}, rng.uniform(-kPi, kPi));
    for (int i = 0; i < 100; ++i) ready.project_zones();
    double left = 0;
    for (const Ring& part : convex_parts(c.polygon)) left = std::max(left, separation(ready.box(box), part).depth);
    stuck += left > 1e-6;
  }
  // Its convex parts may push a box to and fro across the side that they share; a relocation ends that.
  CHECK(stuck <= 30);
  // In the notch nothing is in the way.
  Ready ready(scene);
  ready.x.place(0, {7.2, 7.2}, 0.3);
  ready.project_zones();
  CHECK(ready.at(box) == Vec2{7.2, 7.2});
}

TEST_CASE("pathway: the corridor between two doors stays free") {
  Scene scene = empty_room(10, 10);
  const Ref a = add_door(scene, 0, 4.5, 1), b = add_door(scene, 2, 4.5, 1);
  const Ref box = add(scene, "box", {1, 1, 1}, {5.7, 5}), far = add(scene, "far", {1, 1, 1}, {6, 7});
  Pathway c;
  c.between = {a, b}, c.width = 0.8;
  scene.constraints.add(c);
  CHECK(length(end_of(scene, box) - Vec2{5.9, 5}) < 1e-14);
  CHECK(end_of(scene, far) == Vec2{6, 7});
}

TEST_CASE("visibility: the view stays free as wide as it is in its middle") {
  Scene scene = empty_room(10, 10);
  const Ref tv = add(scene, "tv", {1, 0.4, 1}, {5, 1}), box = add(scene, "box", {1, 1, 1}, {6.4, 2.2});
  scene.objects[tv.index].fixed = true;
  scene.objects[tv.index].view = View{2, kPi / 2};
  Visibility c;
  c.members = list_of({tv});
  scene.constraints.add(c);
  // From y = 1.2 to 3.2 and 1 m to either side.
  CHECK(length(end_of(scene, box) - Vec2{6.5, 2.2}) < 1e-13);
  scene.objects[tv.index].view.reset();
  CHECK(end_of(scene, box) == Vec2{6.4, 2.2});
}
