#pragma once
#include <functional>
#include <vector>

#include "crowd/measures/arches.h"
#include "session/simulate_job.h"

/// What a crowd does by itself, looked at while it walks: nothing is written, and every step counts.
namespace inhabit::session {

/// One run from one seed.
struct EmergentRun {
  std::size_t people = 0, arrived = 0, put_back = 0;
  double last = 0;       ///< seconds until the last one arrived, or until the run was over
  crowd::Overlap worst;  ///< after any step
  bool all() const { return people > 0 && arrived == people; }
};
/// Called at the start and after each whole second.
using EmergentLook = std::function<void(const crowd::Simulation&)>;
/// Runs until everybody has arrived or the job's time is over; one thread. Errors: start_simulation's.
Result<EmergentRun> emergent_run(const scene::Scene& scene, const SimulateJob& job, const EmergentLook& look);

/// Everybody's place in the scene by number; NaN for who is gone. `count`: how many numbers there are.
std::vector<geometry::Vec2> places_of(const crowd::Simulation& simulation, std::size_t count);

/// Two groups that walk along x, the first population and all others.
struct LaneMoment {
  double seconds = 0;
  double apart = 0;                                  ///< distance of the groups' middles along x, metres
  double narrow = 0, wide = 0;                       ///< order parameters of bands of kNarrow and kWide either way
  double narrow_chance = 0, wide_chance = 0;         ///< the same with the ways dealt out anew at random
  static constexpr double kNarrow = 0.4, kWide = 2;  ///< metres
};
/// Requires: nobody has left.
LaneMoment lane_moment(const crowd::Simulation& simulation, std::uint64_t seed);

/// A jam before an opening in the wall at x = 0 about y = 0, the crowd at x < 0.
struct JamMoment {
  std::size_t before = 0;           ///< people at x < 0
  std::optional<crowd::Arch> arch;  ///< the innermost
  std::vector<double> speed,
      cover;             ///< by half rings of a metre about the opening: mean speed, share covered by bodies
  double roundness = 0;  ///< deviation over mean of the outermost people's distance, in 12 sectors
};
JamMoment jam_moment(const crowd::Simulation& simulation, double width);

}  // namespace inhabit::session
