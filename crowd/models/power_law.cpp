#include "crowd/models/power_law.h"

#include <cmath>

#include "crowd/neighbours.h"

namespace inhabit::crowd {
namespace {

/// Cells in the reach of an agent.
constexpr double kCells = 3;

void keep_sooner(std::optional<Encounter>& first, const std::optional<Encounter>& other) {
  if (other && (!first || other->time < first->time)) first = other;
}

}  // namespace

std::optional<Encounter> encounter(Vec2 x, Vec2 v, double R) {
  const double a = dot(v, v), b = -dot(x, v), c = dot(x, x) - R * R, d = b * b - a * c;
  if (!(b > 0) || !(c > 0) || !(d > 0)) return std::nullopt;
  const double root = std::sqrt(d);
  const double tau = c / (b + root);  // = (b - root) / a, without the difference of nearly equal numbers
  return Encounter{tau, (1 / root) * (x + tau * v)};
}

std::optional<Encounter> encounter(Vec2 p, Vec2 v, double r, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double l = length(along);
  if (l == 0 || cross(along, p - a) < 0) return std::nullopt;
  std::optional<Encounter> first;
  const Vec2 n = (1 / l) * perp(along);
  const double height = dot(n, p - a), speed = -dot(n, v);
  if (speed > 0 && height > r) {
    const double tau = (height - r) / speed, at = dot(along, p + tau * v - a);
    if (at >= 0 && at <= l * l) first = Encounter{tau, (1 / speed) * n};
  }
  keep_sooner(first, encounter(p - a, v, r));
  keep_sooner(first, encounter(p - b, v, r));
  return first;
}

double power_law_energy(const scene::PowerLawModel& model, double tau) {
  return model.strength / (tau * tau) * std::exp(-tau / model.horizon);
}

Vec2 power_law_force(const scene::PowerLawModel& model, const Encounter& encounter) {
  return power_law_energy(model, encounter.time) * (2 / encounter.time + 1 / model.horizon) * encounter.gradient;
}

Vec2 PowerLaw::next_velocity(const Agents& agents, std::size_t i, const Surroundings& around) const {
  const Vec2 p = position(agents, i), v = velocity(agents, i);
  const float radius = agents.radius[i], vx = agents.vx[i], vy = agents.vy[i], mass = agents.mass[i];
  Vec2 force;
  for_each_within(grid_, agents, i, static_cast<float>(parameters_.range),
                  [&](std::uint32_t j, float dx, float dy, float) {
                    const float ux = vx - agents.vx[j], uy = vy - agents.vy[j];
                    if (!(dx * ux + dy * uy < 0)) return;  // most pairs only go apart
                    const auto meeting = encounter(Vec2{dx, dy}, Vec2{ux, uy}, radius + agents.radius[j]);
                    if (!meeting) return;
                    const float share = 2 * agents.mass[j] / (mass + agents.mass[j]);
                    force += share * power_law_force(parameters_, *meeting);
                  });
  std::optional<Encounter> first;
  around.walls.for_each_near(agents.x[i], agents.y[i], [&](const WallSegment& s, std::uint32_t) {
    keep_sooner(first, encounter(p, v, radius, Vec2{s.ax, s.ay}, Vec2{s.bx, s.by}));
  });
  if (first) force += power_law_force(parameters_, *first);
  const double dt = around.dt, blend = -std::expm1(-dt / parameters_.relaxation_time);
  return v + blend * (wish(agents, i) - v) + dt * limited(force, parameters_.maximum_acceleration);
}

void PowerLaw::step(Agents& agents, const Surroundings& around) {
  sort_by_cell(agents, grid_, static_cast<float>(parameters_.range / kCells), around.threads);
  next_.resize(agents.size());
  for_each_block(agents.size(), around.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      next_.set(agents, i, next_velocity(agents, i, around), around.walls, around.dt);
  });
  next_.begin(agents);
}

}  // namespace inhabit::crowd
