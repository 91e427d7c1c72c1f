#include "crowd/world.h"

#include <doctest/doctest.h>

#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

double floor_area(const World& world) {
  double sum = 0;
  for (const Floor& floor : world.floors) sum += area(floor);
  return sum;
}

bool on_floor(const World& world, double x, double y) {
  const Vec2 p = Vec2{x, y} - world.origin;
  return world.walls.on_floor(static_cast<float>(p.x), static_cast<float>(p.y));
}

}  // namespace

TEST_CASE("furniture that people bump into takes its footprint from the floor") {
  scene::Scene scene = room_of(6, 4);
  scene.objects = {thing_of("table", {2, 1, 0.75}, {3, 2, 0}),      // taken: 1 wide along its front (x), 2 across
                   thing_of("rug", {3, 3, 0.02}, {1.5, 2, 0}),      // walked on
                   thing_of("lamp", {0.4, 0.4, 0.3}, {1, 1, 2.2}),  // hangs above the heads
                   thing_of("shelf", {0.5, 0.5, 0.4}, {5.5, 3.5, 1.5})};
  scene::Object lost = thing_of("chair", {0.5, 0.5, 0.9}, {});
  lost.position.reset();  // not there
  scene.objects.push_back(lost);
  const Result<World> world = make_world(scene, 1);
  REQUIRE(world.ok());
  CHECK(std::abs(floor_area(*world) - (24 - 2 - 0.25)) < 1e-6);
  CHECK_FALSE(on_floor(*world, 3, 2));
  CHECK(on_floor(*world, 1.5, 2));
  CHECK(on_floor(*world, 1, 1));
  CHECK_FALSE(on_floor(*world, 5.5, 3.5));
  CHECK(world->origin == Vec2{3, 2});
}

TEST_CASE("furniture can part a room into several floors and the largest comes first") {
  scene::Scene scene = room_of(6, 4);
  scene.objects = {thing_of("wardrobe", {4.2, 0.5, 2}, {2, 2, 0})};
  scene.space.holes.push_back({"pillar", rectangle(4, 1, 4.5, 1.5), {}});
  const Result<World> world = make_world(scene, 1);
  REQUIRE(world.ok());
  REQUIRE(world->floors.size() == 2);
  CHECK(std::abs(area(world->floors[0]) - (3.75 * 4 - 0.25)) < 1e-6);
  CHECK(std::abs(area(world->floors[1]) - 1.75 * 4) < 1e-6);
}

TEST_CASE("a room that is full of furniture has no floor") {
  scene::Scene scene = room_of(6, 4);
  scene.objects = {thing_of("stage", {5, 7, 1}, {3, 2, 0})};
  const Result<World> world = make_world(scene, 1);
  REQUIRE_FALSE(world.ok());
  CHECK(world.error().where == "/space");
  scene.space.outline.clear();
  CHECK_FALSE(make_world(scene, 1).ok());
}

TEST_CASE("walls are closed but for doors that a goal or a source reaches through") {
  scene::Scene scene = room_of(6, 4);
  scene::Door used, unused;
  used.wall = 1, used.from = 1, used.width = 1;        // x = 6, y from 1 to 2
  unused.wall = 3, unused.from = 1, unused.width = 1;  // x = 0, y from 3 to 2
  scene.space.doors = {used, unused};
  scene.crowd.goals = {goal_of("out", rectangle(6.2, 0.5, 7, 2.5))};
  const Result<World> world = make_world(scene, 1);
  REQUIRE(world.ok());
  CHECK(std::abs(floor_area(*world) - (24 + 1)) < 1e-6);
  CHECK(on_floor(*world, 6.9, 1.5));
  CHECK_FALSE(on_floor(*world, 6.9, 0.9));
  CHECK_FALSE(on_floor(*world, -0.1, 2.5));
  // An area that lies at the door, inside, asks for nothing.
  scene.crowd.goals = {goal_of("out", rectangle(5.5, 1, 6, 2))};
  CHECK(std::abs(floor_area(*make_world(scene, 1)) - 24) < 1e-6);
}
