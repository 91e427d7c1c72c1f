#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "crowd/planner.h"

/// For tests only: worlds and people made by hand.
namespace inhabit::crowd {

inline Ring box_ring(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

inline Ring turned(Ring ring, double angle) {
  for (Vec2& p : ring) p = rotate(p, direction(angle));
  return ring;
}

inline World test_world(std::vector<Floor> floors, Vec2 origin = {}) {
  World world;
  world.origin = origin;
  world.floors = std::move(floors);
  if (!world.floors.empty()) world.walls = Walls(world.floors, origin, 1);
  return world;
}

inline scene::Goal area_goal(Ring area, std::string id = "goal") {
  scene::Goal goal;
  goal.id = std::move(id);
  goal.area = std::move(area);
  return goal;
}

/// A scene with these goals and one route, through all of them one after the other.
inline scene::Scene scene_with(std::vector<scene::Goal> goals, scene::Planner planner) {
  scene::Scene scene;
  scene.crowd.goals = std::move(goals);
  scene.crowd.planner = planner;
  return scene;
}

inline std::size_t add_agent(Agents& agents, Vec2 p, double radius = 0.25, double speed = 1.4) {
  const std::size_t i = agents.add();
  agents.x[i] = static_cast<float>(p.x), agents.y[i] = static_cast<float>(p.y);
  agents.radius[i] = static_cast<float>(radius), agents.mass[i] = 1;
  agents.preferred_speed[i] = static_cast<float>(speed), agents.maximum_speed[i] = static_cast<float>(1.3 * speed);
  agents.id[i] = static_cast<std::uint32_t>(i);
  return i;
}

struct Walk {
  bool arrived = false, crossed = false;  ///< crossed: left the floor
  double length = 0;
  Vec2 end;
};
/// Agent 0 moves by its wish, step by step, until it arrives or `seconds` are over.
inline Walk walk(Planner& planner, const World& world, Agents& agents, double seconds, double dt = 1.0 / 48) {
  Walk w;
  for (double t = 0; t < seconds && !w.arrived; t += dt) {
    planner.aim(agents, 1);
    agents.x[0] += static_cast<float>(dt) * agents.wish_x[0], agents.y[0] += static_cast<float>(dt) * agents.wish_y[0];
    w.length += dt * std::hypot(agents.wish_x[0], agents.wish_y[0]);
    w.crossed = w.crossed || !world.walls.on_floor(agents.x[0], agents.y[0]);
    w.arrived = planner.arrived(agents, 0);
  }
  w.end = {agents.x[0], agents.y[0]};
  return w;
}

}  // namespace inhabit::crowd
