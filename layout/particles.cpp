#include "layout/particles.h"

namespace inhabit::layout {

void State::place(std::uint32_t body, Vec2 p, double angle, Vec2 front) {
  const BodyData& b = data->bodies[body];
  bodies[body] = {p, front, angle};
  for (std::uint32_t k = b.first_box; k < b.first_box + b.boxes; ++k) {
    const BoxData& d = data->boxes[k];
    Box& box = boxes[k];
    box.half_depth = d.half_depth, box.half_width = d.half_width;
    box.center = p + rotate(d.offset, front);
    box.front = d.turn == 0 ? front : rotate(direction(d.turn), front);
  }
}

Vec2 State::group_position(std::uint32_t group) const {
  Vec2 sum;
  double mass = 0;
  for (const std::uint32_t b : data->groups[group].bodies) {
    sum += data->bodies[b].mass * bodies[b].p;
    mass += data->bodies[b].mass;
  }
  return mass > 0 ? (1 / mass) * sum : Vec2{};
}

void State::shift_group(std::uint32_t group, Vec2 d) {
  for (const std::uint32_t b : data->groups[group].bodies) {
    if (data->bodies[b].w > 0) shift(b, d);
  }
  frames[group].p += d;
}

void State::turn_group(std::uint32_t group, double by) {
  const Vec2 center = group_position(group), r = direction(by);
  for (const std::uint32_t b : data->groups[group].bodies) {
    const BodyData& body = data->bodies[b];
    const Vec2 p = body.w > 0 ? center + rotate(bodies[b].p - center, r) : bodies[b].p;
    place(b, p, body.turns ? wrap_angle(bodies[b].angle + by) : bodies[b].angle);
  }
  Pose& frame = frames[group];
  frame.p = center + rotate(frame.p - center, r);
  frame.angle = wrap_angle(frame.angle + by);
}

}  // namespace inhabit::layout
