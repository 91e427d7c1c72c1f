#include "crowd/planner.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "core/rng.h"
#include "crowd/planners/test_world.h"

using namespace inhabit::crowd;
namespace scene = inhabit::scene;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::array kMethods = {scene::Planner::paths, scene::Planner::field};

Planner planner_of(const scene::Scene& scene, const World& world, const Routes& routes, double widest = 0.25) {
  return std::move(*Planner::make(scene, world, routes, widest, 1));
}

/// A T: a stem 4 m wide from below into a bar 4 m high.
World t_junction() {
  return test_world({make_floor({{-2, 0}, {2, 0}, {2, 6}, {10, 6}, {10, 10}, {-10, 10}, {-10, 6}, {-2, 6}}, {})});
}

double wish_length(const Agents& agents, std::size_t i) { return std::hypot(agents.wish_x[i], agents.wish_y[i]); }

}  // namespace

TEST_CASE("everybody gets through a T junction and walks little more than the shortest way") {
  const World world = t_junction();
  inhabit::core::Rng rng(11);
  for (const scene::Planner method : kMethods) {
    const scene::Scene scene = scene_with({area_goal(box_ring(-9.5, 6.5, -8.5, 9.5))}, method);
    Planner planner = planner_of(scene, world, {{{{0}}}});
    CHECK(planner.method(0, 0) == method);
    for (int k = 0; k < 40; ++k) {
      Agents agents;
      const Vec2 p = k % 2 == 0 ? Vec2{rng.uniform(-1.9, 1.9), rng.uniform(0.1, 6)}
                                : Vec2{rng.uniform(0, 9.9), rng.uniform(6.1, 9.9)};
      add_agent(agents, p);
      planner.enter(agents, 0, 1);
      const double distance = planner.distance(agents, 0);
      const Walk w = walk(planner, world, agents, 30);
      CHECK(w.arrived);
      CHECK_FALSE(w.crossed);
      CHECK(w.length == doctest::Approx(distance).epsilon(0.03));
    }
  }
}

TEST_CASE("a straight way heads for the nearest point of the aim and then for the area") {
  scene::Goal goal = area_goal(box_ring(0, -20, 40, 20));
  goal.aim = box_ring(0.5, -2, 0.6, 2);
  scene::Goal east;
  east.id = "east", east.direction = 0;
  const scene::Scene scene = scene_with({goal, east}, scene::Planner::straight);
  Planner planner = planner_of(scene, test_world({}), {{{{0}, {1}}}});
  Agents agents;
  add_agent(agents, {-3.5, 5}), add_agent(agents, {-4, 1}), add_agent(agents, {3, 7});
  agents.leg[2] = 1;
  planner.aim(agents, 1);
  CHECK(agents.wish_x[0] == doctest::Approx(1.4 * 0.8));
  CHECK(agents.wish_y[0] == doctest::Approx(1.4 * -0.6));
  CHECK(agents.wish_x[1] == doctest::Approx(1.4));
  CHECK(agents.wish_y[1] == 0);
  CHECK(agents.wish_x[2] == doctest::Approx(1.4));
  CHECK_FALSE(planner.arrived(agents, 0));
  CHECK_FALSE(planner.arrived(agents, 2));
  agents.x[0] = 0.01f;
  CHECK(planner.arrived(agents, 0));
}

TEST_CASE("people who all walk straight to one goal have the wishes that they have among others") {
  const World world = test_world({make_floor({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {})});
  scene::Goal goal = area_goal(box_ring(5, -3, 9, 3));
  goal.aim = box_ring(6, -1, 7, 1);
  Planner planner = planner_of(scene_with({goal}, scene::Planner::straight), world, {{{{0}}}});
  inhabit::core::Rng rng(3);
  Agents alone;
  for (int k = 0; k < 200; ++k) add_agent(alone, {rng.uniform(-19, 19), rng.uniform(-19, 19)});
  add_agent(alone, {6.5, 0});  // on the aim, and in the area
  add_agent(alone, {5, -3});   // on the area's corner
  Agents among = alone;
  add_agent(among, {0, 0});
  among.wait.back() = 1;  // so that not everybody heads for the goal
  planner.aim(alone, 1), planner.aim(among, 1);
  std::size_t walking = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    CHECK(alone.wish_x[i] == among.wish_x[i]);
    CHECK(alone.wish_y[i] == among.wish_y[i]);
    walking += wish_length(alone, i) > 0;
  }
  CHECK(walking > 150);
  CHECK(wish_length(among, among.size() - 1) == 0);
}

TEST_CASE("goals in sequence are walked to one after the other and waiting people stand") {
  const World world = t_junction();
  for (const scene::Planner method : kMethods) {
    const scene::Scene scene =
        scene_with({area_goal(box_ring(8, 7, 9, 9), "a"), area_goal(box_ring(-9, 7, -8, 9), "b")}, method);
    Planner planner = planner_of(scene, world, {{{{0}, {1}}}});
    Agents agents;
    add_agent(agents, {0, 1});
    planner.enter(agents, 0, 1);
    CHECK(walk(planner, world, agents, 30).arrived);
    CHECK(agents.x[0] > 7.9f);
    agents.leg[0] = 1, agents.wait[0] = 1;
    planner.aim(agents, 1);
    CHECK(wish_length(agents, 0) == 0);
    agents.wait[0] = 0;
    CHECK(walk(planner, world, agents, 30).arrived);
    CHECK(agents.x[0] < -7.9f);
    agents.leg[0] = 2;  // the route is over
    planner.aim(agents, 1);
    CHECK(wish_length(agents, 0) == 0);
    CHECK_FALSE(planner.arrived(agents, 0));
    CHECK(planner.distance(agents, 0) == 0);
  }
}

TEST_CASE("of several exits the nearest on foot counts and not the nearest in the air") {
  // Exits left and right of a partition wall that hangs from the upper wall; the agent stands left of it.
  const Ring outline = {{-13, 0}, {10, 0}, {10, 6}, {0.2, 6}, {0.2, 1}, {-0.2, 1}, {-0.2, 6}, {-13, 6}};
  const World world = test_world({make_floor(outline, {})});
  const auto goals = {area_goal(box_ring(-12.5, 4, -12, 5), "left"), area_goal(box_ring(0.6, 5, 1, 5.5), "right")};
  for (const scene::Planner method : kMethods) {
    Planner planner = planner_of(scene_with(goals, method), world, {{{{0, 1}}}});
    Planner only_left = planner_of(scene_with(goals, method), world, {{{{0}}}});
    Planner only_right = planner_of(scene_with(goals, method), world, {{{{1}}}});
    // The right exit is behind the partition. Where both are as far on foot is found by bisection of the ways to each;
    // on both sides of it people go different ways.
    double left = -11, right = -0.6;
    for (int k = 0; k < 30; ++k) {
      Agents agents;
      add_agent(agents, {(left + right) / 2, 5.0});
      (only_left.distance(agents, 0) < only_right.distance(agents, 0) ? left : right) = (left + right) / 2;
    }
    CHECK(left < -2);  // x + 12 = sqrt(x^2 + 16) + 4.6 or so: -2.6
    CHECK(left > -3.2);
    for (const double side : {-0.4, 0.4}) {
      Agents agents;
      add_agent(agents, {left + side, 5.0});
      planner.enter(agents, 0, 1);
      const Walk w = walk(planner, world, agents, 30);
      CHECK(w.arrived);
      CHECK((w.end.x < 0) == (side < 0));
    }
  }
}

TEST_CASE("goals that no way leads to are infinitely far and nobody walks into the wall") {
  const World world = test_world({make_floor(box_ring(0, 0, 5, 5), {}), make_floor(box_ring(5.1, 0, 10, 5), {})});
  for (const scene::Planner method : {scene::Planner::paths, scene::Planner::field, scene::Planner::automatic}) {
    Planner planner = planner_of(scene_with({area_goal(box_ring(8, 1, 9, 2))}, method), world, {{{{0}}}});
    Agents agents;
    add_agent(agents, {1, 1}), add_agent(agents, {6, 1.5}), add_agent(agents, {4.9, 1});
    for (std::size_t i = 0; i < 3; ++i) planner.enter(agents, i, 1);
    CHECK(planner.distance(agents, 0) == kInfinite);
    CHECK(planner.distance(agents, 2) == kInfinite);
    CHECK(planner.distance(agents, 1) == doctest::Approx(2).epsilon(0.02));
    planner.aim(agents, 1);
    if (method != scene::Planner::automatic) CHECK(wish_length(agents, 0) == 0);
    CHECK(agents.wish_x[1] == doctest::Approx(1.4).epsilon(0.01));
  }
  // A goal that is nowhere, and no goal at all.
  Planner planner = planner_of(scene_with({scene::Goal{}}, scene::Planner::automatic), world, {{{{0}}, {}}});
  Agents agents;
  add_agent(agents, {1, 1}), add_agent(agents, {1, 1});
  agents.route[1] = 1;
  planner.aim(agents, 1);
  CHECK(planner.distance(agents, 0) == kInfinite);
  CHECK(wish_length(agents, 0) == 0);
  CHECK(wish_length(agents, 1) == 0);
}

TEST_CASE("an offset leads from each own start and nobody oscillates about it") {
  scene::Goal goal;
  goal.id = "there", goal.offset = Vec2{6, -2}, goal.jitter = 0.5;
  Planner planner = planner_of(scene_with({goal}, scene::Planner::automatic), test_world({}), {{{{0}}}});
  Agents agents;
  for (int k = 0; k < 50; ++k) add_agent(agents, {0.7 * k, 0.1 * k});
  for (std::size_t i = 0; i < 50; ++i) planner.enter(agents, i, 42);
  const Agents start = agents;
  const float dt = 1.0f / 48, relaxation = 0.5f;
  std::vector<double> least(50, 1e300), last(50);
  double overshoot = 0;
  bool arrived = false;
  for (int step = 0; step < 48 * 15; ++step) {
    planner.aim(agents, 1);
    for (std::size_t i = 0; i < 50; ++i) {
      agents.vx[i] += dt / relaxation * (agents.wish_x[i] - agents.vx[i]);
      agents.vy[i] += dt / relaxation * (agents.wish_y[i] - agents.vy[i]);
      agents.x[i] += dt * agents.vx[i], agents.y[i] += dt * agents.vy[i];
      last[i] = planner.distance(agents, i);
      if (last[i] > least[i]) overshoot = std::max(overshoot, last[i]);
      least[i] = std::min(least[i], last[i]);
    }
  }
  for (std::size_t i = 0; i < 50; ++i) {
    arrived = planner.arrived(agents, i);
    CHECK(arrived);
    CHECK(last[i] < 0.01);
    CHECK(std::abs(agents.x[i] - start.x[i] - 6) < 0.51);
    CHECK(std::abs(agents.y[i] - start.y[i] + 2) < 0.51);
  }
  // x'' = (-x / 1 s - x') / 0.5 s from x = 1.4 m and x' = -1.4 m/s on is 1.4 exp(-t) cos(t), at least -0.094 m.
  CHECK(overshoot < 0.095);
  CHECK(agents.x[3] - start.x[3] != agents.x[4] - start.x[4]);
}

TEST_CASE("automatic goes straight on convex floors and by a field when many share the goal") {
  scene::Scene scene = scene_with({area_goal(box_ring(8, 7, 9, 9))}, scene::Planner::automatic);
  const World convex = test_world({make_floor(box_ring(-10, 0, 10, 10), {})}), junction = t_junction();
  const Routes routes{{{{0}}}};
  CHECK(planner_of(scene, convex, routes).method(0, 0) == scene::Planner::straight);
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::paths);
  scene::Population people;
  people.goal.legs = {{"goal"}};
  people.count = 49;
  scene.crowd.populations = {people};
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::paths);
  scene.crowd.populations[0].count = 50;
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::field);
  scene.crowd.populations[0].count.reset();
  scene.crowd.populations[0].spacing = 0.5, scene.crowd.populations[0].area = box_ring(-2, 0, 2, 4);
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::field);
  scene.crowd.populations.clear();
  scene::Source source;
  source.goal.legs = {{"goal"}}, source.rate = 1;
  scene.crowd.sources = {source}, scene.crowd.seconds = 40;
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::paths);
  scene.crowd.seconds = 60;
  CHECK(planner_of(scene, junction, routes).method(0, 0) == scene::Planner::field);
  CHECK(planner_of(scene, convex, routes).method(0, 0) == scene::Planner::straight);
}

TEST_CASE("permuted agents have permuted wishes and threads do not matter") {
  const World world = t_junction();
  for (const scene::Planner method : {scene::Planner::straight, scene::Planner::paths, scene::Planner::field}) {
    const scene::Scene scene =
        scene_with({area_goal(box_ring(8, 7, 9, 9), "a"), area_goal(box_ring(-9, 7, -8, 9), "b")}, method);
    const Routes routes{{{{0}}, {{0, 1}}}};
    Planner one = planner_of(scene, world, routes), other = planner_of(scene, world, routes);
    inhabit::core::Rng rng(21);
    Agents a;
    const int count = method == scene::Planner::paths ? 6000 : 20000;
    for (int k = 0; k < count; ++k) {
      const std::size_t i = add_agent(a, {rng.uniform(-1.9, 1.9), rng.uniform(0.1, 9.9)});
      a.route[i] = static_cast<std::uint16_t>(k % 2), a.wait[i] = k % 7 == 0 ? 1.0f : 0.0f;
      one.enter(a, i, 3), other.enter(a, i, 3);
    }
    Agents b = a;
    std::vector<std::uint32_t> order(a.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [](std::uint32_t k) { return inhabit::core::mix64(k); });
    b.permute(order);
    for (int step = 0; step < 5; ++step) {
      one.aim(a, 1), other.aim(b, 8);
      for (std::size_t k = 0; k < order.size(); ++k) {
        REQUIRE(std::memcmp(&b.wish_x[k], &a.wish_x[order[k]], sizeof(float)) == 0);
        REQUIRE(std::memcmp(&b.wish_y[k], &a.wish_y[order[k]], sizeof(float)) == 0);
      }
      for (Agents* agents : {&a, &b})
        for (std::size_t i = 0; i < agents->size(); ++i)
          agents->x[i] += 0.1f * agents->wish_x[i], agents->y[i] += 0.1f * agents->wish_y[i];
    }
    std::vector<std::uint8_t> flags(a.size());
    one.arrived(a, flags, 8);
    for (std::size_t i = 0; i < a.size(); ++i) REQUIRE((flags[i] != 0) == one.arrived(a, i));
  }
}
