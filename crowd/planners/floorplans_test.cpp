#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "core/rng.h"
#include "core/test_data.h"
#include "crowd/planners/test_world.h"

using namespace inhabit::crowd;
namespace scene = inhabit::scene;

namespace {

/// The polygons of a WKT file, largest first.
std::vector<Floor> read_floors(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream bytes;
  bytes << file.rdbuf();
  const std::string text = bytes.str();
  std::vector<Floor> floors;
  for (std::size_t at = 0; (at = text.find("POLYGON", at)) != std::string::npos;) {
    const std::size_t end = text.find("))", at);
    std::vector<Ring> rings;
    for (at = text.find("((", at) + 1; at != std::string::npos && at < end + 1; at = text.find('(', at + 1)) {
      std::string body = text.substr(at + 1, text.find(')', at) - at - 1);
      std::ranges::replace(body, ',', ' ');
      std::stringstream numbers(body);
      Ring ring;
      for (Vec2 p; numbers >> p.x >> p.y;) ring.push_back(p);
      ring.pop_back();
      rings.push_back(std::move(ring));
      if (at > end) break;
    }
    floors.push_back(make_floor(rings[0], {rings.begin() + 1, rings.end()}));
    at = end;
  }
  std::ranges::stable_sort(floors, std::greater<>(), [](const Floor& floor) { return area(floor); });
  return floors;
}

}  // namespace

TEST_CASE("on real floor plans fields and shortest paths agree on who gets where and how far it is") {
  struct Plan {
    const char* file;
    Vec2 goal;
  };
  for (const Plan& plan :
       {Plan{"BUW.wkt", {50, 20}}, Plan{"arena.wkt", {43, 60}}, Plan{"double_bottleneck.wkt", {1, 2.5}},
        Plan{"room_with_alcoven.wkt", {8.5, 0.6}}, Plan{"corner_with_shortcut.wkt", {29, 27}}}) {
    const auto found = INHABIT_TEST_DATA(std::string("floorplans/jupedsim_wkt/") + plan.file);
    if (!found) return;
    std::vector<Floor> floors = read_floors(*found);
    REQUIRE(!floors.empty());
    CAPTURE(std::string(plan.file));
    const Vec2 origin = floors[0].outline_bounds.center(), size = floors[0].outline_bounds.size();
    const World world = test_world(std::move(floors), origin);
    const scene::Goal goal =
        area_goal(box_ring(plan.goal.x - 0.4, plan.goal.y - 0.4, plan.goal.x + 0.4, plan.goal.y + 0.4));
    // Narrower than any gap of the plans by a hand's breadth, so that whether a gap is open is not a matter of
    // rounding.
    const double radius = 0.2;
    auto paths = std::move(*Planner::make(scene_with({goal}, scene::Planner::paths), world, {{{{0}}}}, radius));
    auto field = std::move(*Planner::make(scene_with({goal}, scene::Planner::field), world, {{{{0}}}}, radius));
    inhabit::core::Rng rng(17);
    int asked = 0, reachable = 0, longer = 0;
    while (asked < 60) {
      Agents agents;
      add_agent(agents, {rng.uniform(-0.5, 0.5) * size.x, rng.uniform(-0.5, 0.5) * size.y}, radius);
      double room = 1e300;
      if (!world.walls.on_floor(agents.x[0], agents.y[0])) continue;
      for (const WallSegment& s : world.walls.segments()) {
        const WallPoint q = nearest_point(s, agents.x[0], agents.y[0]);
        room = std::min(room, static_cast<double>(std::hypot(q.x - agents.x[0], q.y - agents.y[0])));
      }
      if (room < radius) continue;
      ++asked;
      paths.enter(agents, 0, 1), field.enter(agents, 0, 1);
      const double exact = paths.distance(agents, 0), along = field.distance(agents, 0);
      CHECK(std::isfinite(exact) == std::isfinite(along));
      if (!std::isfinite(exact) || !std::isfinite(along)) continue;
      ++reachable;
      // Paths pass corners at a hand's breadth, fields nearer where that is shorter: a decimetre or so at each.
      CHECK(along > 0.98 * exact - 0.4);
      longer += along > 1.03 * exact + 0.3 ? 1 : 0;
      if (reachable % 6 != 0) continue;
      Agents other = agents;
      CHECK(walk(paths, world, agents, 2 * exact).arrived);
      CHECK(walk(field, world, other, 2 * exact).arrived);
    }
    CHECK(reachable > 20);
    CHECK(longer * 10 <= reachable);
  }
}
