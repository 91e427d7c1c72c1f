#include <algorithm>

#include "session/bench.h"
#include "session/layout_walk.h"
#include "session/paper_scenes.h"

/// Position-based layout synthesis beside simulated annealing, with the same energy from the same starts on the same
/// machine: the comparison of TVCG table 1 and fig. 17, thesis table 6.2 and fig. 6.16.
namespace inhabit::session {
namespace {

/// One run: what came of it, how long it took, and its energy on the way.
struct Run {
  layout::Layout layout;
  std::vector<layout::TraceRow> rows;
  double milliseconds = 0;

  double at(const layout::TraceRow& row) const {
    return layout.iterations > 0 ? milliseconds * std::min(1.0, 1.0 * row.iteration / layout.iterations) : milliseconds;
  }
  /// Milliseconds until the energy was first this low; nothing when it never was.
  std::optional<double> to_energy(double energy) const {
    for (const layout::TraceRow& row : rows)
      if (row.energy <= energy) return at(row);
    return layout.energy <= energy ? std::optional(milliseconds) : std::nullopt;
  }
  std::optional<double> to_feasible() const {
    for (const layout::TraceRow& row : rows)
      if (row.feasible) return at(row);
    return layout.feasible ? std::optional(milliseconds) : std::nullopt;
  }
};

/// A method: the scene and a seed to a layout, with a trace when there is a place for it.
using Method = std::function<Result<layout::Layout>(const Scene&, std::uint64_t, std::vector<layout::TraceRow>*)>;

/// Runs it twice: once for the clock, once for the trace, which takes time of its own.
Result<Run> timed(const Method& method, const Scene& scene, std::uint64_t seed) {
  Run run;
  const double begin = processor_milliseconds();
  const Result<layout::Layout> first = method(scene, seed, nullptr);
  run.milliseconds = processor_milliseconds() - begin;
  if (!first) return first.error();
  const Result<layout::Layout> second = method(scene, seed, &run.rows);
  if (!second) return second.error();
  run.layout = *second;
  return run;
}

Method projection(const BenchOptions& options, bool paper) {
  return [&options, paper](const Scene& scene, std::uint64_t seed,
                           std::vector<layout::TraceRow>* trace) -> Result<layout::Layout> {
    layout::Options o = options.layout;
    o.seed = seed, o.starts = 1, o.threads = 1, o.paper = paper, o.start = layout::Start::random;
    o.trace = trace != nullptr, o.cancel = options.cancel;
    Result<layout::Outcome> outcome = layout::furnish(scene, o);
    if (!outcome) return outcome.error();
    if (trace != nullptr) *trace = std::move(outcome->trace);
    return std::move(outcome->best);
  };
}

Method annealing_of(const BenchOptions& options) {
  return [&options](const Scene& scene, std::uint64_t seed, std::vector<layout::TraceRow>* trace) {
    BaselineOptions o;
    o.seed = seed, o.trace = trace, o.cancel = options.cancel;
    return anneal_layout(scene, o);
  };
}

/// What two methods came to over the seeds of one scene.
struct Duel {
  std::vector<double> times, against_times, energies, against_energies;
  std::vector<double> energy_ratios, feasible_ratios;
  int runs = 0, feasible = 0, against_feasible = 0, reached = 0;

  void add(const Run& run, const Run& against) {
    ++runs;
    times.push_back(run.milliseconds), against_times.push_back(against.milliseconds);
    energies.push_back(run.layout.energy), against_energies.push_back(against.layout.energy);
    const auto feasible_at = run.to_feasible(), against_at = against.to_feasible();
    feasible += run.layout.feasible, against_feasible += against_at.has_value();
    reached += against.to_energy(run.layout.energy).has_value();
    // The energy that both came down to.
    const double common = std::max(run.layout.energy, against.layout.energy) * (1 + 1e-9);
    const auto one = run.to_energy(common), other = against.to_energy(common);
    if (one && other && *one > 0) energy_ratios.push_back(*other / *one);
    if (feasible_at && against_at && *feasible_at > 0) feasible_ratios.push_back(*against_at / *feasible_at);
  }
};

Cell ratio_of(const std::vector<double>& ratios) { return ratios.empty() ? Cell() : Cell(median(ratios)); }

std::vector<Cell> duel_row(const PaperScene& paper, const Duel& d, std::size_t objects) {
  const double ours = median(d.times), theirs = median(d.against_times);
  const bool published = paper.annealing_seconds > 0;
  return {std::string(paper.name),
          static_cast<double>(objects),
          ours,
          theirs,
          ours > 0 ? Cell(theirs / ours) : Cell(),
          published ? Cell(paper.annealing_seconds / paper.published_seconds) : Cell(),
          median(d.energies),
          median(d.against_energies),
          ratio_of(d.energy_ratios),
          100.0 * d.reached / std::max(1, d.runs),
          100.0 * d.feasible / std::max(1, d.runs),
          100.0 * d.against_feasible / std::max(1, d.runs),
          ratio_of(d.feasible_ratios)};
}

Table duel_table(std::string id, std::string title) {
  Table table{std::move(id), std::move(title), {}, {}, {}};
  table.columns = {{"scene"},         {"objects", 0},       {"ms", 3},          {"annealing ms", 2}, {"ratio", 1},
                   {"published", 1},  {"energy", 3},        {"annealing's", 3}, {"same energy", 1},  {"reached %", 0},
                   {"feasible %", 0}, {"annealing's %", 0}, {"to feasible", 1}};
  return table;
}

void add_curves(std::vector<BenchCurve>& curves, const PaperScene& paper, std::span<const Run> runs) {
  constexpr std::array<const char*, 3> kNames = {"position-based", "position-based, the papers' scheme", "annealing"};
  const std::string name(paper.name);
  BenchCurve by_iteration{
      "against-" + name + "-iterations", name + ": energy by iteration", "iteration", "energy", true, true, {}};
  BenchCurve by_time{"against-" + name + "-seconds", name + ": energy by time", "seconds", "energy", true, true, {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    BenchCurve::Line steps{kNames[k], {}, {}}, times{kNames[k], {}, {}};
    double last = 0;
    for (const layout::TraceRow& row : runs[k].rows) {
      // About forty points a decade are all that can be seen.
      if (row.iteration < last * 1.06 || row.iteration == 0) continue;
      last = row.iteration;
      steps.x.push_back(row.iteration), steps.y.push_back(row.energy);
      times.x.push_back(runs[k].at(row) / 1000), times.y.push_back(row.energy);
    }
    by_iteration.lines.push_back(std::move(steps)), by_time.lines.push_back(std::move(times));
  }
  curves.push_back(std::move(by_iteration)), curves.push_back(std::move(by_time));
}

}  // namespace

Result<BenchGroup> bench_against(const BenchOptions& options) {
  Table ours = duel_table("against", "Position-based with relocation beside SA-McMC, the same random starts");
  Table papers =
      duel_table("against-paper", "The papers' position-based scheme beside SA-McMC, the same random starts");
  BenchGroup group;
  const std::array methods = {projection(options, false), projection(options, true), annealing_of(options)};
  const int seeds = options.seeds_given ? options.seeds : 10;  // "the mean of 10 runs"
  for (const PaperScene& paper : paper_scenes()) {
    if (paper.annealing_seconds <= 0) continue;
    const Scene scene = paper.build();
    Duel duel, paper_duel;
    for (int seed = 1; seed <= seeds; ++seed) {
      if (options.cancel && options.cancel->requested()) break;
      std::vector<Run> runs;
      for (const Method& method : methods) {
        Result<Run> run = timed(method, scene, static_cast<std::uint64_t>(seed));
        if (!run) return run.error();
        runs.push_back(std::move(*run));
      }
      duel.add(runs[0], runs[2]), paper_duel.add(runs[1], runs[2]);
      if (seed == 1) add_curves(group.curves, paper, runs);
      if (options.progress) options.progress(static_cast<double>(seed) / seeds, paper.name);
    }
    ours.rows.push_back(duel_row(paper, duel, scene.objects.size()));
    papers.rows.push_back(duel_row(paper, paper_duel, scene.objects.size()));
  }
  ours.notes = {
      "seeds: " + std::to_string(seeds) +
          "; medians; one thread; annealing: 20,000 iterations, linear schedule, ends when "
          "1,500 iterations brought less than 0.1 %",
      "published: ratio of the printed times; same energy: ratio of the times to the lowest energy that both reached",
      "reached: share of annealing's runs that came down to the final energy of the position-based run",
      "to feasible: ratio of the times to the first layout without overlaps, where both found one"};
  group.tables = {std::move(ours), std::move(papers)};
  return group;
}

}  // namespace inhabit::session
