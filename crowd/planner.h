#pragma once
#include <memory>
#include <string>
#include <vector>

#include "crowd/agents.h"
#include "crowd/world.h"

namespace inhabit::crowd {

/// Where each route leads, resolved: for every leg the indices of the goals of which the nearest counts.
struct Routes {
  std::vector<std::vector<std::vector<std::uint16_t>>> legs;  ///< [route][leg] -> goals
};

/// Who is nearer than this to a goal that is an offset has arrived, metres; or nearer than half the body's radius.
constexpr float kArrival = 0.3f;

/// Decides which way everybody wants to go. Owned by the simulation, which calls `aim` before every step and `arrived`
/// after it.
///
/// A leg whose first goal is a direction or an offset means that goal alone. Otherwise the nearest of its areas counts,
/// and the way there is the scene's choice (scene::Planner):
///  - straight: to the nearest point of the nearest goal's aim, whatever stands between;
///  - paths: the shortest way round the corners of the floor, with room for the widest (crowd/planners/ways.h);
///  - field: down a field of distances that all with that goal share (crowd/planners/fields.h);
///  - automatic: straight where no corner sticks into the floor, a field for goals of kShared people or more and on
///    floors of more than kMostCorners corners, paths otherwise.
class Planner {
 public:
  static constexpr double kShared = 50;
  static constexpr std::size_t kMostCorners = 1500;

  /// Prepares the ways to every goal of the scene. `widest`: the largest radius among people, so that ways are wide
  /// enough. Errors: none; what cannot be reached is asked with `distance`. The scene and the world are not kept.
  static Result<Planner> make(const scene::Scene& scene, const World& world, const Routes& routes, double widest,
                              int threads = 0);
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;
  ~Planner();

  /// Sets wish_x and wish_y of every agent: preferred speed along the way to its goal, slower on the last metre to an
  /// offset; zero while it waits, when it has no goal, well inside its goal, and where no way leads on. Independent of
  /// the number of threads. Not const: who walks by `paths` remembers the corner that is headed for.
  void aim(Agents& agents, int threads);
  /// True when the agent's middle is in (one of) the goals of its leg; never for directions.
  bool arrived(const Agents& agents, std::size_t i) const;
  /// The same for everybody: flags[i] is 1 or 0. Much faster than one by one.
  void arrived(const Agents& agents, std::span<std::uint8_t> flags, int threads) const;
  /// Remembers where an agent starts, for goals that are an offset. Call once for each new agent, always with the same
  /// seed.
  void enter(const Agents& agents, std::size_t i, std::uint64_t seed);
  /// Metres on foot from an agent to the nearest goal of its leg; infinite when no way leads there, 0 for directions
  /// and for who has no goal. As the crow flies for straight ways, which are infinite from one floor to another.
  double distance(const Agents& agents, std::size_t i) const;
  /// How the ways of a leg are found: never automatic.
  scene::Planner method(std::size_t route, std::size_t leg) const;

 private:
  struct Plans;
  explicit Planner(std::unique_ptr<Plans> plans);
  std::unique_ptr<Plans> plans_;
};

}  // namespace inhabit::crowd
