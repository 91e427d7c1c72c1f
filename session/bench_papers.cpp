#include <algorithm>
#include <array>
#include <map>

#include "layout/check.h"
#include "session/bench.h"
#include "session/paper_scenes.h"

namespace inhabit::session {
namespace {

/// The scene without its declarations that switch collisions off.
Scene with_collisions(const Scene& scene) {
  Scene result = scene;
  result.constraints = {};
  for (const auto& [kind, index] : scene.constraints.order) {
    std::uint16_t k = 0;
    for_each_type(ConstraintKinds{}, [&]<class K>(std::type_identity<K>) {
      if (k++ == kind) {
        const K& constraint = scene.constraints.of<K>()[index];
        if constexpr (std::is_same_v<K, Collision>) {
          if (constraint.mode == 2) return;
        }
        result.constraints.add(constraint);
      }
    });
  }
  return result;
}

Result<std::vector<Cell>> table1_row(const std::string& name, const PaperScene& paper, const Scene& scene,
                                     const BenchOptions& options) {
  const Result<BenchRuns> one = bench_runs(scene, options, {options.seeds, 1, 1, {}});
  if (!one) return one.error();
  const Result<BenchRuns> five = bench_runs(scene, options, {options.seeds, 5, 1, {}});
  if (!five) return five.error();
  const double ms = median(one->milliseconds);
  return std::vector<Cell>{name,
                           static_cast<double>(scene.objects.size()),
                           ms,
                           quantile(one->milliseconds, 0.95),
                           paper.published_seconds,
                           ms > 0 ? Cell(1000 * paper.published_seconds / ms) : Cell(),
                           paper.annealing_seconds > 0 ? Cell(paper.annealing_seconds) : Cell(),
                           100 * one->feasible_share(),
                           100 * five->feasible_share(),
                           median(one->iterations),
                           median(five->energies)};
}

}  // namespace

Result<BenchGroup> bench_table1(const BenchOptions& options) {
  Table table{"table1", "Table 1: one start on one thread, our times beside the published", {}, {}, {}};
  table.columns = {{"scene"},       {"objects", 0},    {"median ms", 3},      {"p95 ms", 3},
                   {"paper s", 2},  {"ratio", 0},      {"annealing s", 2},    {"feasible % 1 start", 1},
                   {"5 starts", 1}, {"iterations", 0}, {"energy 5 starts", 3}};
  for (const PaperScene& paper : paper_scenes()) {
    const Scene scene = paper.build();
    const Result<std::vector<Cell>> row = table1_row(std::string(paper.name), paper, scene, options);
    if (!row) return row.error();
    table.rows.push_back(*row);
    if (!paper.name.starts_with("theater-2")) continue;
    std::string name(paper.name);
    name += " (collisions on)";
    const Result<std::vector<Cell>> collided = table1_row(name, paper, with_collisions(scene), options);
    if (!collided) return collided.error();
    table.rows.push_back(*collided);
  }
  table.notes.push_back(
      "seeds: " + std::to_string(options.seeds) +
      "; published: Python and Cython, one 2.5 GHz core, mean of 10 runs; photo rooms: \"no more than 4 s\"");
  return BenchGroup{{std::move(table)}, {}};
}

Result<BenchGroup> bench_growth(const BenchOptions& options) {
  Table table{"growth", "Growth: theater-1 with more and more seats, one start on one thread", {}, {}, {}};
  table.columns = {{"seats", 0},          {"median ms", 2},  {"ms per seat", 5},
                   {"per doubling %", 1}, {"feasible %", 1}, {"iterations", 0}};
  BenchCurve curve{"growth", "Time to furnish a theatre", "seats", "seconds", true, true, {}};
  curve.lines.push_back({"inhabit, median", {}, {}});
  double before = 0;
  int seats_before = 0;
  for (int seats = 25; seats <= options.max_seats; seats = seats == 51200 ? 100000 : 2 * seats) {
    if (options.cancel && options.cancel->requested()) break;
    // Of one or two runs, the median says more about their seeds than about the size.
    const int seeds = std::min(options.seeds, std::max(20000 / seats, 5));
    const Result<BenchRuns> runs = bench_runs(theater_1(seats), options, {seeds, 1, 1, {}});
    if (!runs) return runs.error();
    if (runs->runs == 0) break;
    const double ms = median(runs->milliseconds), each = ms / seats;
    // What one doubling costs, also where the step is not quite a doubling.
    const double doublings = seats_before ? std::log2(static_cast<double>(seats) / seats_before) : 1;
    table.rows.push_back({static_cast<double>(seats), ms, each,
                          before > 0 ? Cell(100 * (std::pow(each / before, 1 / doublings) - 1)) : Cell(),
                          100 * runs->feasible_share(), median(runs->iterations)});
    curve.lines[0].x.push_back(seats);
    curve.lines[0].y.push_back(ms / 1000);
    before = each;
    seats_before = seats;
  }
  return BenchGroup{{std::move(table)}, {std::move(curve)}};
}

Result<BenchGroup> bench_tight(const BenchOptions& options) {
  Table table{"tight", "Tight bedroom: how often a layout is found as the room shrinks", {}, {}, {}};
  table.columns = {
      {"coverage %", 0}, {"feasible % 1 start", 1}, {"5 starts", 1}, {"median ms 1 start", 3}, {"p95 ms 1 start", 3}};
  BenchCurve curve{
      "tight", "Tight bedroom: share of feasible layouts", "floor coverage, %", "feasible, %", false, false, {}};
  const std::array starts = {1, 5};
  for (const int count : starts)
    curve.lines.push_back({std::to_string(count) + (count == 1 ? " start" : " starts"), {}, {}});
  for (const double coverage : {0.53, 0.60, 0.66, 0.70, 0.75, 0.80}) {
    std::vector<Cell> row = {100 * coverage};
    std::vector<double> times;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Result<BenchRuns> runs = bench_runs(tight_bedroom(coverage), options, {options.seeds, starts[k], 1, {}});
      if (!runs) return runs.error();
      row.push_back(100 * runs->feasible_share());
      if (k == 0) times = {median(runs->milliseconds), quantile(runs->milliseconds, 0.95)};
      curve.lines[k].x.push_back(100 * coverage);
      curve.lines[k].y.push_back(100 * runs->feasible_share());
    }
    row.insert(row.end(), {times[0], times[1]});
    table.rows.push_back(std::move(row));
  }
  return BenchGroup{{std::move(table)}, {std::move(curve)}};
}

Result<BenchGroup> bench_residuals(const BenchOptions& options) {
  Table table{"residuals", "Residuals: what each kind of constraint misses by, 5 starts", {}, {}, {}};
  table.columns = {{"scene"}, {"constraint"}, {"unit"}, {"count", 0}, {"median", 4}, {"p95", 4}, {"max", 4}};
  for (const PaperScene& paper : paper_scenes()) {
    const Scene scene = paper.build();
    std::map<std::string, std::pair<bool, std::vector<double>>> kinds;
    const auto collect = [&](const layout::Outcome& outcome) {
      for (const layout::Residual& r : layout::residuals(layout::with_placement(scene, outcome.best.placement)).list) {
        auto& [angular, values] = kinds[std::string(r.type)];
        angular = r.angular;
        values.push_back(std::abs(r.angular ? degrees(r.value) : r.value));
      }
    };
    const Result<BenchRuns> runs = bench_runs(scene, options, {options.seeds, 5, 1, collect});
    if (!runs) return runs.error();
    for (auto& [kind, entry] : kinds) {
      auto& [angular, values] = entry;
      table.rows.push_back({std::string(paper.name), kind, std::string(angular ? "deg" : "m"),
                            static_cast<double>(values.size()) / std::max(1, runs->runs), median(values),
                            quantile(values, 0.95), quantile(values, 1)});
    }
  }
  table.notes.push_back("count: constraint instances per layout; " + std::to_string(options.seeds) + " seeds");
  return BenchGroup{{std::move(table)}, {}};
}

}  // namespace inhabit::session
