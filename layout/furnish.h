#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "scene/scene.h"

/// Layout synthesis by position-based projection (TVCG; thesis chapter 5) with relocation moves between projections.
namespace inhabit::layout {
using namespace scene;

/// Gauss–Seidel: a projection is visible to the next one. Averaged: the corrections of a set are averaged per particle
/// and multiplied by 1.2 (TVCG 3.1).
enum class Scheme { gauss_seidel, averaged };
/// Where free objects start. `given`: where the scene says, the rest as `placed`. `random`: uniformly, as in the
/// papers. `placed`: one after the other at the best of some sampled poses.
enum class Start { given, random, placed };

struct Options {
  std::uint64_t seed = 1;
  int starts = 5;              ///< random restarts; the best layout of all is returned
  int threads = 0;             ///< 0: all there are; never changes the result
  int max_iterations = 20000;  ///< while nothing feasible is found; a feasible start ends long before
  int patience = 50;           ///< stop when the best energy has not improved for so many iterations (thesis 6.2)
  Scheme scheme = Scheme::gauss_seidel;
  Start start = Start::given;
  bool relocation = true;  ///< discrete moves between projections; false: the papers' scheme alone
  bool paper = false;      ///< the papers' method to the letter: random start, no relocation, no polishing
  bool trace = false;
  core::Progress progress;
  const core::Cancel* cancel = nullptr;
};

/// Where everything stands: one entry per object and per group of the scene.
struct Placement {
  struct Spot {
    Vec3 position;
    double angle = 0;
  };
  std::vector<Spot> objects;
  std::vector<Pose> groups;
};

struct TraceRow {
  int start = 1, iteration = 0;  ///< both from 1
  double energy = 0;             ///< TVCG eq. 1
  double overlap = 0;            ///< summed overlap depth of all pairs and of everything outside, metres
  bool feasible = false;
  bool relocated = false;
};

/// One finished start.
struct Layout {
  Placement placement;
  bool feasible = false;  ///< no overlap deeper than 1 mm, nothing outside by more than 1 mm
  double energy = 0;
  double violation = 0;           ///< summed overlap and outside depth, metres
  int start = 1, iterations = 0;  ///< the number of the start, from 1
  double seconds = 0;             ///< wall time of this start
};

struct Outcome {
  Layout best;
  std::vector<Layout> starts;  ///< every start, in order (fewer when cancelled)
  std::vector<TraceRow> trace;
  bool cancelled = false;
};

/// Furnishes the scene. Errors: a scene that cannot be furnished whatever the arrangement (an object larger than the
/// room in every orientation, a group that contains itself). A layout that violates constraints is no error: see check.
Result<Outcome> furnish(const Scene& scene, const Options& options);

/// `count` distinct layouts, best first: feasible before infeasible, then by energy; two are distinct when some object
/// differs by more than its own size or 45 degrees. Fewer when no more distinct ones were found in 8 * count starts.
Result<std::vector<Layout>> suggest(const Scene& scene, const Options& options, int count);

/// The scene with everything standing as placed.
Scene with_placement(Scene scene, const Placement& placement);

/// The scene without the positions and angles of what is neither fixed nor locked nor hangs from the ceiling. Heights
/// stay, as `elevation`: a picture hangs as high on its next wall.
Scene without_positions(Scene scene);

}  // namespace inhabit::layout
