#pragma once
#include "crowd/agents.h"
#include "crowd/models/pbd_work.h"
#include "crowd/walls.h"

/// What people do about those who walk ahead, before the model moves anybody. Ours; off in the thesis's preset.
///
/// Along a direction e nobody wishes to walk faster than the gaps ahead allow, as in collision-free speed models
/// [Tordeux16], with what is known of the leader's own pace:
///
///   p_i(e) = min(|wish_i|, min over j ahead of s_ij(e) / T + lambda |v_j|)
///   s_ij(e) = a - R sqrt(1 - (c / (beta R))^2),   R = r_i + r_j + l
///
/// a and c are j's distances along and across e: bodies are ellipses here, of depth R and breadth beta R. Ahead is who
/// meets this ellipse, a > 0, and of two only the one behind heeds the other, d.(e + e_j) > 0 with d from i to j:
/// nobody waits for someone who waits for him. At equal speeds the headway is (1 - lambda) T. The leader's speed counts
/// whichever way he goes: round a corner he leaves the way too.
///
/// Of the wish's own direction and six others up to the widest sidestep the one with the longest way towards the goal
/// is taken, max over phi of q_i(e_phi) cos phi, after the first rule of [Moussaid11]; straight ahead wins ties, then
/// the smaller turn, then the turn to the right. q is p, but also those count, as if they stood, who come the other way
/// (e_i.e_j < 0): nobody slows down for them, people step aside. So they spread over the width of a passage instead of
/// queueing for its corners, and opposing flows part into lanes. Nobody steps aside into a wall: of a turn by phi to
/// the side where a wall is `room` metres from the body, q is at most room / (T |sin phi|), as if somebody came from
/// there.
namespace inhabit::crowd::pbd_model {

struct HeedConstants {
  float headway = 0;       ///< T, seconds
  float length = 0;        ///< l, metres
  float slimness = 1;      ///< 1 / beta
  float anticipation = 0;  ///< lambda
  static constexpr std::size_t kTurns = 6;
  std::size_t turns = 0;
  std::array<float, kTurns> turn_cos{}, turn_sin{};
};
/// Who comes the other way, or a wall beside, bars a direction down to this share of the speed wished, not more: with
/// both sides barred people walk on and press past each other.
constexpr float kPress = 0.15f;
HeedConstants heed_constants(const scene::PbdModel& parameters);

/// Arrays padded to whole blocks, in the agents' order.
struct HeedWork {
  std::size_t count = 0;
  FloatArray x, y, vx, vy, pace, radius;  ///< pace: |v|
  FloatArray ex, ey, speed;               ///< the wish: its direction, 0 for those who want to stand, and its length
  FloatArray left, right;                 ///< room to a wall on either side of the wish, metres; kRoom and more: none
  FloatArray wish_x, wish_y;              ///< the result
};
/// Walls farther from a body do not count, metres: people keep a hand's breadth from walls when they can.
constexpr float kRoom = 0.2f;
void take(HeedWork& work, const Agents& agents);
/// The room beside the agents who have walls near. A wall is beside who wishes to walk when it lies within 60 degrees
/// of straight left or right.
void find_room(HeedWork& work, const Walls& walls, const std::vector<NearWall>& near);

/// Writes the wishes of a chunk's agents: they heed the neighbours in `rows`. The same bits with every instruction set.
void heed(HeedWork& work, const HeedConstants& constants, const NeighbourRows& rows, std::size_t chunk);

namespace plainly {
/// The same, one agent and one neighbour after the other.
void heed(HeedWork& work, const HeedConstants& constants, const NeighbourRows& rows, std::size_t chunk);
}  // namespace plainly

/// Conflicts are solved by chance [Kirchner03 has the same for cells]: whoever wishes to walk and is held up by bodies,
/// v.wish < 0.3 |wish|^2, stands still for a share of all half seconds, each person at moments of his own. Two who hold
/// each other fast in a door come free by this. `time` in seconds; a chunk's agents.
void hesitate(HeedWork& work, const Agents& agents, double share, double time, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model
