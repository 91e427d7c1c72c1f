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

/// Decides which way everybody wants to go. Owned by the simulation, which calls `aim` before every step and `arrived`
/// after it.
class Planner {
 public:
  /// Prepares the ways to every goal of the scene. `widest`: the largest radius among people, so that ways are wide
  /// enough. Errors: none; what cannot be reached is asked with `distance`.
  static Result<Planner> make(const scene::Scene& scene, const World& world, const Routes& routes, double widest);
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;
  ~Planner();

  /// Sets wish_x and wish_y of every agent: preferred speed along the way to its goal, zero while it waits or when it
  /// has no goal. Independent of the number of threads.
  void aim(Agents& agents, int threads) const;
  /// True when the agent is in (the nearest) goal of its leg; never for directions.
  bool arrived(const Agents& agents, std::size_t i) const;
  /// Remembers where an agent starts, for goals that are an offset. Call once for each new agent.
  void enter(const Agents& agents, std::size_t i, std::uint64_t seed);
  /// Metres on foot from a point to the nearest goal of a leg; infinite when no way leads there.
  double distance(const Agents& agents, std::size_t i) const;

 private:
  struct Plans;
  explicit Planner(std::unique_ptr<Plans> plans);
  std::unique_ptr<Plans> plans_;
};

}  // namespace inhabit::crowd
