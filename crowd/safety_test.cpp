#include "crowd/safety.h"

#include <doctest/doctest.h>

#include <limits>

#include "crowd/people.h"
#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

Agents one_at(float x, float y) {
  Agents agents;
  add_person(agents, {0.25f, 1, 1, 1}, 0, 0, x, y);
  agents.vx[0] = 1;
  return agents;
}

/// Where the agent is after his model moved him so.
Vec2 after(const Walls& walls, Vec2 from, Vec2 to, std::size_t back) {
  Agents agents = one_at(static_cast<float>(from.x), static_cast<float>(from.y));
  agents.x[0] = static_cast<float>(to.x), agents.y[0] = static_cast<float>(to.y);
  CHECK(keep_on_floor(agents, walls, 1) == back);
  CHECK(agents.kept_x[0] == agents.x[0]);
  CHECK(agents.kept_y[0] == agents.y[0]);
  CHECK(agents.vx[0] == (back > 0 ? 0.0f : 1.0f));
  return {agents.x[0], agents.y[0]};
}

}  // namespace

TEST_CASE("whoever left the floor or crossed a wall goes back and everybody else stays") {
  const std::vector<Floor> floors = {make_floor(rectangle(0, 0, 10, 10), {rectangle(4, 0.5, 4.25, 9)})};
  const Walls walls(floors, {}, 0.5);
  CHECK(after(walls, {1, 1}, {1.125, 1}, 0) == Vec2{1.125, 1});
  CHECK(after(walls, {1, 0.25}, {1, 0}, 0) == Vec2{1, 0});
  CHECK(after(walls, {1, 0.25}, {1, -0.125}, 1) == Vec2{1, 0.25});
  CHECK(after(walls, {3.875, 5}, {4.125, 5}, 1) == Vec2{3.875, 5});
  CHECK(after(walls, {3.875, 5}, {4.3125, 5}, 1) == Vec2{3.875, 5});  // through the partition to the other side
  CHECK(after(walls, {1, 5}, {8, 5}, 1) == Vec2{1, 5});               // the same in one long leap
  CHECK(after(walls, {1, 9.5}, {8, 9.5}, 0) == Vec2{8, 9.5});         // a leap past it
  CHECK(after(walls, {1, 5}, {1000, 5}, 1) == Vec2{1, 5});
}

TEST_CASE("numbers that are no numbers go back") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const Walls& walls : {Walls(), Walls({make_floor(rectangle(0, 0, 10, 10), {})}, {}, 0.5)})
    for (const float bad : {nan, inf, -inf, 1e30f}) {
      for (int which = 0; which < 4; ++which) {
        Agents agents = one_at(5, 5);
        *std::array{&agents.x[0], &agents.y[0], &agents.vx[0], &agents.vy[0]}[static_cast<std::size_t>(which)] = bad;
        CHECK(keep_on_floor(agents, walls, 1) == 1);
        CHECK(agents.x[0] == 5);
        CHECK(agents.y[0] == 5);
        CHECK(agents.vx[0] == 0);
        CHECK(agents.vy[0] == 0);
      }
    }
}

TEST_CASE("agents are taken out by their indices") {
  Agents agents;
  for (std::uint32_t id = 0; id < 10; ++id) add_person(agents, {0.25f, 1, 1, 1}, id, 0, static_cast<float>(id), 0);
  agents.take_out(std::vector<std::uint32_t>{0, 3, 8, 9});
  REQUIRE(agents.size() == 6);
  CHECK(agents.id == std::vector<std::uint32_t>{6, 1, 2, 7, 4, 5});
  agents.for_each_array([](const auto& array) { CHECK(array.size() == 6); });
  for (std::size_t i = 0; i < 6; ++i) CHECK(agents.x[i] == static_cast<float>(agents.id[i]));
}
