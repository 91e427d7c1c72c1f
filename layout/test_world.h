#pragma once
#include <memory>

#include "core/rng.h"
#include "layout/constraint.h"

/// For tests only: a room, and particles put into it one by one.
namespace inhabit::layout::testing {

inline Ring rectangle(double width, double depth) { return {{0, 0}, {width, 0}, {width, depth}, {0, depth}}; }
/// 12 m2; its area's centroid is (5/3, 5/3), the mean of its corners (2, 2); corner 3 at (2, 2) is reflex.
inline Ring l_shape() { return {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}; }

class World {
  std::unique_ptr<Room> room_;
  std::unique_ptr<Bodies> data_;

 public:
  State x;

  explicit World(const Ring& outline = rectangle(10, 10), const std::vector<Ring>& holes = {})
      : room_(std::make_unique<Room>(outline, holes)), data_(std::make_unique<Bodies>()), x(*data_, *room_) {}

  const Room& room() const { return *room_; }
  Bodies& data() { return *data_; }

  /// A particle that carries one box of `size` (width across the front, depth, height).
  Anchor add(Vec2 p, double angle = 0, double mass = 1, Vec3 size = {1, 1, 1}) {
    const auto body = static_cast<std::uint32_t>(data_->bodies.size());
    BodyData d;
    d.mass = mass, d.w = 1 / mass, d.turns = true, d.first_box = body, d.boxes = 1;
    BoxData b;
    b.body = b.object = body;
    b.half_depth = size.y / 2, b.half_width = size.x / 2, b.high = size.z;
    b.radius = d.radius = length({b.half_depth, b.half_width});
    data_->bodies.push_back(d), data_->boxes.push_back(b);
    x.bodies.emplace_back(), x.boxes.emplace_back();
    x.place(body, p, angle);
    return {body};
  }
  void pin(const Anchor& a) { data_->bodies[a.body].w = 0, data_->bodies[a.body].turns = false; }
  /// A place that rides on a particle.
  Anchor ride(const Anchor& a, Vec2 offset, double turn) {
    data_->riders.push_back({offset, turn});
    return {a.body, static_cast<std::uint32_t>(data_->riders.size() - 1)};
  }
  /// A group that is not rigid.
  Anchor group(const std::vector<Anchor>& members) {
    GroupData g;
    for (const Anchor& m : members) g.bodies.push_back(m.body), g.mass += data_->bodies[m.body].mass;
    g.w = 1 / g.mass;
    data_->groups.push_back(g);
    x.frames.emplace_back();
    return {static_cast<std::uint32_t>(data_->groups.size() - 1) | Anchor::kGroup};
  }
};

/// The state after one projection.
template <class T>
State projected(const T& term, State x, double k = 1) {
  Direct sink{x};
  project(term, static_cast<const State&>(x), k, sink);
  return x;
}

/// The largest change of any particle: metres or radians.
inline double change(const State& before, const State& after) {
  double most = 0;
  for (std::size_t i = 0; i < before.bodies.size(); ++i) {
    most = std::max(most, length(after.bodies[i].p - before.bodies[i].p));
    most = std::max(most, std::abs(wrap_angle(after.bodies[i].angle - before.bodies[i].angle)));
  }
  return most;
}

inline double distance(Vec2 a, Vec2 b) { return length(a - b); }

}  // namespace inhabit::layout::testing
