#include <algorithm>
#include <array>

#include "core/rng.h"
#include "session/bench.h"
#include "session/paper_scenes.h"

namespace inhabit::session {
namespace {

/// Drags one object by up to half a metre, pins it where the mouse is, and solves again from what stands.
Result<std::vector<double>> drag_times(const Scene& furnished, const BenchOptions& options, int drags, int& feasible) {
  std::vector<double> times;
  for (int drag = 0; drag < drags; ++drag) {
    if (options.cancel && options.cancel->requested()) break;
    Rng rng(static_cast<std::uint64_t>(drag), 91);
    Scene scene = furnished;
    const Bounds room = bounds(scene.space.outline);
    Object& object = scene.objects[rng.index(static_cast<std::uint32_t>(scene.objects.size()))];
    const double margin = 0.5 * std::hypot(object.size.x, object.size.y);
    object.position->x =
        std::clamp(object.position->x + rng.uniform(-0.5, 0.5), room.min.x + margin, room.max.x - margin);
    object.position->y =
        std::clamp(object.position->y + rng.uniform(-0.5, 0.5), room.min.y + margin, room.max.y - margin);
    object.lock = Lock::position;
    layout::Options layout = options.layout;
    layout.start = layout::Start::given;
    layout.starts = layout.threads = 1;
    layout.cancel = options.cancel;
    const double begin = processor_milliseconds();
    const Result<layout::Outcome> outcome = layout::furnish(scene, layout);
    const double took = processor_milliseconds() - begin;
    if (!outcome) return outcome.error();
    times.push_back(took);
    feasible += outcome->best.feasible;
  }
  return times;
}

}  // namespace

Result<BenchGroup> bench_interactive(const BenchOptions& options) {
  Table table{
      "interactive", "Interactive: one object dragged by up to half a metre, all else solved again", {}, {}, {}};
  table.columns = {{"scene"},     {"objects", 0}, {"drags", 0},     {"median ms", 3},
                   {"p95 ms", 3}, {"max ms", 3},  {"feasible %", 1}};
  for (const char* name : {"living-room", "picnic"}) {
    const Scene scene = find_paper_scene(name)->build();
    layout::Options layout = options.layout;
    layout.seed = 1;
    const Result<layout::Outcome> outcome = layout::furnish(scene, layout);
    if (!outcome) return outcome.error();
    int feasible = 0;
    const Result<std::vector<double>> times =
        drag_times(layout::with_placement(scene, outcome->best.placement), options, options.seeds, feasible);
    if (!times) return times.error();
    const double count = static_cast<double>(times->size());
    table.rows.push_back({std::string(name), static_cast<double>(scene.objects.size()), count, median(*times),
                          quantile(*times, 0.95), quantile(*times, 1), 100 * feasible / std::max(1.0, count)});
  }
  table.notes.push_back("target: under 4 ms, a quarter of a frame");
  return BenchGroup{{std::move(table)}, {}};
}

}  // namespace inhabit::session
