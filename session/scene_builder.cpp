#include "session/scene_builder.h"

#include <algorithm>

namespace inhabit::session {

Space rectangular_space(double width, double depth, double height) {
  Space space;
  space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  space.height = height;
  return space;
}

std::string numbered(std::string_view kind, std::size_t number) {
  std::string id(kind);
  id += '-';
  id += std::to_string(number);
  return id;
}

Ref add_object(Scene& scene, Object object) {
  scene.objects.push_back(std::move(object));
  return {Ref::Kind::object, static_cast<std::uint32_t>(scene.objects.size() - 1)};
}

Ref add_object(Scene& scene, std::string id, std::string kind, Vec3 size, Clearance clearance) {
  Object object;
  object.id = std::move(id);
  object.kind = std::move(kind);
  object.size = size;
  object.clearance = clearance;
  return add_object(scene, std::move(object));
}

Ref add_group(Scene& scene, Group group) {
  scene.groups.push_back(std::move(group));
  return {Ref::Kind::group, static_cast<std::uint32_t>(scene.groups.size() - 1)};
}

void keep_distance(Scene& scene, Ref a, Ref b, double distance) {
  Distance c;
  c.between = {a, b};
  c.distance = distance;
  scene.constraints.add(c);
}

void keep_apart(Scene& scene, Ref a, Ref b, double min) {
  Distance c;
  c.between = {a, b};
  c.min = min;
  scene.constraints.add(c);
}

void gather_round(Scene& scene, Ref focal, std::vector<Ref> members, double distance, bool fixed) {
  FocalDistance c;
  c.focal = focal;
  c.members = list_of(std::move(members));
  c.distance = distance;
  c.focal_fixed = fixed;
  scene.constraints.add(std::move(c));
}

void centre_at(Scene& scene, std::vector<Ref> members, Vec2 point) {
  HeatPoint c;
  c.members = list_of(std::move(members));
  c.point = point;
  scene.constraints.add(std::move(c));
}

void look_at(Scene& scene, std::vector<Ref> members, Ref to) {
  Orientation c;
  c.members = list_of(std::move(members));
  c.to = to;
  scene.constraints.add(std::move(c));
}

void run_parallel(Scene& scene, std::vector<Ref> members, Ref to, double angle) {
  Orientation c;
  c.members = list_of(std::move(members));
  c.to = to;
  c.angle = angle;
  c.relative = 1;
  scene.constraints.add(std::move(c));
}

void stand_at_wall(Scene& scene, std::vector<Ref> members, double distance, std::optional<int> wall) {
  WallDistance c;
  c.members = list_of(std::move(members));
  c.distance = distance;
  c.wall = wall;
  scene.constraints.add(std::move(c));
}

void turn_from_wall(Scene& scene, std::vector<Ref> members, double angle, std::optional<int> wall) {
  WallOrientation c;
  c.members = list_of(std::move(members));
  c.angle = angle;
  c.wall = wall;
  scene.constraints.add(std::move(c));
}

void stack(Scene& scene, Ref upper, Ref on) {
  Stacking c;
  c.object = upper;
  c.on = on;
  scene.constraints.add(c);
}

double floor_coverage(const Scene& scene) {
  std::vector<bool> carried(scene.objects.size(), false);
  for (const Stacking& c : scene.constraints.of<Stacking>())
    if (c.object.kind == Ref::Kind::object) carried[c.object.index] = true;
  double used = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& o = scene.objects[i];
    if (!carried[i] && o.on.none() && o.mount == Mount::floor) used += o.size.x * o.size.y;
  }
  double floor = signed_area(scene.space.outline);
  for (const Hole& hole : scene.space.holes) floor -= signed_area(hole.outline);
  return used / floor;
}

}  // namespace inhabit::session
