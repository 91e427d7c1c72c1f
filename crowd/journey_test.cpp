#include "crowd/journey.h"

#include <doctest/doctest.h>

#include <cmath>

#include "crowd/people.h"
#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

/// A hall with a shop and two exits, and one person on the way to the shop and then out.
struct Hall {
  explicit Hall(double wait = 0, bool absorb = true) {
    scene.crowd.goals = {goal_of("shop", rectangle(4, 4, 6, 6)), goal_of("east", rectangle(18, 0, 20, 10)),
                         goal_of("west", rectangle(0, 0, 2, 10))};
    scene.crowd.goals[0].wait = wait, scene.crowd.goals[2].absorb = absorb;
    scene::Population people = grid_of("shoppers", rectangle(9, 4, 10, 5), 1);
    people.goal.legs = {{"shop"}, {"east", "west"}};
    scene.crowd.populations = {people};
    book = *make_routes(scene.crowd);
    world = *make_world(scene, 1);
    planner = *Planner::make(scene, world, book.routes, 0.25);
    journeys.emplace(scene.crowd, world, book.routes);
    add_person(agents, {0.25f, 1, 1, 1}, 0, book.of_population[0], 0, 0);
    planner->enter(agents, 0, 1);
  }
  void be_at(double x, double y) {
    const Vec2 p = Vec2{x, y} - world.origin;
    agents.x[0] = static_cast<float>(p.x), agents.y[0] = static_cast<float>(p.y);
    planner->aim(agents, 1);
    journeys->advance(agents, *planner, 0.25, 1);
  }

  scene::Scene scene = room_of(20, 10);
  RouteBook book;
  World world;
  std::optional<Planner> planner;
  std::optional<Journeys> journeys;
  Agents agents;
};

}  // namespace

TEST_CASE("routes are resolved by name and equal ones are kept once") {
  scene::Crowd crowd;
  crowd.goals = {goal_of("east", {}), goal_of("west", {})};
  crowd.populations = {grid_of("a", {}, 1, "west"), grid_of("b", {}, 1), grid_of("c", {}, 1, "west")};
  crowd.sources = {source_of("s", {}, 1, "east")};
  const Result<RouteBook> book = make_routes(crowd);
  REQUIRE(book.ok());
  CHECK(book->of_population == std::vector<std::uint16_t>{0, 1, 0});
  CHECK(book->of_source == std::vector<std::uint16_t>{2});
  CHECK(book->routes.legs[0] == std::vector<std::vector<std::uint16_t>>{{1}});
  CHECK(book->routes.legs[1].empty());
  crowd.sources[0].goal = to("eats");
  const Result<RouteBook> unknown = make_routes(crowd);
  REQUIRE_FALSE(unknown.ok());
  CHECK(unknown.error().where == "/crowd/sources/0/goal");
  CHECK(unknown.error().message.find("did you mean \"east\"") != std::string::npos);
}

TEST_CASE("people go from goal to goal and leave at the end of their route") {
  Hall hall;
  hall.be_at(9, 5);
  CHECK(hall.agents.leg[0] == 0);
  hall.be_at(5, 5);
  CHECK(hall.agents.leg[0] == 1);
  CHECK(hall.journeys->arrived() == 0);
  hall.be_at(1, 5);
  CHECK(hall.journeys->arrived() == 1);
  REQUIRE(hall.journeys->leaving().size() == 1);
  CHECK(hall.journeys->leaving()[0] == 0);
}

TEST_CASE("people wait in a goal as long as it says") {
  Hall hall(1);  // four steps of 0.25 s
  hall.be_at(5, 5);
  CHECK(hall.agents.wait[0] == 1);
  for (int k = 0; k < 3; ++k) {
    hall.be_at(5, 5);
    CHECK(hall.agents.leg[0] == 0);
  }
  CHECK(hall.agents.wish_x[0] == 0);
  hall.be_at(5, 5);
  CHECK(hall.agents.leg[0] == 1);
  CHECK(hall.agents.wait[0] == 0);
}

TEST_CASE("a goal that does not absorb keeps whoever arrives and counts him once") {
  Hall hall(0, false);
  hall.be_at(5, 5);
  for (int k = 0; k < 3; ++k) hall.be_at(1, 5);
  CHECK(hall.journeys->arrived() == 1);
  CHECK(hall.journeys->leaving().empty());
  CHECK(hall.agents.wait[0] == kStays);
  Hall other(0, false);
  other.be_at(5, 5);
  other.be_at(19, 5);  // the other exit of the same leg does
  CHECK(other.journeys->leaving().size() == 1);
}
