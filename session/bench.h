#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "layout/furnish.h"
#include "session/table.h"

/// The published tables of layout synthesis and of crowds, measured here, beside the published figures.
namespace inhabit::session {
using namespace core;

struct BenchOptions {
  int seeds = 100;
  bool seeds_given = false;      ///< else realism takes 5
  std::vector<std::string> set;  ///< realism, emergence: parameters of the model, NAME=VALUE
  int max_seats = 3200;          ///< growth: the largest theatre
  int max_people = 100000;       ///< crowd: the largest growing crowd, people
  int threads = 0;               ///< crowd: 0: all there are
  double seconds = 0;            ///< crowd: of simulated time, at most; 0: as long as each scene says
  std::string data;              ///< rooms, learned, measures: the folder that holds `rooms/` and `pedestrians/`
  layout::Options layout;        ///< method, scheme, start; seed, starts and threads are the bench's own
  Progress progress;
  const Cancel* cancel = nullptr;
};

/// A curve that belongs to a group.
struct BenchCurve {
  std::string id, title, x_label, y_label;
  bool log_x = false, log_y = false;
  struct Line {
    std::string name;
    std::vector<double> x, y;
  };
  std::vector<Line> lines;
};

/// Rooms side by side, with a word under each.
struct BenchSheet {
  std::string id, title;
  int columns = 0;  ///< 0: as many as look well
  struct Cell {
    scene::Scene scene;
    std::string caption;
  };
  std::vector<Cell> cells;
};

struct BenchGroup {
  std::vector<Table> tables;
  std::vector<BenchCurve> curves;
  std::vector<BenchSheet> sheets;
};

struct BenchGroupRow {
  std::string_view name, sentence;
  Result<BenchGroup> (*run)(const BenchOptions&);
  enum Subject { layout, people, comparison } subject = layout;  ///< "layout" stands for every group of the first
};
/// Every group there is, in the order in which they run.
std::vector<BenchGroupRow> bench_groups();

/// Processor time of this thread so far. Every time here is a difference of two of them: what else the machine does
/// does not count, and with one thread it is what a quiet machine's clock would show.
double processor_milliseconds();

/// CPU model, cores, compiler, build: what a time means something on.
Table machine_table();

Result<BenchGroup> bench_table1(const BenchOptions& options);
Result<BenchGroup> bench_against(const BenchOptions& options);
Result<BenchGroup> bench_anneal(const BenchOptions& options);
Result<BenchGroup> bench_growth(const BenchOptions& options);
Result<BenchGroup> bench_tight(const BenchOptions& options);
Result<BenchGroup> bench_interactive(const BenchOptions& options);
Result<BenchGroup> bench_residuals(const BenchOptions& options);
Result<BenchGroup> bench_memory(const BenchOptions& options);
Result<BenchGroup> bench_files(const BenchOptions& options);
Result<BenchGroup> bench_rooms(const BenchOptions& options);
Result<BenchGroup> bench_learned(const BenchOptions& options);
Result<BenchGroup> bench_measures(const BenchOptions& options);
Result<BenchGroup> bench_realism(const BenchOptions& options);
Result<BenchGroup> bench_crowd(const BenchOptions& options);
Result<BenchGroup> bench_emergence(const BenchOptions& options);

/// One scene furnished from seeds 1 … `seeds`.
struct BenchRuns {
  std::vector<double> milliseconds, energies, iterations;  ///< whole calls of furnish, one per seed
  int runs = 0, feasible = 0;
  double feasible_share() const { return runs ? static_cast<double>(feasible) / runs : 0; }
};
struct BenchRun {
  int seeds = 100, starts = 1, threads = 1;
  std::function<void(const layout::Outcome&)> each;  ///< what else to look at
};
/// Stops early when cancelled; the error is furnish's.
Result<BenchRuns> bench_runs(const layout::Scene& scene, const BenchOptions& options, const BenchRun& run);

}  // namespace inhabit::session
