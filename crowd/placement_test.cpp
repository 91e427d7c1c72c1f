#include "crowd/placement.h"

#include <doctest/doctest.h>

#include <set>

#include "crowd/people.h"
#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

struct Placed {
  World world;
  Agents agents;
  std::vector<Intake> intakes;
  Vec2 at(std::size_t i) const { return world.to_scene(agents.x[i], agents.y[i]); }
};

Placed place(const scene::Scene& scene, std::uint64_t seed = 1) {
  double widest = 0;
  for (const auto& p : scene.crowd.populations) widest = std::max(widest, p.radius.high);
  Result<World> world = make_world(scene, 1.1 * widest);
  REQUIRE(world.ok());
  Placed placed{*std::move(world), {}, {}};
  Spots spots(placed.world, widest);
  std::uint32_t next_id = 0;
  for (const auto& p : scene.crowd.populations)
    placed.intakes.push_back(place_population(p, 0, placed.world, seed, next_id, spots, placed.agents));
  CHECK(next_id == placed.agents.size());
  return placed;
}

/// How deep the worst pair overlaps, as a share of its radii; below 0 when nobody touches anybody.
double worst_overlap(const Placed& p) {
  double worst = -1;
  const Agents& a = p.agents;
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(clear_of_walls(p.world.walls, a.x[i], a.y[i], a.radius[i]));
    for (std::size_t j = 0; j < i; ++j) {
      const double radii = a.radius[i] + a.radius[j];
      worst = std::max(worst, 1 - std::hypot(a.x[i] - a.x[j], a.y[i] - a.y[j]) / radii);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("grids hold the centres of their cells row by row") {
  // The peers' passing scene: 20 x 40 from a 60 m x 120 m area at a spacing of 3 m.
  scene::Scene scene = room_of(140, 140);
  scene::Population people = grid_of("block", rectangle(10, 10, 70, 130), 3);
  people.radius = {0.5, 0.5};
  scene.crowd.populations = {people};
  const Placed placed = place(scene);
  REQUIRE(placed.agents.size() == 800);
  CHECK(placed.intakes[0].asked == 800);
  CHECK(placed.intakes[0].moved == 0);
  for (std::size_t k = 0; k < 800; ++k) {
    CHECK(placed.agents.id[k] == k);
    const Vec2 expected{11.5 + 3.0 * static_cast<double>(k % 20), 11.5 + 3.0 * static_cast<double>(k / 20)};
    REQUIRE(length(placed.at(k) - expected) < 1e-5);
  }
  // Jitter moves each coordinate by at most as much.
  scene.crowd.populations[0].jitter = 0.25;
  const Placed jittered = place(scene);
  double most = 0;
  for (std::size_t k = 0; k < 800; ++k) {
    const Vec2 d = jittered.at(k) - placed.at(k);
    most = std::max({most, std::abs(d.x), std::abs(d.y)});
  }
  CHECK(most <= 0.25 + 1e-5);
  CHECK(most > 0.24);
}

TEST_CASE("grids keep to the area's ring and to the count") {
  scene::Scene scene = room_of(20, 20);
  scene::Population people = grid_of("triangle", {{1, 1}, {9, 1}, {1, 9}}, 1);
  scene.crowd.populations = {people};
  CHECK(place(scene).agents.size() == 36);  // centres with x + y <= 8 of an 8 x 8 grid, the diagonal included
  scene.crowd.populations[0].count = 10;
  CHECK(place(scene).agents.size() == 10);
  scene.crowd.populations[0].count = 50;
  const Placed fewer = place(scene);
  CHECK(fewer.intakes[0].asked == 50);
  CHECK(fewer.intakes[0].placed == 36);
}

TEST_CASE("whoever would stand in a wall or on somebody is moved to a free place nearby") {
  scene::Scene scene = room_of(10, 10);
  scene.objects = {thing_of("table", {2, 2, 0.8}, {5, 5, 0})};
  scene::Population people = grid_of("all", rectangle(0, 0, 10, 10), 1);
  scene::Population again = grid_of("again", rectangle(1, 1, 4, 4), 1);
  scene.crowd.populations = {people, again};
  const Placed placed = place(scene);
  CHECK(placed.intakes[0].placed == 100);
  CHECK(placed.intakes[0].moved == 4);  // the four who stood in the table
  CHECK(placed.intakes[1].placed == 9);
  CHECK(placed.intakes[1].moved == 9);
  CHECK(worst_overlap(placed) <= kTouch + 1e-6);
}

TEST_CASE("people for whom there is no free place are refused and counted") {
  scene::Scene scene = room_of(3, 3);
  scene::Population people = grid_of("all", rectangle(0, 0, 3, 3), 0.1);
  scene.crowd.populations = {people};
  const Placed placed = place(scene);
  CHECK(placed.intakes[0].asked == 900);
  CHECK(placed.intakes[0].placed >= 25);
  CHECK(placed.intakes[0].placed <= 36);
  CHECK(worst_overlap(placed) <= kTouch + 1e-6);
}

TEST_CASE("without a spacing people stand at random and touch nobody") {
  scene::Scene scene = room_of(12, 10);
  scene.objects = {thing_of("table", {2, 3, 0.8}, {5, 5, 0})};
  scene::Population people;
  people.id = "crowd", people.area = rectangle(1, 1, 11, 9), people.count = 120;
  scene.crowd.populations = {people};
  const Placed placed = place(scene);
  CHECK(placed.intakes[0].placed == 120);
  CHECK(worst_overlap(placed) <= kTouch + 1e-6);
  for (std::size_t i = 0; i < 120; ++i) CHECK(contains(people.area, placed.at(i)));
  const Placed same = place(scene), other = place(scene, 2);
  CHECK(same.agents.x == placed.agents.x);
  CHECK(other.agents.x != placed.agents.x);
}

TEST_CASE("more people than darts can place are packed in hexagons and the rest is refused") {
  scene::Scene scene = room_of(5, 5);
  scene::Population people;
  people.id = "crowd", people.area = rectangle(0, 0, 5, 5);
  // Darts stop at about 54 % of the area: 70 of these discs. Hexagons hold about 85 %.
  people.count = 90;
  scene.crowd.populations = {people};
  const Placed packed = place(scene);
  CHECK(packed.intakes[0].placed == 90);
  // 25 m² for 90 are hexagons 0.566 m apart but for the rim, and half of the gap is left: they do not start pressed.
  CHECK(worst_overlap(packed) < -0.015);
  scene.crowd.populations[0].count = 1000;
  const Placed full = place(scene);
  CHECK(full.intakes[0].asked == 1000);
  CHECK(full.intakes[0].placed >= 100);
  CHECK(full.intakes[0].placed <=
        127);  // the area over that of a hexagon round a disc: 25 / (2 sqrt(3) r^2) = 115, and its rim
  CHECK(worst_overlap(full) <= kTouch + 1e-6);
}

TEST_CASE("empty populations place nobody") {
  scene::Scene scene = room_of(5, 5);
  scene::Population none;
  none.id = "none", none.area = rectangle(0, 0, 5, 5), none.count = 0;
  scene::Population nowhere = none;
  nowhere.area.clear(), nowhere.count = 3;
  scene::Population outside = grid_of("outside", rectangle(50, 50, 52, 52), 1);
  scene.crowd.populations = {none, nowhere, outside};
  const Placed placed = place(scene);
  CHECK(placed.agents.empty());
  CHECK(placed.intakes[0].asked == 0);
  CHECK(placed.intakes[1].asked == 3);
  CHECK(placed.intakes[2].asked == 4);
  CHECK(placed.intakes[2].placed == 0);
}

TEST_CASE("who somebody is depends on the seed and his number alone") {
  scene::Body body;
  body.radius = {1.25, 2}, body.mass = 30;
  body.speed = {1.4, 0.6, std::nullopt};
  double sum = 0, squares = 0;
  const int n = 20000;
  for (std::uint32_t id = 0; id < n; ++id) {
    const Person person = make_person(body, 3, id);
    REQUIRE(person.radius >= 1.25f);
    REQUIRE(person.radius <= 2);
    REQUIRE(person.mass == 30);
    REQUIRE(person.preferred_speed >= 0.14f);
    REQUIRE(person.preferred_speed <= 1.4f + 1.8f);
    CHECK(person.maximum_speed == doctest::Approx(1.3 * person.preferred_speed));
    sum += person.preferred_speed, squares += double(person.preferred_speed) * person.preferred_speed;
  }
  const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
  // Cut at -2.1 and +3 deviations: mean + 0.6 (phi(2.1) - phi(3)) / Z = 1.4242, deviation 0.5662; four standard errors.
  CHECK(std::abs(mean - 1.4242) < 4 * 0.6 / std::sqrt(n));
  CHECK(std::abs(deviation - 0.5662) < 4 * 0.6 / std::sqrt(2.0 * n));
  CHECK(make_person(body, 3, 7).preferred_speed == make_person(body, 3, 7).preferred_speed);
  CHECK(make_person(body, 3, 7).preferred_speed != make_person(body, 4, 7).preferred_speed);
  body.speed.maximum = 1.0;
  for (std::uint32_t id = 0; id < 100; ++id) CHECK(make_person(body, 3, id).preferred_speed <= 1.0f);
}
