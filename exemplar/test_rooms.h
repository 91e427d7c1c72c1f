#pragma once
#include <string>

#include "core/distributions.h"
#include "scene/scene.h"

/// For tests only: rooms with things placed by a plan.
namespace inhabit::exemplar {
using namespace scene;

inline Scene room(double width, double depth, std::string name = "room") {
  Scene scene;
  scene.name = std::move(name);
  scene.space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  return scene;
}

inline Object& place(Scene& scene, std::string kind, Vec3 size, Vec3 position, double angle) {
  Object o;
  o.id = kind + "-" + std::to_string(scene.objects.size());
  o.kind = std::move(kind), o.size = size, o.position = position, o.angle = angle;
  scene.objects.push_back(std::move(o));
  return scene.objects.back();
}

/// With the back's centre `distance` from wall k, `along` metres from its start, turned by `angle` from its normal.
inline Object& at_wall(Scene& scene, std::size_t wall, double along, std::string kind, Vec3 size, double distance = 0,
                       double angle = 0) {
  const Vec2 a = scene.space.wall_start(wall), way = unit(scene.space.wall_end(wall) - a), in = perp(way);
  const double heading = wrap_angle(angle_of(in) + angle);
  const Vec2 back = a + along * way + distance * in, p = back + 0.5 * size.y * direction(heading);
  return place(scene, std::move(kind), size, {p.x, p.y, 0}, heading);
}

}  // namespace inhabit::exemplar
