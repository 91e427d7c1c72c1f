#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "crowd/agents.h"
#include "crowd/models/pbd.h"
#include "crowd/placement.h"
#include "crowd/world.h"

namespace inhabit::crowd {

/// Nobody's steps are longer; models fall apart long before, seconds.
constexpr double kLongestStep = 1;

struct Settings {
  std::optional<scene::CrowdModel> model;  ///< absent: the scene's
  std::optional<double> step;              ///< seconds; absent: the scene's
  std::optional<std::uint64_t> seed;       ///< absent: the scene's
  int threads = 0;                         ///< 0: all there are; never changes the result
};

/// Where the time of all steps so far went, seconds.
struct StepTimes {
  double planning = 0;  ///< who enters, and what everybody wishes
  double model = 0;
  double keeping = 0;   ///< looking whether somebody left the floor
  double arriving = 0;  ///< who has reached a goal, and who leaves
  double sum() const { return planning + model + keeping + arriving; }
};

/// A scene with people in it, step after step.
class Simulation {
 public:
  /// Errors: a scene without people, a step that is not above 0 and at most kLongestStep, no floor, goals that there
  /// are not or that nobody of a population (or source) can reach.
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
  std::size_t people() const;           ///< everybody there ever was
  /// How often somebody was put back out of a wall or had lost his numbers; 0 for a model that works.
  std::size_t put_back() const;
  bool finished() const;  ///< nobody is there and nobody will come
  const StepTimes& times() const;
  /// Of the last step of the position-based model; zeros for other models.
  Effort effort() const;

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace inhabit::crowd
