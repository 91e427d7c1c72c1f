#include <malloc.h>

#include "layout/solver.h"
#include "session/bench.h"
#include "session/paper_scenes.h"

namespace inhabit::session {
namespace {

/// Bytes in use by the heap, as the C library counts them.
double heap_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace

/// What one start holds on to after it has run: the compiled problem, the state, the best state, pairs, grids.
Result<BenchGroup> bench_memory(const BenchOptions& options) {
  Table table{"memory", "Memory of a compiled scene and one start, beyond the scene itself", {}, {}, {}};
  table.columns = {{"scene"}, {"objects", 0}, {"problem bytes", 0}, {"start bytes", 0}, {"bytes per object", 0}};
  for (const int seats : {0, 200, 3200, 25600}) {
    if (seats > 3200 && seats > options.max_seats) break;
    const Scene scene = seats == 0 ? tight_picnic() : theater_1(seats);
    const double before = heap_bytes();
    const Result<layout::Problem> problem = layout::compile(scene);
    if (!problem) return problem.error();
    const double compiled = heap_bytes();
    layout::Options layout = options.layout;
    layout.max_iterations = 20;
    layout::Solver solver(*problem, layout, 0);
    solver.run(nullptr);
    const double after = heap_bytes(), n = static_cast<double>(scene.objects.size());
    table.rows.push_back({scene.name, n, compiled - before, after - compiled, (after - before) / n});
  }
  return BenchGroup{{std::move(table)}, {}};
}

}  // namespace inhabit::session
