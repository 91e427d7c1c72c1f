#include <algorithm>
#include <array>

#include "core/text.h"
#include "exemplar/learn.h"
#include "session/bench.h"
#include "session/exemplar_scenes.h"
#include "session/furnish_methods.h"

/// Furniture arrangement learned from examples, beside Yu et al. 2011 table 1: its seven scenes at its numbers of
/// iterations, what the arrangements are worth, and what a move costs as rooms grow.
namespace inhabit::session {
namespace {

/// A scene of the paper to be furnished, with what its five exemplars taught.
struct Lesson {
  std::vector<Scene> inputs;
  Priors priors;
};

Result<Lesson> lesson_of(const ExemplarScene& scene) {
  std::vector<Scene> rooms;
  for (int k = 1; k <= kExemplars; ++k) rooms.push_back(exemplar_room(scene, k));
  exemplar::LearnOptions options;
  for (const auto& [first, second] : scene.pairs) options.pairs.emplace_back(first, second);
  Result<exemplar::Learned> learned = exemplar::learn(rooms, options);
  if (!learned) return learned.error();
  Lesson lesson;
  lesson.priors = std::move(learned->priors);
  for (int k = 1; k <= scene.inputs; ++k) lesson.inputs.push_back(exemplar_input(scene, k));
  return lesson;
}

struct Timing {
  double milliseconds = 0, cost = 0;
};
/// One start on one thread.
Result<Timing> time_of(const Scene& scene, const Priors& priors, std::uint64_t seed, std::int64_t iterations) {
  const annealing::Targets targets = annealing::choose_targets(scene, priors, seed);
  annealing::Options options;
  options.seed = seed, options.threads = 1, options.iterations = iterations, options.given = false;
  options.weights.learned = priors.weights;
  const double begin = processor_milliseconds();
  const Result<annealing::Outcome> outcome = annealing::arrange(scene, targets, options);
  if (!outcome) return outcome.error();
  return Timing{processor_milliseconds() - begin, outcome->best.cost};
}

Result<Table> times_table(const BenchOptions& options, int seeds) {
  Table table{
      "anneal", "Table 1 of Make it Home: one start on one thread at the published numbers of iterations", {}, {}, {}};
  table.columns = {{"scene"},        {"objects", 0}, {"iterations", 0}, {"paper s", 0},
                   {"median ms", 1}, {"ratio", 0},   {"us a move", 2},  {"cost", 2}};
  for (const ExemplarScene& scene : exemplar_scenes()) {
    const Result<Lesson> lesson = lesson_of(scene);
    if (!lesson) return lesson.error();
    std::vector<double> times, costs;
    for (int seed = 1; seed <= seeds; ++seed) {
      if (options.cancel && options.cancel->requested()) break;
      const Result<Timing> t =
          time_of(lesson->inputs.front(), lesson->priors, static_cast<std::uint64_t>(seed), scene.iterations);
      if (!t) return t.error();
      times.push_back(t->milliseconds), costs.push_back(t->cost);
    }
    const double ms = median(times);
    table.rows.push_back({std::string(scene.name), static_cast<double>(lesson->inputs.front().objects.size()),
                          1.0 * scene.iterations, scene.seconds, ms, ms > 0 ? Cell(1000 * scene.seconds / ms) : Cell(),
                          1000 * ms / scene.iterations, median(costs)});
  }
  table.notes = {"seeds: " + std::to_string(seeds) + "; published: one 3.33 GHz Xeon"};
  return table;
}

/// Shares of runs in which something is as it should be.
struct Tally {
  int runs = 0, bodies = 0, doors = 0, reachable = 0, views = 0, all = 0;
  std::vector<double> times;
  void add(const Faults& f, double milliseconds) {
    ++runs, bodies += f.bodies == 0, doors += f.doors == 0, reachable += f.unreachable == 0, views += f.views == 0;
    all += f.none();
    times.push_back(milliseconds);
  }
  std::vector<Cell> row(std::string scene, std::string method) const {
    const auto share = [&](int n) { return Cell(100.0 * n / std::max(1, runs)); };
    return {std::move(scene), std::move(method), share(bodies), share(doors),         share(reachable),
            share(views),     share(all),        median(times), quantile(times, 0.95)};
  }
};

Result<Table> results_table(const BenchOptions& options, int seeds) {
  Table table{"anneal-results", "What the arrangements are worth: share of runs, one start each", {}, {}, {}};
  table.columns = {{"scene"},           {"method"},   {"bodies apart %", 0}, {"doors free %", 0}, {"reachable %", 0},
                   {"views free %", 0}, {"all %", 0}, {"median ms", 1},      {"p95 ms", 1}};
  constexpr std::array<std::pair<Method, const char*>, 3> kMethods = {
      std::pair{Method::pbd, "pbd"}, {Method::anneal, "anneal"}, {Method::both, "both"}};
  for (const ExemplarScene& scene : exemplar_scenes()) {
    const Result<Lesson> lesson = lesson_of(scene);
    if (!lesson) return lesson.error();
    for (const auto& [method, name] : kMethods) {
      Tally tally;
      for (int seed = 1; seed <= seeds; ++seed) {
        if (options.cancel && options.cancel->requested()) break;
        FurnishJob job;
        job.method = method, job.priors = lesson->priors;
        job.anneal.weights.learned = lesson->priors.weights, job.anneal.given = false;
        job.layout.seed = static_cast<std::uint64_t>(seed), job.layout.threads = 1, job.layout.starts = 1;
        const Scene& input = lesson->inputs[static_cast<std::size_t>(seed) % lesson->inputs.size()];
        const double begin = processor_milliseconds();
        const Result<Found> found =
            method == Method::pbd ? furnish_by_projection(input, job) : furnish_by_annealing(input, job);
        if (!found) return found.error();
        const Suggestion& s = found->list.front();
        tally.add(faults_of(s.scene, s.report), processor_milliseconds() - begin);
        if (options.progress) options.progress(static_cast<double>(seed) / seeds, scene.name);
      }
      table.rows.push_back(tally.row(std::string(scene.name), name));
    }
  }
  table.notes = {
      "seeds: " + std::to_string(seeds) +
          "; times with the check that judges every run; both: annealed and settled, again from another start "
          "while something is wrong, fourteen times at most",
      "reachable: all that stand on the floor and want free space before them"};
  return table;
}

/// A room with `factor` times the floor and the things of this one, the doors where they were in proportion.
Scene grown(const Scene& scene, double factor) {
  Scene result = scene;
  const double s = std::sqrt(factor);
  for (Vec2& p : result.space.outline) p = s * p;
  for (Hole& hole : result.space.holes)
    for (Vec2& p : hole.outline) p = s * p;
  for (Door& door : result.space.doors) door.from *= s;
  result.space.windows.clear();
  result.objects.clear();
  const double n = static_cast<double>(scene.objects.size());
  for (std::size_t k = 0; k < static_cast<std::size_t>(n * factor); ++k) {
    // Small rooms get a bit of everything.
    const double place = factor < 1 ? static_cast<double>(k) / factor : std::fmod(static_cast<double>(k), n);
    const auto i = std::min(static_cast<std::size_t>(place), scene.objects.size() - 1);
    result.objects.push_back(scene.objects[i]);
    if (!result.objects.back().on.none()) result.objects.back().on = {};
    result.objects.back().id += "-" + std::to_string(k);
  }
  result.constraints = {}, result.groups.clear();
  return result;
}

Result<BenchGroup> growth(const BenchOptions& options) {
  BenchGroup group;
  Table table{"anneal-growth", "What a move costs as the flower shop grows, one thread", {}, {}, {}};
  table.columns = {{"objects", 0}, {"us a move", 3}, {"per doubling %", 1}};
  BenchCurve curve{"anneal-growth", "A move in a growing flower shop", "objects", "microseconds", true, true, {}};
  curve.lines.push_back({"inhabit", {}, {}});
  const ExemplarScene* shop = find_exemplar_scene("flower-shop");
  const Result<Lesson> lesson = lesson_of(*shop);
  if (!lesson) return lesson.error();
  double before = 0;
  for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    if (options.cancel && options.cancel->requested()) break;
    const Scene scene = grown(lesson->inputs.front(), factor);
    double least = 1e300;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      // The difference of two runs: setting up does not count.
      const Result<Timing> brief = time_of(scene, lesson->priors, seed, 1000);
      if (!brief) return brief.error();
      const Result<Timing> whole = time_of(scene, lesson->priors, seed, 101000);
      if (!whole) return whole.error();
      least = std::min(least, (whole->milliseconds - brief->milliseconds) / 100);
    }
    const auto n = static_cast<double>(scene.objects.size());
    table.rows.push_back({n, least, before > 0 ? Cell(100 * (least / before - 1)) : Cell()});
    curve.lines[0].x.push_back(n), curve.lines[0].y.push_back(least);
    before = least;
  }
  table.notes = {
      "the fastest of 3 seeds, 100,000 moves each; doubling the objects and the floor, 100 % would be linear"};
  group.tables.push_back(std::move(table)), group.curves.push_back(std::move(curve));
  return group;
}

}  // namespace

Result<BenchGroup> bench_anneal(const BenchOptions& options) {
  const int seeds = options.seeds_given ? options.seeds : 50;
  Result<Table> times = times_table(options, std::min(seeds, 10));
  if (!times) return times.error();
  Result<BenchGroup> group = growth(options);
  if (!group) return group.error();
  Result<Table> results = results_table(options, seeds);
  if (!results) return results.error();
  group->tables.insert(group->tables.begin(), std::move(*times));
  group->tables.push_back(std::move(*results));
  return group;
}

}  // namespace inhabit::session
