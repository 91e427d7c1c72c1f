#pragma once
#include "crowd/grid.h"
#include "crowd/model.h"
#include "crowd/steering.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

/// When and where two discs, or a disc and a wall, will touch.
struct Encounter {
  double time = 0;  ///< tau, seconds; > 0
  Vec2 gradient;    ///< of tau with respect to the position of the one who asks, s/m
};

/// The first contact of a disc at x, moving with v, with a disc of radius R at rest at the origin: the smaller root of
/// |x + tau v| = R,
///
///   tau = (b - sqrt(d)) / a,  a = v.v,  b = -x.v,  c = x.x - R^2,  d = b^2 - a c       [Karamouzas14 time to
///   collision] grad_x tau = (x + tau v) / sqrt(d)                                   (differentiate |x + tau v|^2 = R^2
///   by x)
///
/// Nothing when they never touch, or touch already (c <= 0).
std::optional<Encounter> encounter(Vec2 x, Vec2 v, double R);

/// The same for a disc of radius r at p and the segment ab: with its left side (tau = (h - r) / -(n.v), h the height
/// above it and n its normal) or with an end. Nothing for one who is on its right side.
std::optional<Encounter> encounter(Vec2 p, Vec2 v, double r, Vec2 a, Vec2 b);

/// E(tau) = k tau^-2 exp(-tau / tau_0)                                                               [Karamouzas14 eq.
/// 2]
double power_law_energy(const scene::PowerLawModel& model, double tau);

/// -grad_x E = k exp(-tau / tau_0) tau^-2 (2 / tau + 1 / tau_0) grad_x tau
Vec2 power_law_force(const scene::PowerLawModel& model, const Encounter& encounter);

/// People who keep clear of collisions to come, by an energy that falls off with the time to them.
///
///   dv_i/dt = (v_i^wish - v_i) / xi + sum_j -grad_i E(tau_ij) + -grad_i E(tau_i,walls) [Karamouzas14]
///
/// Steps are explicit: forces at t, then v, then x = x + dt v, with the dt of the other models. In dense crowds that
/// overlaps, as thesis fig. 6.7 shows.
///
/// Deviations. (1) Masses, of which the paper has none: E is scaled by twice the reduced mass of the pair, 2 m_i m_j /
/// (m_i + m_j), which is 1 for two of mass 1; the heavier gives way less, momentum is kept. (2) A pair that overlaps
/// has no time to collision and no force. (3) Of the walls only the first on the way counts: a wall in many pieces acts
/// like one. (4) The driving force alone is integrated exactly, by 1 - exp(-dt / xi). (5) The sum of the other forces
/// is cut at `maximum_acceleration`: E has no upper bound. (6) crowd/steering.h: the wish is turned by 1e-5 rad, nobody
/// enters a wall.
class PowerLaw {
 public:
  using Parameters = scene::PowerLawModel;
  explicit PowerLaw(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  Vec2 next_velocity(const Agents& agents, std::size_t i, const Surroundings& around) const;

  Parameters parameters_;
  Grid grid_;
  NextMoment next_;
};
static_assert(Model<PowerLaw>);

}  // namespace inhabit::crowd
