#include <algorithm>
#include <cmath>

#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"

/// The tests of the RiMEA guideline (version 3) that are about walking in the plane, with its measures. Tests 2, 3, 13
/// and 14 need stairs, 8 needs three floors. Where the text gives a figure only, our reading of it stands here.
namespace inhabit::session {
namespace {

Body heading_for(std::vector<std::string> goals) {
  Body body = pedestrian_body();
  body.goal = route_to(std::move(goals));
  return body;
}

/// The goal at the far end of an exit of hall_with_exits.
Goal exit_goal(std::string id, Opening o, double wall, double outward) {
  const double a = wall + outward * kExitDepth / 2, b = wall + outward * kExitDepth;
  return area_goal(std::move(id), rectangle(o.from, std::min(a, b), o.to, std::max(a, b)));
}

}  // namespace

/// One person, 40 m along a corridor 2 m wide at 1.33 m/s: 26 to 34 s. He begins at x = 0.
Scene rimea_01() {
  Scene scene = room_to_walk("rimea-01", rectangle(-2, 0, 42, 2), 60);
  scene.crowd.goals = {area_goal("end", rectangle(40, 0, 42, 2))};
  Body body = heading_for({"end"});
  body.speed = {1.33, 0, {}};
  scene.crowd.populations = {grid_of_people("person", {0, 1}, 1, 1, 1, 0, body)};
  return scene;
}

/// 1,000 m by 10 m. "As equal as possible free walking speed (for example 1.2 - 1.4 m/s)": 1.3 m/s, three deviations
/// to either. The mean speed in 2 m by 2 m in the middle is measured from 10 to 70 s; nobody who meets the end does so
/// within hundreds of metres of it.
Scene rimea_04(double density) {
  const int tenths = static_cast<int>(std::lround(density * 10));
  Scene scene = room_to_walk("rimea-04-density-" + std::string(tenths < 10 ? "0" : "") + std::to_string(tenths),
                             rectangle(0, 0, 1000, 10), 70);
  scene.crowd.goals = {area_goal("end", rectangle(998, 0, 1000, 10))};
  Body body = heading_for({"end"});
  body.speed = {1.3, 0.033, {}};
  const int count = static_cast<int>(std::lround(density * 1e4));
  scene.crowd.populations = {people_in("walkers", rectangle(0, 0, 998, 10), count, body)};
  scene.crowd.planner = Planner::straight;
  return scene;
}

/// Ten people in a room of 8 m by 5 m with an exit of 1 m in the middle of a wall of 5 m. Premovement times spread
/// evenly from 10 to 100 s: a goal to wait at, for each, where he stands.
Scene rimea_05() {
  const Opening exit{2, 3};
  Scene scene = room_to_walk("rimea-05", hall_with_exits(5, 8, {}, {exit}), 130);
  scene.crowd.goals = {exit_goal("exit", exit, 8, 1)};
  for (int k = 0; k < 10; ++k) {
    const Vec2 at{1.5 + 2 * (k % 2), 1 + 1.25 * (k / 2)};
    const std::string id = "start-" + std::to_string(k + 1);
    Goal start = area_goal(id, rectangle(at.x - 0.4, at.y - 0.4, at.x + 0.4, at.y + 0.4));
    start.wait = 10 * (k + 1);
    scene.crowd.goals.push_back(start);
    scene.crowd.populations.push_back(
        grid_of_people("person-" + std::to_string(k + 1), at, 1, 1, 0.8, 0, heading_for({id, "exit"})));
  }
  return scene;
}

/// Twenty people round a corner to the left, from the first 6 m of a corridor 2 m wide.
Scene rimea_06() {
  Scene scene = room_to_walk("rimea-06", {{0, 0}, {12, 0}, {12, 12}, {10, 12}, {10, 2}, {0, 2}}, 60);
  scene.crowd.goals = {area_goal("end", rectangle(10, 11, 12, 12))};
  scene.crowd.populations = {people_in("group", rectangle(0, 0, 6, 2), 20, heading_for({"end"}))};
  return scene;
}

/// Fifty adults on a field of 40 m by 50 m; their speeds are to follow Weidmann's distribution.
Scene rimea_07() {
  Scene scene = room_to_walk("rimea-07", rectangle(0, 0, 40, 50), 60);
  scene.crowd.goals = {area_goal("end", rectangle(39, 0, 40, 50))};
  scene.crowd.populations = {grid_of_people("adults", {1, 0.5}, 1, 50, 1, 0, heading_for({"end"}))};
  return scene;
}

/// 1,000 people in a hall of 30 m by 20 m with four exits of 1 m, 4 m from the corners; closing two doubles the time.
Scene rimea_09(bool four_exits) {
  const std::vector<Opening> exits = {{4, 5}, {25, 26}};
  Scene scene =
      room_to_walk(four_exits ? "rimea-09-four-exits" : "rimea-09-two-exits",
                   hall_with_exits(30, 20, exits, four_exits ? exits : std::vector<Opening>{}), four_exits ? 300 : 600);
  scene.crowd.goals = {exit_goal("exit-3", exits[0], 0, -1), exit_goal("exit-4", exits[1], 0, -1)};
  Body body = pedestrian_body();
  body.goal.legs = {{"exit-3", "exit-4"}};
  if (four_exits) {
    scene.crowd.goals.push_back(exit_goal("exit-1", exits[0], 20, 1));
    scene.crowd.goals.push_back(exit_goal("exit-2", exits[1], 20, 1));
    body.goal.legs[0].insert(body.goal.legs[0].end(), {"exit-1", "exit-2"});
  }
  scene.crowd.populations = {people_in("crowd", rectangle(0, 0, 30, 20), 1000, body)};
  return scene;
}

namespace {

/// A room beside the corridor of test 10 and the door between them.
struct Room {
  double from, to, door;
};
constexpr double kDoor = 0.9, kHalfWall = 0.05;
constexpr Room kUpper[] = {{0, 3, 1.05},   {3, 6, 4.05},    {7.2, 9, 7.65},
                           {9, 12, 10.05}, {12, 15, 13.05}, {15, 18, 16.05}};
constexpr Room kLower[] = {{0, 3, 1.05}, {3, 6, 4.05}, {6, 9, 7.05}, {9, 12, 10.05}, {12, 15, 13.05}, {15, 18, 16.05}};

/// Corners of a room seen from its door, left jamb first when one looks away from the corridor's right end.
void add_room(Ring& ring, const Room& room, bool upper) {
  const double edge = upper ? 6 : 5, wall = upper ? 6.1 : 4.9, end = upper ? 11 : 0;
  const double a = room.from + kHalfWall, b = room.to - kHalfWall, d0 = room.door, d1 = room.door + kDoor;
  std::vector<Vec2> corners = {{d0, edge}, {d0, wall}, {a, wall},  {a, end},
                               {b, end},   {b, wall},  {d1, wall}, {d1, edge}};
  if (upper) std::reverse(corners.begin(), corners.end());
  for (const Vec2 p : corners) ring.push_back({neat(p.x), p.y});
}

}  // namespace

/// Twelve rooms of 3 m by 5 m along a corridor 1 m wide, doors of 0.9 m, 23 people: rooms 1 to 4 and 7 to 10 take the
/// main exit, between rooms 2 and 3, the others the one at the corridor's right end. Rooms 1 to 6 are the upper row
/// from the left, 7 to 12 the lower. Two people in each, one in room 3, which the main exit makes smaller.
Scene rimea_10() {
  Ring ring = {{0, 5}};
  for (const Room& room : kLower) add_room(ring, room, false);
  for (const Vec2 p : {Vec2{19, 5}, {19, 6}}) ring.push_back(p);
  for (std::size_t k = 6; k-- > 0;) {
    add_room(ring, kUpper[k], true);
    if (k == 2)
      for (const Vec2 p : {Vec2{7.2, 6}, {7.2, 11}, {6, 11}, {6, 6}}) ring.push_back(p);
  }
  ring.push_back({0, 6});
  Scene scene = room_to_walk("rimea-10", std::move(ring), 60);
  scene.crowd.goals = {area_goal("main-exit", rectangle(6, 10, 7.2, 11)),
                       area_goal("secondary-exit", rectangle(18.2, 5, 19, 6))};
  for (int k = 0; k < 12; ++k) {
    const Room& room = k < 6 ? kUpper[k] : kLower[k - 6];
    const bool main = k % 6 < 4;
    const double low = k < 6 ? 7 : 1;
    scene.crowd.populations.push_back(people_in("room-" + std::to_string(k + 1),
                                                rectangle(room.from + 0.3, low, room.to - 0.3, low + 3), k == 2 ? 1 : 2,
                                                heading_for({main ? "main-exit" : "secondary-exit"})));
  }
  return scene;
}

/// 1,000 people at the left of a hall of 30 m by 20 m, as dense as they can stand at 0.5 m, and two exits at the upper
/// right: most take the nearer one.
Scene rimea_11() {
  const std::vector<Opening> exits = {{21, 22}, {27, 28}};
  Scene scene = room_to_walk("rimea-11", hall_with_exits(30, 20, {}, exits), 600);
  scene.crowd.goals = {exit_goal("exit-1", exits[0], 20, 1), exit_goal("exit-2", exits[1], 20, 1)};
  Body body = pedestrian_body();
  body.goal.legs = {{"exit-1", "exit-2"}};
  scene.crowd.populations = {grid_of_people("crowd", {0.25, 0.25}, 25, 40, 0.5, 0.02, body)};
  return scene;
}

/// 150 people in the far half of a room of 10 m by 10 m that a corridor of 5 m by 1 m joins to a second room with an
/// exit of 1 m: the jam is in the first room, not in the second.
Scene rimea_12() {
  Scene scene = room_to_walk("rimea-12",
                             {{0, -5},
                              {10, -5},
                              {10, -0.5},
                              {15, -0.5},
                              {15, -5},
                              {25, -5},
                              {25, -0.5},
                              {26, -0.5},
                              {26, 0.5},
                              {25, 0.5},
                              {25, 5},
                              {15, 5},
                              {15, 0.5},
                              {10, 0.5},
                              {10, 5},
                              {0, 5}},
                             240);
  scene.crowd.goals = {area_goal("exit", rectangle(25.5, -0.5, 26, 0.5))};
  scene.crowd.populations = {people_in("crowd", rectangle(0, -5, 5, 5), 150, heading_for({"exit"}))};
  return scene;
}

/// 500 people in the upper 10 m of corridors 20 m wide: straight ones as long as the corner's inner and outer walls,
/// and the corner. Its time is to lie between the two others'.
Scene rimea_15(Rimea15 geometry) {
  const bool corner = geometry == Rimea15::corner;
  const double length = geometry == Rimea15::straight_long ? 81 : corner ? 60 : 50;
  Scene scene = room_to_walk(
      corner                               ? "rimea-15-corner"
      : geometry == Rimea15::straight_long ? "rimea-15-long"
                                           : "rimea-15-short",
      corner ? Ring{{10, 0}, {30, 0}, {30, 20}, {20, 20}, {20, 60}, {0, 60}, {0, 10}} : rectangle(0, 0, 20, length),
      240);
  scene.crowd.goals = {area_goal("target", corner ? rectangle(29, 0, 30, 20) : rectangle(0, 0, 20, 1))};
  scene.crowd.populations = {people_in("crowd", rectangle(0, length - 10, 20, length), 500, heading_for({"target"}))};
  return scene;
}

}  // namespace inhabit::session
