#include "session/bench.h"

#include <ctime>
#include <fstream>
#include <thread>

#include "core/text.h"

namespace inhabit::session {

std::vector<BenchGroupRow> bench_groups() {
  return {
      {"table1", "times and feasible shares of the papers' scenes beside TVCG table 1", bench_table1},
      {"against", "position-based beside simulated annealing: the same energy, starts and machine", bench_against,
       BenchGroupRow::comparison},
      {"anneal", "furniture learned from examples: times, results and cost of moves beside Yu et al. table 1",
       bench_anneal, BenchGroupRow::comparison},
      {"growth", "theatre seats against time, TVCG fig. 13", bench_growth},
      {"tight", "the tight bedroom with ever less floor", bench_tight},
      {"interactive", "solved again after one object is dragged", bench_interactive},
      {"residuals", "what every kind of constraint misses by", bench_residuals},
      {"memory", "bytes per object beyond the scene", bench_memory},
      {"files", "reading, writing, checking and drawing up to 100,000 objects", bench_files},
      {"rooms", "real homes, stripped and furnished again (needs the data folder)", bench_rooms},
      {"learned", "real rooms furnished by what other homes teach, beside their designers (needs the data folder)",
       bench_learned},
      {"crowd", "times and overlaps of crowds beside published ones, growth, roofline", bench_crowd,
       BenchGroupRow::people},
      {"measures", "recordings of people measured, beside published curves (needs the data folder)", bench_measures,
       BenchGroupRow::people},
      {"emergence", "what crowds do by themselves: all arrive, lanes, arches, shapes; 20 seeds at most",
       bench_emergence, BenchGroupRow::people},
      {"realism", "people of preset pedestrian beside recorded people and published curves", bench_realism,
       BenchGroupRow::people},
  };
}

double processor_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

Table machine_table() {
  std::string model = "unknown processor", line;
  std::ifstream cpuinfo("/proc/cpuinfo");
  while (std::getline(cpuinfo, line))
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  Table table{"machine", "Machine", {{"what"}, {"value"}}, {}, {}};
  table.rows.push_back({"processor", model});
  table.rows.push_back({"threads", std::to_string(std::thread::hardware_concurrency())});
#ifdef __clang__
  table.rows.push_back({"compiler", "clang " __clang_version__});
#else
  table.rows.push_back({"compiler", "gcc " __VERSION__});
#endif
#ifdef NDEBUG
  table.rows.push_back({"assertions", "off"});
#else
  table.rows.push_back({"assertions", "on"});
#endif
#ifdef __OPTIMIZE__
  table.rows.push_back({"optimised", "yes"});
#else
  table.rows.push_back({"optimised", "no"});
#endif
  return table;
}

Result<BenchRuns> bench_runs(const layout::Scene& scene, const BenchOptions& options, const BenchRun& run) {
  BenchRuns runs;
  for (int seed = 1; seed <= run.seeds; ++seed) {
    if (options.cancel && options.cancel->requested()) break;
    layout::Options layout = options.layout;
    layout.seed = static_cast<std::uint64_t>(seed);
    layout.starts = run.starts;
    layout.threads = run.threads;
    layout.cancel = options.cancel;
    const double begin = processor_milliseconds();
    const Result<layout::Outcome> outcome = layout::furnish(scene, layout);
    const double took = processor_milliseconds() - begin;
    if (!outcome) return outcome.error();
    if (outcome->cancelled) break;
    runs.milliseconds.push_back(took);
    runs.energies.push_back(outcome->best.energy);
    runs.iterations.push_back(outcome->best.iterations);
    ++runs.runs;
    runs.feasible += outcome->best.feasible;
    if (run.each) run.each(*outcome);
    if (options.progress) options.progress(static_cast<double>(seed) / run.seeds, scene.name);
  }
  return runs;
}

}  // namespace inhabit::session
