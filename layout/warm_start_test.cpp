#include <doctest/doctest.h>

#include "layout/check.h"
#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

/// What is given, pinned or grouped keeps what it was given.
namespace {

Options one(std::uint64_t seed = 1) {
  Options o;
  o.seed = seed, o.starts = 3, o.threads = 1;
  return o;
}

Layout solved(const Scene& scene, const Options& options = one()) {
  const auto outcome = furnish(scene, options);
  REQUIRE(outcome.ok());
  return outcome->best;
}

/// A living room that is right as it stands: sofa and television at opposite walls, a table between, two plants.
Scene good_room() {
  Scene scene = empty_room(5, 4);
  const Ref sofa = add(scene, "sofa", {2, 0.9, 0.8}, {2.5, 0.45}),
            tv = add(scene, "tv", {1.2, 0.4, 0.5}, {2.5, 3.8}, -90);
  const Ref table = add(scene, "table", {1, 0.6, 0.4}, {2.5, 1.7});
  add(scene, "plant-1", {0.4, 0.4, 1}, {0.3, 0.3}), add(scene, "plant-2", {0.4, 0.4, 1}, {4.7, 3.7});
  WallDistance wall;
  wall.members = list_of({sofa, tv});
  scene.constraints.add(wall);
  Distance d;
  d.between = {table, sofa}, d.distance = 1.25;
  scene.constraints.add(d);
  Orientation looks;
  looks.members = list_of({sofa}), looks.to = tv;
  scene.constraints.add(looks);
  return scene;
}

double moved(const Scene& scene, const Placement& p, std::size_t i) {
  return length(p.objects[i].position.xy() - scene.objects[i].position->xy());
}

}  // namespace

TEST_CASE("warm start: a layout that is good stays where it is") {
  const Scene scene = good_room();
  const Layout l = solved(scene);
  CHECK(l.feasible);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    CHECK(moved(scene, l.placement, i) < 0.01);
    CHECK(std::abs(wrap_angle(l.placement.objects[i].angle - *scene.objects[i].angle)) < 0.01);
  }
}

TEST_CASE("warm start: what a solver found it does not rearrange") {
  Scene scene = good_room();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Layout first = solved(without_positions(scene), one(seed));
    REQUIRE(first.feasible);
    const Scene again = with_placement(scene, first.placement);
    const Layout second = solved(again);
    CHECK(second.feasible);
    CHECK(second.energy <= first.energy + 1e-9);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      CAPTURE(scene.objects[i].id);
      CHECK(moved(again, second.placement, i) < 0.05);
    }
  }
}

TEST_CASE("warm start: a dragged object stays where it was dropped and only its neighbours yield") {
  Scene scene = good_room();
  // The table is pushed half into the plant at the left.
  scene.objects[2].position = Vec3{0.9, 0.5, 0};
  scene.objects[0].position = Vec3{3.5, 0.45, 0};
  scene.objects[2].lock = Lock::position;
  scene.constraints = {};
  const Layout l = solved(scene);
  CHECK(l.feasible);
  CHECK(moved(scene, l.placement, 2) == 0);
  CHECK(moved(scene, l.placement, 3) > 0.05);
  CHECK(moved(scene, l.placement, 3) < 1);
  for (const std::size_t still : {0u, 1u, 4u}) CHECK(moved(scene, l.placement, still) < 0.01);
}

TEST_CASE("pinned: fixed objects and every lock keep what they hold") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    Scene scene = empty_room(5, 5);
    const Ref fixed = add(scene, "fixed", {1, 1, 1}, {1, 1}, 17), place = add(scene, "place", {1, 0.5, 1}, {4, 1}, 33);
    const Ref angle = add(scene, "angle", {1, 0.5, 1}, {1, 4}, 51), both = add(scene, "both", {1, 1, 1}, {4, 4}, 77);
    const Ref free = add(scene, "free", {1, 1, 1}, {2.5, 2.5}, 5);
    scene.objects[fixed.index].fixed = true;
    scene.objects[place.index].lock = Lock::position;
    scene.objects[angle.index].lock = Lock::angle;
    scene.objects[both.index].lock = Lock::both;
    HeatPoint pull;
    pull.members = list_of({fixed, place, angle, both, free}), pull.point = {2.5, 3};
    scene.constraints.add(pull);
    Orientation looks;
    looks.members = list_of({fixed, place, angle, both}), looks.to = free;
    scene.constraints.add(looks);
    WallDistance wall;
    wall.members = pull.members;
    scene.constraints.add(wall);
    for (const Start start : {Start::given, Start::random, Start::placed}) {
      for (const Scheme scheme : {Scheme::gauss_seidel, Scheme::averaged}) {
        Options options = one(seed);
        options.start = start, options.scheme = scheme, options.starts = 1, options.max_iterations = 100;
        const Placement p = solved(scene, options).placement;
        for (const Ref r : {fixed, place, both}) {
          CHECK(p.objects[r.index].position.xy() == scene.objects[r.index].position->xy());
        }
        for (const Ref r : {fixed, angle, both}) {
          CHECK(std::abs(wrap_angle(p.objects[r.index].angle - *scene.objects[r.index].angle)) < 1e-15);
        }
      }
    }
  }
}

TEST_CASE("pinned: without positions keeps what is pinned and a fixed object without a place is an error") {
  Scene scene = good_room();
  scene.objects[0].fixed = true, scene.objects[1].lock = Lock::angle, scene.objects[2].lock = Lock::position;
  const Scene bare = without_positions(scene);
  CHECK((bare.objects[0].position && bare.objects[0].angle));
  CHECK((!bare.objects[1].position && bare.objects[1].angle));
  CHECK((bare.objects[2].position && !bare.objects[2].angle));
  CHECK((!bare.objects[3].position && !bare.objects[3].angle));
  scene.objects[0].position.reset();
  CHECK_FALSE(furnish(scene, one()).ok());
}

TEST_CASE("rigid groups keep their shape to the nanometre and nested ones move as one") {
  Scene scene = empty_room(7, 7);
  const Ref table = add(scene, "table", {1, 1, 0.7}, {10, 10}, 0), c1 = add(scene, "c1", {0.4, 0.4, 0.9}, {9, 10}, 0);
  const Ref c2 = add(scene, "c2", {0.4, 0.4, 0.9}, {11, 10}, 180),
            lamp = add(scene, "lamp", {0.3, 0.3, 2}, {10, 11.5}, 30);
  const Ref inner = add_group(scene, "inner", {c1, c2}), outer = add_group(scene, "outer", {table, inner, lamp}, true);
  add(scene, "crate", {2, 2, 1});
  WallDistance wall;
  wall.members = list_of({outer});
  scene.constraints.add(wall);
  const std::array<Ref, 4> list = {table, c1, c2, lamp};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const Scheme scheme : {Scheme::gauss_seidel, Scheme::averaged}) {
      Options options = one(seed);
      options.scheme = scheme;
      const Layout l = solved(scene, options);
      CHECK(l.feasible);
      const auto& o = l.placement.objects;
      const double turn = wrap_angle(o[0].angle - *scene.objects[0].angle);
      for (const Ref r : list) {
        const Vec2 want =
            rotate(scene.objects[r.index].position->xy() - scene.objects[0].position->xy(), direction(turn));
        CHECK(length(o[r.index].position.xy() - o[0].position.xy() - want) < 1e-9);
        CHECK(std::abs(wrap_angle(o[r.index].angle - *scene.objects[r.index].angle - turn)) < 1e-9);
      }
      // The group's own pose carries its members when the layout is written back.
      const Scene placed = with_placement(scene, l.placement);
      CHECK(check(placed).feasible);
    }
  }
}

TEST_CASE("a rigid group with a pinned member does not move and one without a shape is an error") {
  Scene scene = empty_room(7, 7);
  const Ref a = add(scene, "a", {1, 1, 1}, {2, 2}), b = add(scene, "b", {1, 1, 1}, {3, 2});
  add_group(scene, "pair", {a, b}, true);
  scene.objects[a.index].lock = Lock::position;
  HeatPoint pull;
  pull.members = list_of({a, b}), pull.point = {5, 5};
  scene.constraints.add(pull);
  const Layout l = solved(scene);
  CHECK(moved(scene, l.placement, 0) < 1e-12);
  CHECK(moved(scene, l.placement, 1) < 1e-12);
  scene.objects[b.index].position.reset();
  CHECK_FALSE(furnish(scene, one()).ok());
}

TEST_CASE("a group that is not rigid is moved as one by constraints on it") {
  Scene scene = empty_room(12, 12);
  const Ref a = add(scene, "a", {0.5, 0.5, 1}, {2, 2}), b = add(scene, "b", {0.5, 0.5, 1}, {3, 2});
  const Ref c = add(scene, "c", {0.5, 0.5, 1}, {2.5, 3}), stage = add(scene, "stage", {1, 1, 1}, {9, 9});
  const Ref inner = add_group(scene, "inner", {b, c}), outer = add_group(scene, "outer", {a, inner});
  scene.objects[stage.index].fixed = true;
  Distance d;
  d.between = {outer, stage}, d.distance = 4, d.stiffness = 1;
  scene.constraints.add(d);
  const Layout l = solved(scene);
  const auto& o = l.placement.objects;
  const Vec2 step = o[0].position.xy() - scene.objects[0].position->xy();
  CHECK(length(step) > 3);
  for (const std::size_t i : {1u, 2u})
    CHECK(length(o[i].position.xy() - scene.objects[i].position->xy() - step) < 1e-9);
  const Vec2 center = (1.0 / 3) * (o[0].position.xy() + o[1].position.xy() + o[2].position.xy());
  CHECK(std::abs(length(center - Vec2{9, 9}) - 4) < 0.01);
}

TEST_CASE("what stands on something stays on it wherever that goes") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Scene scene = empty_room(5, 5);
    const Ref table = add(scene, "table", {1.2, 0.8, 0.7}), tray = add(scene, "tray", {0.5, 0.3, 0.05});
    const Ref cup = add(scene, "cup", {0.08, 0.08, 0.1}), vase = add(scene, "vase", {0.15, 0.15, 0.3});
    scene.objects[tray.index].on = table, scene.objects[cup.index].on = tray, scene.objects[vase.index].on = table;
    WallDistance wall;
    wall.members = list_of({table});
    scene.constraints.add(wall);
    const Layout l = solved(scene, one(seed));
    CHECK(l.feasible);
    const auto& o = l.placement.objects;
    CHECK(o[tray.index].position.z == 0.7);
    CHECK(o[cup.index].position.z == 0.75);
    const auto box = [&](Ref r, double grow) {
      const Vec3 s = scene.objects[r.index].size;
      return make_box({o[r.index].position.xy(), o[r.index].angle}, {s.x + 2 * grow, s.y + 2 * grow, s.z});
    };
    for (const auto& [upper, lower] : {std::pair{tray, table}, std::pair{cup, tray}, std::pair{vase, table}}) {
      for (const Vec2 corner : box(upper, 0).corners()) CHECK(box(lower, 5e-3).contains(corner));
    }
  }
}
