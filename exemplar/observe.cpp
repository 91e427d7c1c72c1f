#include "exemplar/observe.h"

#include <algorithm>
#include <cmath>

#include "scene/kind.h"

namespace inhabit::exemplar {
namespace {

constexpr double kOutside = 0.1;  // a mirror sunk into the wall is still in the room
constexpr double kRaySpacing = 0.05;

bool has_trait(const Thing& thing, KindTrait trait) {
  const KindRow* row = find_kind(kind_of(thing.kind));
  return row != nullptr && row->trait == trait;
}

std::string named(const Object& object) { return object.id.empty() ? object.name : object.id; }

/// Why an object teaches nothing; empty when it does.
std::string why_skipped(const Object& o, const Scene& scene, const std::string& kind) {
  if (!o.position || !o.angle) return "has no place";
  const Vec3 p = *o.position;
  if (!std::isfinite(p.x + p.y + p.z + *o.angle)) return "stands nowhere: its place is no number";
  if (!(o.size.x > 0 && o.size.y > 0 && o.size.z > 0)) return "has no size";
  if (kind.empty()) return "has neither kind nor name";
  if (!contains(scene.space.outline, p.xy()) && nearest_on_ring(scene.space.outline, p.xy()).distance > kOutside)
    return "stands outside the room";
  return "";
}

/// Where the ray from p along the unit vector d first meets the segment; kLookDepth when it does not before.
double ray_to_segment(Vec2 p, Vec2 d, Vec2 a, Vec2 b) {
  const Vec2 e = b - a;
  const double det = cross(d, e);
  if (std::abs(det) < 1e-12) return kLookDepth;
  const double t = cross(a - p, e) / det, s = cross(a - p, d) / det;
  return t >= -1e-9 && s >= -1e-9 && s <= 1 + 1e-9 ? std::min(std::max(t, 0.0), kLookDepth) : kLookDepth;
}

double ray_to_ring(Vec2 p, Vec2 d, std::span<const Vec2> ring) {
  double nearest = kLookDepth;
  for (std::size_t k = 0; k < ring.size(); ++k)
    nearest = std::min(nearest, ray_to_segment(p, d, ring[k], ring[(k + 1) % ring.size()]));
  return nearest;
}

/// What stands in the way of somebody at the thing: lower than a person, higher than a step, neither below nor on it.
bool in_the_way(const Thing& other, const Thing& thing) {
  if (other.flat || other.size.z < kStep) return false;
  return other.base < std::max(thing.top(), kAdultHeight) && other.top() > thing.base + kStep;
}

class RoomObserver {
 public:
  RoomObserver(const Scene& scene, int room) : scene_(scene), room_(room) {}

  Observed run() {
    carrier_.assign(scene_.objects.size(), -1);
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) add(i);
    for (Thing& thing : out_.things) find_support(thing);
    for (Thing& thing : out_.things) look_around(thing);
    return std::move(out_);
  }

 private:
  void add(std::uint32_t index) {
    const Object& o = scene_.objects[index];
    Thing thing;
    thing.kind = prior_kind(o);
    if (has_trait(thing, KindTrait::building) || thing.kind == "door" || thing.kind == "window") return;
    if (const std::string why = why_skipped(o, scene_, thing.kind); !why.empty()) {
      out_.skipped.push_back(named(o) + " " + why);
      return;
    }
    thing.room = room_, thing.object = index;
    thing.pose = {o.position->xy(), wrap_angle(*o.angle)};
    thing.size = o.size, thing.base = o.position->z;
    thing.mount = o.mount, thing.view = o.view;
    thing.flat = has_trait(thing, KindTrait::flat);
    out_.things.push_back(std::move(thing));
  }

  /// What the scene says carries it, else the thing whose top its base touches and whose footprint it shares most with.
  void find_support(Thing& thing) {
    const Object& o = scene_.objects[thing.object];
    if (o.on.kind == Ref::Kind::object) {
      thing.on = prior_kind(scene_.objects[o.on.index]);
      carrier_[thing.object] = static_cast<int>(o.on.index);
      return;
    }
    if (thing.mount != Mount::floor || thing.base <= kTouch) return;
    double most = 0;
    for (const Thing& below : out_.things) {
      if (&below == &thing || below.flat || below.base >= thing.base) continue;
      const double shared = overlap_area(thing.box(), below.box());
      if (std::abs(thing.base - below.top()) > kTouch || shared <= most || shared < 0.2 * thing.box().area()) continue;
      most = shared, thing.on = below.kind, carrier_[thing.object] = static_cast<int>(below.object);
    }
    if (!thing.on.empty()) return;
    // Above the floor and on nothing: it hangs. The ceiling has what is up there, or far from walls.
    const bool high = thing.top() > scene_.space.height - 0.1;
    const double wall = nearest_on_ring(scene_.space.outline, thing.pose.p).distance;
    if (wall <= thing.box().radius() + kAtWall)
      thing.mount = Mount::wall;
    else if (high)
      thing.mount = Mount::ceiling;
  }

  void look_around(Thing& thing) {
    near_.clear();
    for (const Thing& other : out_.things) {
      const double reach = thing.box().radius() + other.box().radius() + kLookDepth;
      if (&other == &thing || length(other.pose.p - thing.pose.p) > reach) continue;
      if (!bound(thing.object, other.object) && in_the_way(other, thing)) near_.push_back(other.box());
    }
    for (std::size_t f = 0; f < thing.faces.size(); ++f) {
      const Face face = static_cast<Face>(f);
      FaceSeen& seen = thing.faces[f];
      const Vec2 center = face_center(thing.pose, thing.size, face), out = face_normal(thing.pose, face);
      const Nearest nearest = nearest_on_ring(scene_.space.outline, center);
      seen.wall = contains(scene_.space.outline, center) ? nearest.distance : -nearest.distance;
      const double width = 0.9 * (f % 2 == 0 ? thing.size.x : thing.size.y);
      const double to_wall = swept(center, out, width, [&](Vec2 p) { return to_walls(p, out); });
      const double to_thing = swept(center, out, width, [&](Vec2 p) { return to_things(p, out); });
      seen.free = std::min(to_wall, to_thing);
      seen.at_wall = seen.wall < kAtWall && to_wall <= std::max(to_thing, kAtWall);
    }
  }

  /// The least of `depth` over rays side by side.
  template <class F>
  static double swept(Vec2 center, Vec2 out, double width, F depth) {
    const int rays = 1 + static_cast<int>(std::ceil(std::min(width, 50.0) / kRaySpacing));
    double least = kLookDepth;
    for (int k = 0; k <= rays; ++k)
      least = std::min(least, depth(center + (width * (static_cast<double>(k) / rays - 0.5)) * perp(out)));
    return least;
  }
  double to_walls(Vec2 p, Vec2 d) const {
    if (!contains(scene_.space.outline, p)) return 0;
    double depth = ray_to_ring(p, d, scene_.space.outline);
    for (const Hole& hole : scene_.space.holes) depth = std::min(depth, ray_to_ring(p, d, hole.outline));
    return depth;
  }
  double to_things(Vec2 p, Vec2 d) const {
    double depth = kLookDepth;
    for (const Box& box : near_) {
      if (box.contains(p)) return 0;
      const auto corners = box.corners();
      depth = std::min(depth, ray_to_ring(p, d, corners));
    }
    return depth;
  }
  bool bound(std::uint32_t a, std::uint32_t b) const {
    return carrier_[a] == static_cast<int>(b) || carrier_[b] == static_cast<int>(a);
  }

  const Scene& scene_;
  int room_;
  Observed out_;
  std::vector<int> carrier_;
  std::vector<Box> near_;  ///< what the thing that looks around may see
};

}  // namespace

Vec2 face_normal(const Pose& pose, Face face) {
  const Vec2 front = direction(pose.angle);
  switch (face) {
    case Face::back:
      return -front;
    case Face::left:
      return perp(front);
    case Face::front:
      return front;
    case Face::right:
      break;
  }
  return -perp(front);
}

Vec2 face_center(const Pose& pose, Vec3 size, Face face) {
  const double half = (face == Face::back || face == Face::front ? size.y : size.x) / 2;
  return pose.p + half * face_normal(pose, face);
}

Observed observe(const Scene& scene, int room) { return RoomObserver(scene, room).run(); }

}  // namespace inhabit::exemplar
