#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "crowd/overlap.h"
#include "crowd/simulation.h"
#include "io/trajectory_table.h"
#include "session/crowd_model_choice.h"

/// People walk through a scene, and where they are goes into a file.
namespace inhabit::session {

struct SimulateJob {
  ModelChoice model;
  std::string planner;            ///< "": the scene's
  std::optional<double> seconds;  ///< of the scene's time; absent: as long as the scene says
  std::optional<double> step;     ///< seconds; absent: the scene's
  std::optional<std::uint64_t> seed;
  int every = 2;    ///< steps from one frame to the next
  int threads = 0;  ///< 0: all there are; never changes the result
  core::Progress progress;
  const core::Cancel* cancel = nullptr;
};

/// Takes the people of a frame, ascending by number.
using FrameSink = std::function<Status(std::int32_t frame, std::span<const io::Spot> people)>;

/// What came of a run.
struct Simulated {
  std::string scene, model, planner;
  std::vector<crowd::Intake> intakes;
  std::size_t people = 0, arrived = 0, inside = 0, waiting_outside = 0;
  std::size_t steps = 0, frames = 0;
  double step = 0, time = 0;  ///< of the scene, seconds
  double seconds = 0;         ///< that the steps took
  crowd::Overlap worst;       ///< of all written frames
  double worst_at = 0;        ///< the time of the deepest overlap of people, seconds
  std::size_t put_back = 0;
  bool cancelled = false;
  /// For people: who could not be placed, was moved, cannot reach his goal, waits outside.
  std::vector<std::string> warnings() const;
};

/// The simulation that a job asks for. Errors: those of crowd::Simulation::make, names that there are not.
Result<crowd::Simulation> start_simulation(const scene::Scene& scene, const SimulateJob& job);

/// Runs until nobody is there and nobody will come, the time is over, or a stop is asked for, and hands over each
/// frame; frame 0 is the start. Memory does not grow with time. Errors: the sink's.
Result<Simulated> run_simulation(crowd::Simulation& simulation, double seconds, const SimulateJob& job,
                                 const FrameSink& sink);

/// Both, into a file of the format that its name says, or into none when the name is empty. The file takes its place
/// when the run is over or was stopped. Errors (`where` is the file's name or a place in the scene): as above, and a
/// file that cannot be written.
Result<Simulated> simulate_job(const scene::Scene& scene, const SimulateJob& job, const std::string& path);

std::string simulate_text(const Simulated& simulated);
/// One object.
std::string simulate_json(const Simulated& simulated);

}  // namespace inhabit::session
