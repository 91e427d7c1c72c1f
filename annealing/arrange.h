#pragma once
#include "annealing/arranger.h"

/// Furnishing by simulated annealing (Yu et al. 2011, section 4).
namespace inhabit::annealing {

struct Options {
  std::uint64_t seed = 1;       ///< of the search; which means the objects get is choose_targets' seed
  int starts = 1;               ///< random restarts; the best arrangement of all is returned
  int threads = 0;              ///< 0: all there are; never changes the result
  std::int64_t iterations = 0;  ///< of each start; 0: 20,000 for every object that moves
  double hot = 3, cold = 3e-4;  ///< temperatures, in units of the cost
  int replicas = 1;             ///< chains of each start that trade temperatures
  bool given = true;            ///< what has a place in the scene starts there; false: everything at random
  bool paper_moves = false;     ///< the paper's moves alone
  Weights weights;
  double path_width = 0.8;       ///< of the pathways between doors, metres
  std::int64_t trace_every = 0;  ///< a row of the trace every so many iterations; 0: none
  core::Progress progress;
  const core::Cancel* cancel = nullptr;
};

struct TraceRow {
  int start = 1;
  std::int64_t iteration = 0;
  double temperature = 0, cost = 0;
  Costs parts{};  ///< by term, weighted
};

/// One finished start.
struct Arranged {
  std::vector<Pose> poses;              ///< of every object
  std::vector<double> bases;            ///< and the height of its base
  std::vector<std::uint32_t> carriers;  ///< and what carries it; kNobody: nothing
  std::vector<BezierCurve> paths;       ///< Bezier curves between the doors
  double cost = 0;
  Costs parts{};      ///< by term, weighted
  bool fits = false;  ///< no body intersects another or leaves the room, as far as the cost sees
  int start = 1;      ///< from 1
  std::int64_t iterations = 0, proposed = 0, accepted = 0;
  double seconds = 0;  ///< wall time
};

struct Outcome {
  Arranged best;
  std::vector<Arranged> starts;  ///< every start, in order (fewer when cancelled)
  std::vector<TraceRow> trace;
  std::vector<std::string> without_wall;  ///< objects of the best that should stand at a wall and found no place there
  bool cancelled = false;
};

/// Furnishes the scene. Errors: compile()'s. An arrangement that intersects or blocks is no error: see check.
Result<Outcome> arrange(const Scene& scene, const Targets& targets, const Options& options);

/// The scene with everything standing as arranged, second-tier objects `on` what carries them.
Scene with_arrangement(Scene scene, const Arranged& arranged);

}  // namespace inhabit::annealing
