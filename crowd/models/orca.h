#pragma once
#include "crowd/grid.h"
#include "crowd/model.h"
#include "crowd/models/linear_programme.h"
#include "crowd/neighbours.h"
#include "crowd/steering.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

/// What agent A has to respect for the sake of agent B:
///
///   u = (argmin over the border of VO of |v - (v_A - v_B)|) - (v_A - v_B),  n the outward normal there
///   ORCA = { v | (v - (v_A + share u)).n >= 0 }                                                 [vandenBerg11
///   sec. 4.2]
///
/// x leads from A to B, v = v_A - v_B, r is the sum of the radii. Discs that overlap get apart within one step: the
/// same with tau = dt. `aside`: the normal when all else is null (two in the same place with the same velocity).
HalfPlane orca_half_plane(Vec2 x, Vec2 v, Vec2 v_A, double r, double tau, double dt, double share, Vec2 aside);

/// Optimal reciprocal collision avoidance: of the velocities that keep clear of everybody for `horizon` seconds, when
/// the others do their share, everybody takes the one nearest to the wish. Cost: O(K) half planes per agent, K =
/// `neighbours`.
///
/// Walls ask for a velocity outside their velocity obstacles (sec. 5.4) and are never relaxed when people leave no
/// solution (sec. 5.3). Velocities are optimised from the present ones (sec. 5.2).
///
/// Deviations. (1) A takes the share m_B / (m_A + m_B) of u instead of one half: the same for equal masses, and the
/// shares of a pair still add up to one, which is all that the proof needs. (2) Half planes are taken nearest first
/// instead of in random order. (3) A wall in pieces is one wall: where the next piece is in sight, its velocity
/// obstacle has no leg. (4) Who touches a wall may not come nearer, whatever its velocity. (5) crowd/steering.h: the
/// wish is turned by 1e-5 rad, nobody enters a wall.
class Orca {
 public:
  using Parameters = scene::OrcaModel;
  explicit Orca(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  /// What one thread needs for one agent after the other.
  struct Workspace {
    NearestNeighbours nearest;
    std::vector<HalfPlane> planes;
    LinearProgramme programme;
  };
  Vec2 next_velocity(const Agents& agents, std::size_t i, const Surroundings& around, Workspace& work) const;

  Parameters parameters_;
  Grid grid_;
  NextMoment next_;
};
static_assert(Model<Orca>);

/// The half planes of the walls that an agent faces, not farther than it could come in tau seconds.
void append_wall_half_planes(const Walls& walls, Vec2 p, Vec2 v, double radius, double tau, double longest,
                             std::vector<HalfPlane>& planes);

}  // namespace inhabit::crowd
