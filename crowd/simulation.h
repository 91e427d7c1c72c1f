#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "crowd/agents.h"
#include "crowd/planner.h"
#include "crowd/world.h"

namespace inhabit::crowd {

struct Settings {
  std::optional<scene::CrowdModel> model;  ///< absent: the scene's
  std::optional<double> step;              ///< seconds; absent: the scene's
  std::optional<std::uint64_t> seed;       ///< absent: the scene's
  int threads = 0;                         ///< 0: all there are; never changes the result
};

/// What became of the request, for people: who could not be placed, moved out of walls, cannot reach a goal.
struct Intake {
  std::string population;
  std::size_t asked = 0, placed = 0, moved = 0, unreachable = 0;
};

/// A scene with people in it, step after step.
class Simulation {
 public:
  /// Errors: a scene without people, a goal nobody can reach.
  static Result<Simulation> make(const scene::Scene& scene, const Settings& settings);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// One step: people appear, wish, move, arrive and leave.
  void step();

  double time() const;  ///< seconds so far
  double dt() const;
  std::size_t steps() const;
  const Agents& agents() const;  ///< in no particular order: `id` says who is who
  const World& world() const;
  std::span<const Intake> intakes() const;
  std::size_t arrived() const;          ///< people who have reached the end of their route
  std::size_t waiting_outside() const;  ///< of sources: due, but without room
  bool finished() const;                ///< nobody is there and nobody will come

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace inhabit::crowd
