#pragma once
#include "crowd/agents.h"
#include "crowd/walls.h"

/// What models that compute velocities have in common: the wish that they steer by, and the move that ends a step.
namespace inhabit::crowd {

/// By so much (radians) wishes are turned to the right: two people who meet exactly head-on would otherwise stand face
/// to face for ever. They pass after some seconds, since the smallest asymmetry grows; over a kilometre it leads one
/// centimetre aside.
constexpr double kTieBreak = 1e-5;

inline Vec2 position(const Agents& agents, std::size_t i) { return {agents.x[i], agents.y[i]}; }
inline Vec2 velocity(const Agents& agents, std::size_t i) { return {agents.vx[i], agents.vy[i]}; }
/// The preferred velocity of agent i, turned by kTieBreak.
inline Vec2 wish(const Agents& agents, std::size_t i) {
  const Vec2 w{agents.wish_x[i], agents.wish_y[i]};
  return w - kTieBreak * perp(w);
}
/// v, shortened to `longest`; null when it is no finite vector.
inline Vec2 limited(Vec2 v, double longest) {
  const double ll = dot(v, v);
  if (ll <= longest * longest) return v;
  const double l = std::sqrt(ll);
  return std::isfinite(l) ? (longest / l) * v : Vec2{};
}

/// Where a disc ends that moves from `from` to `to` among walls: pushed out of those that it would enter, so that it
/// slides along them. A disc that was on the floor never has its centre behind a wall afterwards; where it fits nowhere
/// (a gap narrower than itself) it stays where it is. Requires: the way is shorter than the reach of the walls.
Vec2 moved_among_walls(const Walls& walls, Vec2 from, Vec2 to, double radius);

/// The positions and velocities of the next moment: while it is computed, everybody reads the present one.
class NextMoment {
 public:
  /// Begins a step of so many agents.
  void resize(std::size_t count) {
    x_.resize(count), y_.resize(count), vx_.resize(count), vy_.resize(count), lost_.assign(count, Vec2{});
  }
  /// Agent i goes on with velocity v, limited to its maximum speed: x = x + dt v, among the walls. The velocity that is
  /// kept is the one that it then really had. `core`: the share of the radius that walls do not let in.
  void set(const Agents& now, std::size_t i, Vec2 v, const Walls& walls, double dt, double core = 1);
  /// Makes the next moment the present one. Requires: set has been called for everybody.
  void begin(Agents& agents) { agents.x.swap(x_), agents.y.swap(y_), agents.vx.swap(vx_), agents.vy.swap(vy_); }

 private:
  std::vector<float> x_, y_, vx_, vy_;
  /// What floats lost of the positions, for the next sub-step: a kilometre from the origin twenty small ways would
  /// otherwise be several per cent too long or too short.
  std::vector<Vec2> lost_;
};

}  // namespace inhabit::crowd
