#include "session/room_plan.h"

#include <algorithm>
#include <cmath>

namespace inhabit::session {
namespace {

constexpr double kAlong = 0.02, kAside = 0.03, kTurned = 2;  // metres, metres, degrees

/// A millimetre and a hundredth of a degree are as exact as a room is furnished.
double tidy(double v) { return std::round(v * 1e3) / 1e3; }
double tidy_angle(double degrees) { return radians(std::round(degrees * 100) / 100); }

}  // namespace

Ring rectangle(double width, double depth) { return {{0, 0}, {width, 0}, {width, depth}, {0, depth}}; }

RoomPlan::RoomPlan(std::string name, Ring outline, double height, std::uint64_t seed, bool loose)
    : rng_(seed, 0x726f6f6d), loose_(loose) {
  scene_.name = std::move(name);
  scene_.space.outline = std::move(outline);
  scene_.space.height = height;
}

void RoomPlan::door(std::string id, int wall, double from, double width, Door::Hinge hinge) {
  Door door;
  door.id = std::move(id), door.wall = wall, door.from = tidy(from), door.width = width, door.hinge = hinge;
  scene_.space.doors.push_back(std::move(door));
}

void RoomPlan::window(int wall, double from, double width, double sill, double window_height) {
  const std::string id = numbered("window", scene_.space.windows.size() + 1);
  scene_.space.windows.push_back({id, wall, tidy(from), width, sill, window_height, {}});
}

void RoomPlan::pillar(Vec2 center, double side) {
  const double h = side / 2, x = tidy(center.x), y = tidy(center.y);
  scene_.space.holes.push_back({numbered("pillar", scene_.space.holes.size() + 1),
                                {{x - h, y - h}, {x + h, y - h}, {x + h, y + h}, {x - h, y + h}},
                                {}});
}

Ref RoomPlan::put(Vec3 position, double heading, std::string kind, Vec3 size) {
  std::string stem = kind;
  std::ranges::replace(stem, ' ', '-');
  Object object;
  object.id = numbered(stem, ++numbers_[kind]);
  object.kind = std::move(kind), object.size = size;
  object.position = Vec3{tidy(position.x), tidy(position.y), tidy(position.z)};
  object.angle = wrap_angle(tidy_angle(heading));
  return add_object(scene_, std::move(object));
}

double RoomPlan::wall_length(std::size_t wall) const {
  return length(scene_.space.wall_end(wall) - scene_.space.wall_start(wall));
}

Ref RoomPlan::wall(std::size_t wall, double along, std::string kind, Vec3 size, double gap) {
  const Vec2 a = scene_.space.wall_start(wall), way = unit(scene_.space.wall_end(wall) - a);
  const Vec2 p = a + (along + off(kAlong)) * way + (gap + size.y / 2) * perp(way);
  return put({p.x, p.y, 0}, degrees(angle_of(perp(way))), std::move(kind), size);
}

Ref RoomPlan::hang(std::size_t wall_number, double along, std::string kind, Vec3 size, double height) {
  const Ref ref = wall(wall_number, along, std::move(kind), size, 0);
  of(ref).position->z = height;
  of(ref).mount = Mount::wall;
  return ref;
}

Ref RoomPlan::stand(Vec2 p, double heading, std::string kind, Vec3 size) {
  return put({p.x + off(kAside), p.y + off(kAside), 0}, heading + off(kTurned), std::move(kind), size);
}

Ref RoomPlan::near(Ref other, Vec2 offset, double turn, std::string kind, Vec3 size) {
  const Object& o = of(other);
  const Vec2 front = direction(*o.angle);
  const Vec2 p = o.position->xy() - offset.x * perp(front) + offset.y * front;
  return stand(p, degrees(*o.angle) + turn, std::move(kind), size);
}

Ref RoomPlan::on(Ref carrier, Vec2 offset, double turn, std::string kind, Vec3 size) {
  const Object& o = of(carrier);
  const Vec2 front = direction(*o.angle);
  const Vec2 p = o.position->xy() - offset.x * perp(front) + offset.y * front;
  const double top = o.position->z + o.size.z;
  const Ref ref = put({p.x, p.y, top}, degrees(*o.angle) + turn + off(kTurned), std::move(kind), size);
  of(ref).on = carrier;
  return ref;
}

void RoomPlan::round(Ref center, int count, double distance, std::string kind, Vec3 size, double first) {
  for (int k = 0; k < count; ++k) {
    const double bearing = first + 360.0 * k / count;
    // Right of the heading is at -90 degrees.
    const Vec2 way = direction(wrap_angle(radians(bearing)));
    near(center, {-distance * way.y, distance * way.x}, bearing + 180, kind, size);
  }
}

void RoomPlan::view(Ref ref, double distance, double angle) { of(ref).view = View{distance, radians(angle)}; }

Scene RoomPlan::done(bool in_mirror) const { return in_mirror ? mirrored(scene_) : scene_; }

Scene mirrored(Scene scene) {
  Space& space = scene.space;
  const std::size_t n = space.walls();
  const double right = bounds(space.outline).max.x, left = bounds(space.outline).min.x;
  const auto flip = [&](Vec2 p) { return Vec2{tidy(left + right - p.x), p.y}; };
  const auto flip_ring = [&](Ring& ring) {
    for (Vec2& p : ring) p = flip(p);
    std::reverse(ring.begin(), ring.end());
  };
  const auto flip_opening = [&](auto& opening) {
    const auto k = static_cast<std::size_t>(opening.wall);
    opening.from = tidy(length(space.wall_end(k) - space.wall_start(k)) - opening.from - opening.width);
    opening.wall = static_cast<int>((2 * n - 2 - k) % n);
  };
  for (Door& door : space.doors) {
    flip_opening(door);
    door.hinge = door.hinge == Door::Hinge::start ? Door::Hinge::end : Door::Hinge::start;
  }
  for (Window& window : space.windows) flip_opening(window);
  flip_ring(space.outline);
  for (Hole& hole : space.holes) flip_ring(hole.outline);
  for (Object& object : scene.objects) {
    if (object.position) {
      const Vec2 p = flip(object.position->xy());
      object.position = Vec3{p.x, p.y, object.position->z};
    }
    if (object.angle) object.angle = wrap_angle(kPi - *object.angle);
  }
  return scene;
}

}  // namespace inhabit::session
