#include "layout/check.h"

#include <doctest/doctest.h>

#include <chrono>

#include "core/rng.h"
#include "core/text.h"
#include "layout/furnish.h"

using namespace inhabit::layout;

namespace {

/// An empty room of w x h metres without doors.
Scene room(double w, double h) {
  Scene scene;
  scene.space.outline = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  return scene;
}

/// Adds a box; returns a reference to it.
Ref add(Scene& scene, std::string id, Vec3 size, Vec3 position, double angle = 90) {
  Object object;
  object.id = std::move(id);
  object.size = size;
  object.position = position;
  object.angle = radians(angle);
  scene.objects.push_back(object);
  return {Ref::Kind::object, static_cast<std::uint32_t>(scene.objects.size() - 1)};
}

Door door(int wall, double from, double width) {
  Door d;
  d.id = "door";
  d.wall = wall;
  d.from = from;
  d.width = width;
  return d;
}

}  // namespace

TEST_CASE("overlap depth is the smallest way to part two boxes whose heights overlap") {
  Scene scene = room(6, 6);
  add(scene, "a", {1, 1, 1}, {2, 2, 0});
  add(scene, "b", {1, 1, 1}, {2.9, 2.2, 0});
  add(scene, "shelf", {1, 1, 0.5}, {2, 2, 1});
  const CheckReport r = check(scene);
  REQUIRE(r.overlaps.size() == 1);
  CHECK(r.overlaps[0].a == "a");
  CHECK(r.overlaps[0].b == "b");
  CHECK(r.overlaps[0].depth == doctest::Approx(0.1));
  CHECK_FALSE(r.feasible);
  CHECK(r.outside.empty());
}

TEST_CASE("half a millimetre is no overlap and not outside") {
  Scene scene = room(4, 4);
  add(scene, "a", {1, 1, 1}, {0.4995, 2, 0});
  add(scene, "b", {1, 1, 1}, {1.499, 2, 0});
  CHECK(check(scene).feasible);
  scene.objects[1].position->x = 1.49;
  CHECK_FALSE(check(scene).feasible);
}

TEST_CASE("what stands on something does not overlap with it - through others and groups too") {
  Scene scene = room(4, 4);
  const Ref table = add(scene, "table", {1, 1, 0.7}, {2, 2, 0});
  const Ref tray = add(scene, "tray", {0.6, 0.6, 0.2}, {2, 2, 0.6});
  const Ref cup = add(scene, "cup", {0.1, 0.1, 0.2}, {2, 2, 0.55});
  CHECK(check(scene).overlap_count == 3);
  scene.objects[tray.index].on = table;
  CHECK(check(scene).overlap_count == 2);
  scene.groups.push_back({"set", {tray}});
  Stacking stacking;
  stacking.object = cup, stacking.on = {Ref::Kind::group, 0};
  scene.constraints.add(stacking);
  CHECK(check(scene).feasible);
}

TEST_CASE("a collision constraint that is off excuses its members and is counted both ways") {
  Scene scene = room(8, 4);
  const Ref a = add(scene, "a", {1, 1, 1}, {2, 2, 0}), b = add(scene, "b", {1, 1, 1}, {2.5, 2, 0});
  add(scene, "c", {1, 1, 1}, {3, 2, 0});
  Collision off;
  off.mode = 2;
  off.members.list = {a, b};
  scene.constraints.add(off);
  CheckReport r = check(scene);
  CHECK(r.overlap_count == 1);  // b and c; a and c touch
  CHECK(r.exempt_pairs == 1);
  CHECK(r.overlaps_exempt == 1);
  r = check(scene, {.all_collisions = true});
  CHECK(r.overlap_count == 2);
  CHECK(r.overlaps_exempt == 1);
  off.members = {};
  scene.constraints.add(off);
  r = check(scene);
  CHECK(r.feasible);
  CHECK(r.exempt_pairs == 3);
  CHECK(r.overlaps_exempt == 2);
}

TEST_CASE("overlaps inside a rigid group are the scene's own and are counted apart") {
  Scene scene = room(8, 4);
  const Ref a = add(scene, "table", {1, 1, 1}, {2, 2, 0}), b = add(scene, "chair", {1, 1, 1}, {2.5, 2, 0});
  Group group;
  group.id = "set", group.members = {a, b}, group.rigid = true;
  scene.groups.push_back(group);
  CHECK(check(scene).feasible);
  CHECK(check(scene).overlaps_rigid == 1);
  CHECK(check(scene, {.all_collisions = true}).overlaps.size() == 1);
  scene.groups[0].rigid = false;
  CHECK_FALSE(check(scene).feasible);
}

TEST_CASE("constraints are summed up by kind and the violated ones put into words") {
  Scene scene = room(8, 8);
  const Ref a = add(scene, "lamp", {0.5, 0.5, 1}, {1, 1, 0}, 0);
  const Ref b = add(scene, "chair", {0.5, 0.5, 1}, {3, 1, 0}, 30);
  const Ref c = add(scene, "plant", {0.5, 0.5, 1}, {5.02, 1, 0}, 0);
  for (const auto& [from, to, d] : {std::tuple{a, b, 1.69}, {b, c, 2.0}, {a, c, 4.52}}) {
    Distance distance;
    distance.between = {from, to}, distance.distance = d;
    scene.constraints.add(distance);
  }
  Orientation turn;
  turn.members.list = {b}, turn.to = c;
  scene.constraints.add(turn);
  const CheckReport r = check(scene);
  REQUIRE(r.constraints.size() == 2);
  CHECK(r.constraints[0].type == "distance");
  CHECK(r.constraints[0].count == 3);
  CHECK(r.constraints[0].median == doctest::Approx(0.31));
  CHECK(r.constraints[0].max == doctest::Approx(0.5));
  CHECK(r.constraints[0].p95 == doctest::Approx(0.5));
  CHECK(r.constraints[1].unit == "deg");
  CHECK(r.constraints[1].max == doctest::Approx(30));
  REQUIRE(r.violations.size() == 3);
  CHECK(r.violations[0].text == "distance lamp – plant: 0.50 m too close");
  CHECK(r.violations[1].text == "distance lamp – chair: 0.31 m too far");
  CHECK(r.violations[2].text == "orientation chair – plant: 30.0° turned away");
  CHECK(r.energy > 0.3);
}

TEST_CASE("what furnish calls feasible has no overlap deeper than 1 mm here") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Scene scene = room(4, 3);
    scene.space.outline = {{0, 0}, {4, 0}, {4, 2}, {2.5, 2}, {2.5, 3}, {0, 3}};
    for (const double size : {0.5, 0.7, 0.9, 1.1}) {
      add(scene, shortest(size), {size, 0.6, 1}, {});
      scene.objects.back().position.reset();
    }
    const auto outcome = furnish(scene, {.seed = seed, .starts = 1, .threads = 1});
    REQUIRE(outcome.ok());
    const CheckReport r = check(with_placement(scene, outcome->best.placement));
    if (outcome->best.feasible) CHECK(r.overlaps.empty());
    // A corner 1 mm beyond two walls at once is sqrt(2) mm outside: only that may part the two verdicts.
    if (outcome->best.feasible) CHECK((r.outside.empty() || r.outside[0].depth < 1.5e-3));
  }
}

TEST_CASE("an object without a position is missing and the room is not feasible") {
  Scene scene = room(4, 4);
  add(scene, "a", {1, 1, 1}, {2, 2, 0});
  scene.objects[0].position.reset();
  const CheckReport r = check(scene);
  CHECK_FALSE(r.feasible);
  CHECK(r.missing == 1);
  REQUIRE(r.outside.size() == 1);
  CHECK(std::isinf(r.outside[0].depth));
}

TEST_CASE("a pillar inside a bed is outside of the room") {
  Scene scene = room(6, 6);
  scene.space.holes.push_back({"pillar", {{2.9, 2.9}, {3.1, 2.9}, {3.1, 3.1}, {2.9, 3.1}}, {}});
  add(scene, "bed", {2, 2, 0.5}, {3, 3, 0});
  const CheckReport r = check(scene);
  REQUIRE(r.outside.size() == 1);
  CHECK(r.outside[0].depth == doctest::Approx(0.9));
}

TEST_CASE("a door needs its swing and the depth of a person") {
  Scene scene = room(4, 4);
  scene.space.doors.push_back(door(0, 1, 1));
  CHECK(check(scene).blocked_doors.empty());
  // Everything from 0.5 m on: the quarter disc and the rectangle less their first half metre.
  add(scene, "box", {1, 1, 1}, {1.5, 1, 0});
  const double quarter = kPi / 4, c = std::acos(0.6);
  // The rectangle adds the corner of the first 0.6 m that lies beyond the disc.
  const double beyond = 0.6 - (0.6 * 0.8 / 2 + (kPi / 2 - c) / 2);
  const double all = quarter + beyond;
  const CheckReport r = check(scene);
  REQUIRE(r.blocked_doors.size() == 1);
  CHECK(r.blocked_doors[0].share == doctest::Approx((all - 0.5) / all).epsilon(0.02));
  scene.space.doors[0].swing = Door::Swing::out;
  CHECK(check(scene).blocked_doors[0].share == doctest::Approx(1.0 / 6).epsilon(0.05));
  scene.objects[0].position->z = 2.2;
  CHECK(check(scene).blocked_doors.empty());
}

TEST_CASE("a clearance is blocked by others and by walls but not by what belongs to the object") {
  Scene scene = room(6, 6);
  const Ref desk = add(scene, "desk", {1, 1, 0.7}, {3, 3, 0});
  scene.objects[desk.index].clearance = {.front = 1};
  CHECK(check(scene).clearances.empty());
  const Ref chair = add(scene, "chair", {0.5, 0.5, 0.8}, {3, 4, 0});
  CheckReport r = check(scene);
  REQUIRE(r.clearances.size() == 1);
  CHECK(r.clearances[0].face == "front");
  CHECK(r.clearances[0].blocked_share == doctest::Approx(0.25).epsilon(0.1));
  Distance near;
  near.between = {chair, desk};
  scene.constraints.add(near);
  CHECK(check(scene).clearances.empty());
  scene.objects[desk.index].position = Vec3{3, 5, 0};
  scene.objects[chair.index].position = Vec3{1, 1, 0};
  r = check(scene);
  REQUIRE(r.clearances.size() == 1);
  CHECK(r.clearances[0].blocked_share == doctest::Approx(0.5));
}

TEST_CASE("members of one rigid group and flat rugs do not block a clearance") {
  Scene scene = room(6, 6);
  const Ref desk = add(scene, "desk", {1, 1, 0.7}, {3, 3, 0});
  const Ref chair = add(scene, "chair", {0.5, 0.5, 0.8}, {3, 4, 0});
  scene.objects[desk.index].clearance = {.front = 1};
  scene.groups.push_back({"g", {desk, chair}, true});
  add(scene, "rug", {1, 1, 0.01}, {3, 4, 0});
  CHECK(check(scene).clearances.empty());
  scene.groups[0].rigid = false;
  CHECK(check(scene).clearances.size() == 1);
}

TEST_CASE("a view is blocked by what stands in its cone at its height") {
  Scene scene = room(6, 6);
  const Ref tv = add(scene, "tv", {1, 0.2, 0.6}, {3, 0.1, 0.5});
  scene.objects[tv.index].view = View{2, radians(90)};
  add(scene, "low", {4, 0.5, 0.4}, {3, 1.5, 0});
  CHECK(check(scene).views.empty());
  add(scene, "wall unit", {6, 4, 2}, {3, 3.2, 0});
  const CheckReport r = check(scene);
  REQUIRE(r.views.size() == 1);
  // The sector of radius 2 and 90 degrees without the triangle of height 1.
  CHECK(r.views[0].blocked_share == doctest::Approx((kPi - 1) / kPi).epsilon(0.02));
}

TEST_CASE("an empty room is walkable up to a person's radius from its walls") {
  Scene scene = room(5, 4);
  scene.space.doors.push_back(door(0, 1, 0.9));
  const CheckReport r = check(scene);
  CHECK(r.walkable_share == doctest::Approx(4.5 * 3.5 / 20).epsilon(0.01));
  CHECK(r.reachable.share == 1);
  CHECK(r.feasible);
}

TEST_CASE("a gap narrower than a person cuts the room and a wider one does not") {
  for (const double gap : {0.48, 0.56}) {
    Scene scene = room(8, 4);
    scene.space.doors.push_back(door(0, 1, 0.9));
    add(scene, "wall", {0.2, 4 - gap, 1}, {4, (4 - gap) / 2, 0});
    add(scene, "plant", {0.4, 0.4, 1}, {7, 2, 0});
    const CheckReport r = check(scene);
    if (gap < 0.5) {
      CHECK(r.reachable.share < 0.6);
      REQUIRE(r.reachable.unreachable.size() == 1);
      CHECK(r.reachable.unreachable[0] == "plant");
    } else {
      CHECK(r.reachable.share == 1);
      CHECK(r.reachable.unreachable.empty());
    }
  }
}

TEST_CASE("without doors people start in the largest part and with a blocked door nowhere") {
  Scene scene = room(9, 4);
  add(scene, "wall", {0.2, 4, 1}, {3, 2, 0});
  CHECK(check(scene).reachable.share == doctest::Approx((5.9 - 0.5) / (5.9 + 2.9 - 1)).epsilon(0.01));
  scene.space.doors.push_back(door(0, 1, 0.9));
  CHECK(check(scene).reachable.share == doctest::Approx((2.9 - 0.5) / (5.9 + 2.9 - 1)).epsilon(0.01));
  add(scene, "sofa", {2, 0.9, 0.8}, {1.45, 0.46, 0});
  CHECK(check(scene).reachable.share == 0);
}

TEST_CASE("a turned room is as walkable as a straight one") {
  Scene scene;
  const Vec2 turn = direction(0.4);
  for (const Vec2 p : {Vec2{0, 0}, Vec2{5, 0}, Vec2{5, 4}, Vec2{0, 4}}) scene.space.outline.push_back(rotate(p, turn));
  scene.space.doors.push_back(door(2, 0.1, 0.55));
  const CheckReport r = check(scene);
  CHECK(r.walkable_share == doctest::Approx(4.5 * 3.5 / 20).epsilon(0.01));
  CHECK(r.reachable.share == 1);
}

TEST_CASE("a hundred thousand seats are checked in seconds and any number of threads agree") {
  Scene scene = room(300, 300);
  scene.space.doors.push_back(door(0, 100, 4));
  inhabit::core::Rng rng(3);
  for (int i = 0; i < 100000; ++i) {
    const int column = i % 316, row = i / 316;
    add(scene, std::to_string(i), {0.5, 0.5, 0.9}, {1 + column * 0.94 + rng.uniform(0, 0.1), 1 + row * 0.94, 0});
    scene.objects.back().clearance.front = 0.3;
  }
  const auto start = std::chrono::steady_clock::now();
  const CheckReport one = check(scene, {.threads = 1});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  MESSAGE("100,000 seats: ", seconds, " s");
  CHECK(seconds < 60);  // several times what it takes on a busy machine
  const CheckReport two = check(scene, {.threads = 2});
  CHECK(one.overlap_count == two.overlap_count);
  CHECK(one.feasible);
  CHECK(one.clearances.size() == two.clearances.size());
  CHECK(one.reachable.share == two.reachable.share);
}

TEST_CASE("what cannot move is taken as given: it is neither outside nor overlaps what cannot move either") {
  Scene scene = room(4, 4);
  const Ref stairs = add(scene, "stairs", {1, 2, 2.5}, {4, 2, 0});
  const Ref unit = add(scene, "unit", {1, 1, 1}, {3.5, 2, 0});
  CHECK(check(scene).outside.size() == 1);
  scene.objects[stairs.index].fixed = true;
  CheckReport r = check(scene);
  CHECK(r.outside.empty());
  CHECK(r.outside_pinned == 1);
  CHECK(r.overlap_count == 1);
  scene.objects[unit.index].lock = Lock::both;
  r = check(scene);
  CHECK(r.feasible);
  CHECK(r.overlaps_pinned == 1);
  CHECK(check(scene, {.all_collisions = true}).overlap_count == 1);
  // Grouped rigidly with what is fixed is as good as fixed.
  scene.objects[unit.index].lock = Lock::none;
  scene.groups.push_back({"kitchen", {stairs, unit}, true});
  add(scene, "bin", {0.3, 0.3, 0.5}, {0, 0.5, 0});
  r = check(scene);
  REQUIRE(r.outside.size() == 1);
  CHECK(r.outside[0].id == "bin");
}
