#pragma once
#include "scene/scene.h"

/// Short words for scenes with people, for tests.
namespace inhabit::crowd {
using namespace geometry;

inline scene::Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline scene::Route to(std::string goal) { return {{{std::move(goal)}}}; }

inline scene::Goal goal_of(std::string id, scene::Ring area) {
  scene::Goal goal;
  goal.id = std::move(id), goal.area = std::move(area);
  return goal;
}

inline scene::Population grid_of(std::string id, scene::Ring area, double spacing, std::string goal = "") {
  scene::Population people;
  people.id = std::move(id), people.area = std::move(area), people.spacing = spacing;
  if (!goal.empty()) people.goal = to(std::move(goal));
  return people;
}

inline scene::Source source_of(std::string id, scene::Ring area, double rate, std::string goal = "") {
  scene::Source source;
  source.id = std::move(id), source.area = std::move(area), source.rate = rate;
  if (!goal.empty()) source.goal = to(std::move(goal));
  return source;
}

inline scene::Object thing_of(std::string kind, Vec3 size, Vec3 position) {
  scene::Object object;
  object.id = kind, object.kind = std::move(kind), object.size = size, object.position = position, object.angle = 0;
  return object;
}

/// An empty room with a corner at the origin.
inline scene::Scene room_of(double width, double depth) {
  scene::Scene scene;
  scene.space.outline = rectangle(0, 0, width, depth);
  return scene;
}

}  // namespace inhabit::crowd
