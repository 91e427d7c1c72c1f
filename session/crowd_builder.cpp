#include "session/crowd_builder.h"

#include <cmath>

namespace inhabit::session {

double neat(double metres) { return std::round(metres * 1e6) / 1e6; }

Scene room_to_walk(std::string name, Ring outline, double seconds) {
  Scene scene;
  scene.name = std::move(name);
  scene.space.outline = std::move(outline);
  scene.crowd.seconds = seconds;
  return scene;
}

Ring rectangle(double x0, double y0, double x1, double y1) {
  const double a = neat(x0), b = neat(y0), c = neat(x1), d = neat(y1);
  return {{a, b}, {c, b}, {c, d}, {a, d}};
}

Body game_body() {
  Body body;
  body.radius = {0.5, 0.5};
  body.speed = {1.4, 0.1, {}};
  return body;
}

Body pedestrian_body() {
  Body body;
  body.radius = {0.15, 0.15};
  return body;
}

PbdModel game_model(Far far) {
  PbdModel model = PbdModel::of_preset(PbdModel::Preset::game);
  model.far = static_cast<Choice>(far);
  return model;
}

Goal area_goal(std::string id, Ring area) {
  Goal goal;
  goal.id = std::move(id), goal.area = std::move(area);
  return goal;
}

Goal direction_goal(std::string id, double degrees) {
  Goal goal;
  goal.id = std::move(id), goal.direction = radians(degrees);
  return goal;
}

Route route_to(std::vector<std::string> goals) {
  Route route;
  for (std::string& goal : goals) route.legs.push_back({std::move(goal)});
  return route;
}

Population grid_of_people(std::string id, Vec2 first, int columns, int rows, double spacing, double jitter,
                          const Body& body) {
  Population people;
  static_cast<Body&>(people) = body;
  people.id = std::move(id), people.spacing = spacing, people.jitter = jitter, people.count = columns * rows;
  const Vec2 corner = first - Vec2{spacing / 2, spacing / 2};
  people.area = rectangle(corner.x, corner.y, corner.x + columns * spacing, corner.y + rows * spacing);
  return people;
}

Population people_in(std::string id, Ring area, int count, const Body& body) {
  Population people;
  static_cast<Body&>(people) = body;
  people.id = std::move(id), people.area = std::move(area), people.count = count;
  return people;
}

Source inflow(std::string id, Ring area, int count, double from, double until, const Body& body) {
  Source source;
  static_cast<Body&>(source) = body;
  source.id = std::move(id), source.area = std::move(area), source.count = count, source.from = from;
  // Four digits: what a recording's first and last entry can say.
  source.rate = std::round((count - 1) / (until - from) * 1e4) / 1e4;
  return source;
}

int people_asked(const Crowd& crowd) {
  int count = 0;
  for (const Population& people : crowd.populations) count += people.count.value_or(0);
  for (const Source& source : crowd.sources) count += source.count.value_or(0);
  return count;
}

Ring hall_with_exits(double width, double depth, const std::vector<Opening>& lower, const std::vector<Opening>& upper) {
  Ring ring = {{0, 0}};
  for (const Opening& o : lower)
    for (const Vec2 p : {Vec2{o.from, 0}, {o.from, -kExitDepth}, {o.to, -kExitDepth}, {o.to, 0}}) ring.push_back(p);
  ring.push_back({width, 0}), ring.push_back({width, depth});
  for (auto o = upper.rbegin(); o != upper.rend(); ++o)
    for (const Vec2 p :
         {Vec2{o->to, depth}, {o->to, depth + kExitDepth}, {o->from, depth + kExitDepth}, {o->from, depth}})
      ring.push_back(p);
  ring.push_back({0, depth});
  return ring;
}

}  // namespace inhabit::session
