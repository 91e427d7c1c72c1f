#include "crowd/models/social_force.h"

#include <cmath>

#include "crowd/neighbours.h"
#include "crowd/wall_contacts.h"

namespace inhabit::crowd {
namespace {

/// Gaps, in B, beyond which floats lose a push beside that of people who touch: ln(2^24).
constexpr double kFar = 17;
/// Overlaps, in B, beyond which the push grows no more.
constexpr double kDeep = 50;

/// The sums of a sub-step: the elastic force, and friction as the symmetric matrix sum grip t t^T and the vector
/// sum grip (u.t) t, u the velocity of what is touched.
struct Forces {
  Vec2 push, drag;
  double xx = 0, xy = 0, yy = 0;

  void add(SocialForceContact contact, Vec2 n, Vec2 u) {
    push += contact.push * n;
    if (contact.grip == 0) return;
    const Vec2 t = perp(n);
    drag += contact.grip * dot(u, t) * t;
    xx += contact.grip * t.x * t.x, xy += contact.grip * t.x * t.y, yy += contact.grip * t.y * t.y;
  }

  /// Solves (1 + s M) v' = v + s (push + drag). The matrix is symmetric and its eigenvalues are at least 1.
  Vec2 advance(Vec2 v, double s) const {
    const Vec2 r = v + s * (push + drag);
    const double a = 1 + s * xx, b = s * xy, c = 1 + s * yy, determinant = a * c - b * b;
    return {(c * r.x - b * r.y) / determinant, (a * r.y - b * r.x) / determinant};
  }
};

}  // namespace

SocialForceContact social_force_contact(const scene::SocialForceModel& model, double gap) {
  const double depth = std::max(-gap, 0.0);
  return {model.repulsion * std::exp(std::min(-gap / model.repulsion_range, kDeep)) + model.body * depth,
          model.friction * depth};
}

void SocialForce::find_neighbours(const Agents& agents, std::size_t block, std::size_t begin, std::size_t end,
                                  float skin, float widest) {
  Lists& lists = lists_[block];
  lists.first.assign(1, 0), lists.items.clear();
  for (std::size_t i = begin; i < end; ++i) {
    const float mine = agents.radius[i] + skin;
    for_each_within(grid_, agents, i, mine + widest, [&](std::uint32_t j, float, float, float d2) {
      const float reach = mine + agents.radius[j];
      if (d2 <= reach * reach) lists.items.push_back(j);
    });
    lists.first.push_back(static_cast<std::uint32_t>(lists.items.size()));
  }
}

Vec2 SocialForce::next_velocity(const Agents& agents, std::size_t i, std::span<const std::uint32_t> near,
                                const Walls& walls, double h) const {
  const Vec2 p = position(agents, i), v = velocity(agents, i);
  const double radius = agents.radius[i];
  const double far = std::min(parameters_.range, kFar * parameters_.repulsion_range);
  Forces forces;
  for (const std::uint32_t j : near) {
    const Vec2 apart = p - position(agents, j);
    const double distance = length(apart), gap = distance - (radius + agents.radius[j]);
    if (gap > far) continue;
    // Two in the same place part along x, by number.
    const Vec2 n = distance > 0 ? (1 / distance) * apart : Vec2{agents.id[i] < agents.id[j] ? -1.0 : 1.0, 0};
    forces.add(social_force_contact(parameters_, gap), n, velocity(agents, j));
  }
  for_each_facing_wall(walls, agents.x[i], agents.y[i], [&](Vec2 point) {
    const Vec2 apart = p - point;
    const double distance = length(apart), gap = distance - radius;
    if (gap <= far && distance > 0) forces.add(social_force_contact(parameters_, gap), (1 / distance) * apart, Vec2{});
  });
  const double blend = -std::expm1(-h / parameters_.relaxation_time);
  const double mass = parameters_.person_mass * agents.mass[i];
  return forces.advance(v + blend * (wish(agents, i) - v), h / mass);
}

void SocialForce::step(Agents& agents, const Surroundings& around) {
  if (agents.empty()) return;
  const double h = static_cast<double>(around.dt) / parameters_.sub_steps;
  const double far = std::min(parameters_.range, kFar * parameters_.repulsion_range);
  const float fastest = *std::ranges::max_element(agents.maximum_speed);
  const float widest = *std::ranges::max_element(agents.radius);
  // Nobody comes nearer than by twice the way that the fastest goes in the whole step.
  const float skin = static_cast<float>(far) + 2.002f * fastest * around.dt;
  sort_by_cell(agents, grid_, skin + 2.0f * widest, around.threads);
  lists_.resize(block_count(agents.size())), next_.resize(agents.size());
  for_each_block(agents.size(), around.threads, [&](std::size_t block, std::size_t begin, std::size_t end) {
    find_neighbours(agents, block, begin, end, skin, widest);
  });
  for (int k = 0; k < parameters_.sub_steps; ++k) {
    for_each_block(agents.size(), around.threads, [&](std::size_t block, std::size_t begin, std::size_t end) {
      const Lists& lists = lists_[block];
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t first = lists.first[i - begin], last = lists.first[i - begin + 1];
        const Vec2 v = next_velocity(agents, i, {lists.items.data() + first, last - first}, around.walls, h);
        next_.set(agents, i, v, around.walls, h);
      }
    });
    next_.begin(agents);
  }
}

}  // namespace inhabit::crowd
