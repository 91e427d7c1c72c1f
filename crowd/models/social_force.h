#pragma once
#include "crowd/grid.h"
#include "crowd/model.h"
#include "crowd/steering.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

/// What one neighbour or wall does to somebody. `push` is the elastic part, newtons along the unit normal `n` that
/// leads to the one who is pushed; `grip` = kappa g(r - d), kg/s, is how strongly the tangential motion is held.
struct SocialForceContact {
  double push = 0, grip = 0;
};

/// For a gap d - r between bodies (negative when they touch):
///   push = A exp((r - d) / B) + k g(r - d),  grip = kappa g(r - d),  g(x) = max(x, 0)                 [Helbing00 eq.
///   2, 3]
SocialForceContact social_force_contact(const scene::SocialForceModel& model, double gap);

/// Social forces between people, with bodies that resist and rub when they touch.
///
///   m_i dv_i/dt = m_i (v_i^wish - v_i) / tau + sum_j f_ij + sum_W f_iW                               [Helbing00 eq. 1]
///   f_ij = {A exp((r_ij - d_ij) / B) + k g(r_ij - d_ij)} n_ij + kappa g(r_ij - d_ij) dv_ji^t t_ij    [Helbing00 eq. 2]
///   f_iW = {A exp((r_i - d_iW) / B) + k g(r_i - d_iW)} n_iW - kappa g(r_i - d_iW) (v_i.t) t          [Helbing00 eq. 3]
///
/// with r_ij the sum of the radii, d the distance of the centres or to the wall, t = perp(n), dv_ji^t = (v_j - v_i).t.
/// m_i is `person_mass` times the agent's mass. A step is `sub_steps` explicit ones: forces at t, then v, then x.
///
/// Deviations, all for the sake of a fixed step (the paper adapts its own). (1) In a sub-step friction and driving are
/// taken at the new velocity, with neighbours as they were, so that neither can overshoot:
///   (1 + h/m sum kappa g t t^T) v' = v + h/m sum (push n + kappa g (v_j.t) t), the driving exactly by exp(-h / tau);
/// both tend to the equations as h -> 0. (2) Speeds are cut at the agent's maximum after every sub-step: whatever the
/// forces, nobody moves farther than that. (3) exp((r - d) / B) is cut at exp(50), deeper than any body. (4) Gaps wider
/// than 17 B do not count: their push is less than A / 2^24. (5) crowd/steering.h: the wish is turned by 1e-5 rad,
/// nobody enters a wall. (6) crowd/wall_contacts.h says what a wall W is.
class SocialForce {
 public:
  using Parameters = scene::SocialForceModel;
  explicit SocialForce(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  void find_neighbours(const Agents& agents, std::size_t block, std::size_t begin, std::size_t end, float skin,
                       float widest);
  Vec2 next_velocity(const Agents& agents, std::size_t i, std::span<const std::uint32_t> near, const Walls& walls,
                     double h) const;

  /// Who is near whom, for the agents of one block.
  struct Lists {
    std::vector<std::uint32_t> first, items;
  };
  Parameters parameters_;
  Grid grid_;
  std::vector<Lists> lists_;
  NextMoment next_;
};
static_assert(Model<SocialForce>);

}  // namespace inhabit::crowd
