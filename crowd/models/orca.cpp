#include "crowd/models/orca.h"

#include "crowd/models/velocity_obstacle.h"

namespace inhabit::crowd {
namespace {

using End = VelocityObstacle::End;

/// Cells in the reach of an agent.
constexpr double kCells = 6;

/// What the end of wall `s` at `at` is for somebody at p: looks for the segment that begins (or ends) there.
/// `backwards`: the segment before s instead of the one after it.
End end_of(const Walls& walls, const WallSegment& s, Vec2 p, bool backwards) {
  const Vec2 a{s.ax, s.ay}, b{s.bx, s.by}, joint = backwards ? a : b;
  for (const std::uint32_t k : walls.near(static_cast<float>(p.x), static_cast<float>(p.y))) {
    const WallSegment& other = walls.segments()[k];
    const Vec2 from{other.ax, other.ay}, to{other.bx, other.by};
    if ((backwards ? to : from) != joint || from == to) continue;
    if (cross(to - from, p - from) < 0) return End::free;  // it faces away: here the wall ends for p
    const double turn = backwards ? cross(to - from, b - a) : cross(b - a, to - from);
    return turn >= 0 ? End::corner : End::closed;  // to the left, where the floor is: the corner of a room
  }
  return End::free;
}

}  // namespace

HalfPlane orca_half_plane(Vec2 x, Vec2 v, Vec2 v_A, double r, double tau, double dt, double share, Vec2 aside) {
  BorderPoint border;
  if (dot(x, x) > r * r) {
    border = nearest_border(x, r, tau, v);
  } else {
    const Vec2 w = v - (1 / dt) * x;
    border.normal = w != Vec2{} ? unit(w) : x != Vec2{} ? -unit(x) : aside;
    border.point = (1 / dt) * (x + r * border.normal);
  }
  const Vec2 u = border.point - v;
  return {border.normal, dot(border.normal, v_A + share * u)};
}

void append_wall_half_planes(const Walls& walls, Vec2 p, Vec2 v, double radius, double tau, double longest,
                             std::vector<HalfPlane>& planes) {
  walls.for_each_near(static_cast<float>(p.x), static_cast<float>(p.y), [&](const WallSegment& s, std::uint32_t) {
    const Vec2 a = Vec2{s.ax, s.ay} - p, b = Vec2{s.bx, s.by} - p;
    if (a == b || cross(b - a, -a) < 0) return;
    const Vec2 nearest = nearest_on_segment(a, b, {});
    const double distance = length(nearest);
    if (distance - radius > tau * longest) return;
    if (distance <= radius * (1 + 1e-6)) {
      planes.push_back({distance > 0 ? (-1 / distance) * nearest : unit(perp(b - a)), 0});
      return;
    }
    const auto border = nearest_border({a, b, radius, tau, end_of(walls, s, p, true), end_of(walls, s, p, false)}, v);
    if (border) planes.push_back({border->normal, dot(border->normal, border->point)});
  });
}

Vec2 Orca::next_velocity(const Agents& agents, std::size_t i, const Surroundings& around, Workspace& work) const {
  const Vec2 p = position(agents, i), v = velocity(agents, i);
  const double radius = agents.radius[i], longest = agents.maximum_speed[i];
  work.planes.clear();
  append_wall_half_planes(around.walls, p, v, radius, parameters_.wall_horizon, longest, work.planes);
  const std::size_t hard = work.planes.size();
  for (const Neighbour& near :
       work.nearest.find(grid_, agents, i, static_cast<float>(parameters_.range), parameters_.neighbours)) {
    const std::size_t j = near.index;
    const double share = agents.mass[j] / (static_cast<double>(agents.mass[i]) + agents.mass[j]);
    const Vec2 aside{agents.id[i] < agents.id[j] ? -1.0 : 1.0, 0};
    work.planes.push_back(orca_half_plane(position(agents, j) - p, v - velocity(agents, j), v,
                                          radius + agents.radius[j], parameters_.horizon, around.dt, share, aside));
  }
  return work.programme.solve(work.planes, hard, wish(agents, i), longest);
}

void Orca::step(Agents& agents, const Surroundings& around) {
  sort_by_cell(agents, grid_, static_cast<float>(parameters_.range / kCells), around.threads);
  next_.resize(agents.size());
  for_each_block(agents.size(), around.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    Workspace work;
    for (std::size_t i = begin; i < end; ++i)
      next_.set(agents, i, next_velocity(agents, i, around, work), around.walls, around.dt);
  });
  next_.begin(agents);
}

}  // namespace inhabit::crowd
