#include <algorithm>
#include <map>

#include "core/text.h"
#include "render/frame.h"
#include "render/plot.h"

namespace inhabit::render {
namespace {

struct Run {
  std::vector<Vec2> points;
  double best = 1e300, best_feasible = 1e300;
  std::optional<Vec2> first_feasible;
};

std::map<int, Run> by_start(std::span<const layout::TraceRow> trace) {
  std::map<int, Run> runs;
  for (const layout::TraceRow& row : trace) {
    Run& run = runs[row.start];
    const Vec2 p{static_cast<double>(row.iteration), row.energy};
    run.points.push_back(p);
    run.best = std::min(run.best, row.energy);
    if (!row.feasible) continue;
    run.best_feasible = std::min(run.best_feasible, row.energy);
    if (!run.first_feasible) run.first_feasible = p;
  }
  return runs;
}

}  // namespace

Drawing draw_energy(std::span<const layout::TraceRow> trace) {
  const std::map<int, Run> runs = by_start(trace);
  const auto better = [](const Run& a, const Run& b) {
    return a.best_feasible != b.best_feasible ? a.best_feasible < b.best_feasible : a.best < b.best;
  };
  const auto best = std::ranges::min_element(runs, better, [](const auto& r) -> const Run& { return r.second; });
  Plot plot;
  plot.title = "Energy per iteration";
  plot.x.label = "iteration";
  plot.y.label = "energy";
  double low = 1e300, high = 0;
  for (const layout::TraceRow& row : trace)
    if (row.energy > 0 && row.energy < 1e300) low = std::min(low, row.energy), high = std::max(high, row.energy);
  plot.y.log = high > 30 * low;
  std::size_t feasible = 0;
  for (const auto& [start, run] : runs) {
    feasible += run.first_feasible ? 1 : 0;
    if (start != best->first) plot.series.push_back({"", run.points, {}, rgb(0x9db2c4, 0.75), Marker::none, 1});
  }
  plot.subtitle = std::to_string(runs.size()) + (runs.size() == 1 ? " start" : " starts") + ", " +
                  std::to_string(feasible) + " feasible";
  if (!plot.series.empty()) plot.series.front().label = "other starts";
  if (best != runs.end()) {
    const Run& run = best->second;
    plot.series.push_back(
        {"start " + std::to_string(best->first) + " (best)", run.points, {}, rgb(0x1f4e79), Marker::none, 2});
    if (run.first_feasible)
      plot.annotations.push_back({*run.first_feasible, "feasible at " + fixed(run.first_feasible->x, 0), ink::kGood});
  }
  return draw_plot(plot);
}

}  // namespace inhabit::render
