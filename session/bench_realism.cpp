#include <cmath>

#include "core/text.h"
#include "crowd/measures/fundamental.h"
#include "io/trajectory_table.h"
#include "session/bench.h"
#include "session/crowd_scenes.h"
#include "session/realism.h"

namespace inhabit::session {
namespace {

constexpr double kDensities[] = {0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5};
constexpr double kWidths[] = {0.5, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.6, 4.4, 5};
constexpr double kSlice = 0.25;

struct Runs {
  const BenchOptions& options;
  int seeds() const { return options.seeds_given ? options.seeds : 5; }
  bool stop() const { return options.cancel && options.cancel->requested(); }
  SimulateJob job(int seed) const {
    SimulateJob job;
    job.model.set = options.set, job.seed = static_cast<std::uint64_t>(seed), job.cancel = options.cancel;
    return job;
  }
  void say(double share, std::string what) const {
    if (options.progress) options.progress(share, std::move(what));
  }
};

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? crowd::kUnknown : sum / static_cast<double>(values.size());
}

/// Sample standard deviation; 0 for one value.
double deviation(const std::vector<double>& values) {
  const double m = mean(values);
  double sum = 0;
  for (const double v : values) sum += (v - m) * (v - m);
  return values.size() < 2 ? 0 : std::sqrt(sum / static_cast<double>(values.size() - 1));
}

Cell cell(double value) { return value == value ? Cell(value) : Cell(); }

BenchCurve::Line medians_of(const std::string& name, const std::vector<crowd::FundamentalPoint>& points) {
  BenchCurve::Line line{name, {}, {}};
  for (const crowd::DensityBin& bin : crowd::density_bins(points, kSlice))
    if (bin.count >= 5) line.x.push_back(bin.density), line.y.push_back(bin.median);
  return line;
}

BenchCurve::Line weidmann_line() {
  BenchCurve::Line line{"Weidmann", {}, {}};
  for (double d = 0.25; d <= 5.25; d += 0.25) line.x.push_back(d), line.y.push_back(crowd::weidmann_speed(d));
  return line;
}

Status speed_density(const Runs& runs, BenchGroup& group) {
  Table table{"realism-speed", "One-way flow in a corridor 5 m wide beside Weidmann's curve", {}, {}, {}};
  table.columns = {{"density"},         {"speed m/s", 3}, {"sd", 3},
                   {"Weidmann m/s", 3}, {"error m/s", 3}, {"flow 1/(m s)", 2}};
  std::vector<std::vector<crowd::FundamentalPoint>> of_seed(static_cast<std::size_t>(runs.seeds()));
  BenchCurve::Line line{"simulated", {}, {}};
  for (const double density : kDensities) {
    std::vector<double> densities, speeds;
    for (int seed = 1; seed <= runs.seeds() && !runs.stop(); ++seed) {
      runs.say(density / 5, "corridor");
      const auto point = corridor_point(density, runs.job(seed));
      if (!point) return point.error();
      densities.push_back(point->density), speeds.push_back(point->speed);
      of_seed[static_cast<std::size_t>(seed - 1)].push_back(*point);
    }
    const double d = mean(densities), v = mean(speeds), w = crowd::weidmann_speed(d);
    table.rows.push_back({cell(d), cell(v), cell(deviation(speeds)), cell(w), cell(v - w), cell(d * v)});
    line.x.push_back(d), line.y.push_back(v);
  }
  std::vector<double> errors;
  for (const auto& points : of_seed) errors.push_back(crowd::weidmann_rmse(points));
  table.notes = {"root mean square of the errors: " + fixed(mean(errors), 3) + " m/s, +- " +
                 fixed(deviation(errors), 3) + " over " + std::to_string(runs.seeds()) + " seeds; target 0.1"};
  group.tables.push_back(std::move(table));
  group.curves.push_back({"realism-speed",
                          "Speed by density, one-way",
                          "density [1/m²]",
                          "speed [m/s]",
                          false,
                          false,
                          {std::move(line), weidmann_line()}});
  return Done{};
}

Status flow_by_width(const Runs& runs, BenchGroup& group) {
  std::vector<crowd::FundamentalPoint> published;
  if (!runs.options.data.empty()) {
    auto flows = published_flows(runs.options.data);
    if (!flows) return flows.error();
    published = std::move(*flows);
  }
  Table table{"realism-flow", "Flow through bottlenecks 1 m long", {}, {}, {}};
  table.columns = {{"width m"}, {"flow 1/s", 3}, {"sd", 3}, {"flow 1/(m s)", 3}, {"published least", 3},
                   {"most", 3}, {"points", 0},   {"within"}};
  BenchCurve::Line line{"simulated", {}, {}};
  double low = 1e300, high = 0;
  for (const auto& p : published) low = std::min(low, p.speed / p.density), high = std::max(high, p.speed / p.density);
  for (const double width : kWidths) {
    std::vector<double> flows;
    for (int seed = 1; seed <= runs.seeds() && !runs.stop(); ++seed) {
      runs.say(width / 5, "bottleneck");
      const Result<double> flow = bottleneck_flow(width, runs.job(seed));
      if (!flow) return flow.error();
      flows.push_back(*flow);
    }
    const double specific = mean(flows) / width;
    std::vector<Cell> row = {width, cell(mean(flows)), cell(deviation(flows)), cell(specific)};
    const PublishedFlow near = published_near(published, width);
    if (near.count > 0) {
      row.insert(row.end(), {near.low, near.high, static_cast<double>(near.count)});
      row.push_back(Cell::truth(specific >= near.low && specific <= near.high));
    }
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
    line.x.push_back(width), line.y.push_back(mean(flows));
  }
  if (published.empty())
    table.notes = {"published flows are skipped: no data folder (--data or INHABIT_DATA)"};
  else
    table.notes = {"published: flow per metre of the five experiments at widths within 0.15 m; all of them: " +
                   fixed(low, 2) + " to " + fixed(high, 2)};
  BenchCurve curve{"realism-flow", "Flow by width of bottlenecks", "width [m]", "flow [1/s]", false, false, {line}};
  BenchCurve::Line points{"published", {}, {}};
  std::ranges::sort(published, {}, &crowd::FundamentalPoint::density);
  for (const auto& p : published) points.x.push_back(p.density), points.y.push_back(p.speed);
  if (!published.empty()) curve.lines.push_back(std::move(points));
  group.tables.push_back(std::move(table)), group.curves.push_back(std::move(curve));
  return Done{};
}

/// Mean of |difference| of the times at which the k-th passes; unknown without both.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t n = std::min(a.size(), b.size());
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += std::abs(a[k] - b[k]);
  return n == 0 ? crowd::kUnknown : sum / static_cast<double>(n);
}

struct Recorded {
  std::vector<double> times;
  double first = 0;  ///< entry, seconds
};

Status experiment(const Runs& runs, const RecordedExperiment& e, Table& table,
                  std::vector<crowd::FundamentalPoint>& ours, std::vector<crowd::FundamentalPoint>& theirs) {
  Scene scene = find_crowd_scene(e.scene)->build();
  const double limit = 2 * scene.crowd.seconds;
  Recorded recorded;
  const bool one_way = e.name.starts_with("one-way") && e.line.length() < 4;
  const crowd::MeasureLine inside{{1.8, 0}, {0, 0}};
  if (!runs.options.data.empty()) {
    const std::filesystem::path path = std::filesystem::path(runs.options.data) / "pedestrians/juelich" / e.file;
    Result<scene::Trajectories> t = io::read_trajectories(path, e.reading);
    if (!t) return t.error();
    recorded = {passing_times(*t, e.line), t->fixes.front().frame / t->frame_rate};
    scene = entering_as_recorded(std::move(scene), *t);
    t->walkable = {{find_crowd_scene(e.scene)->build().space.outline, {}}};
    if (one_way) {
      const auto more = steady_diagram(*t, inside);
      theirs.insert(theirs.end(), more.begin(), more.end());
    }
  }
  std::vector<double> times, people, differences;
  for (int seed = 1; seed <= runs.seeds() && !runs.stop(); ++seed) {
    runs.say(static_cast<double>(seed) / runs.seeds(), std::string(e.name));
    const auto t = walked(scene, limit, runs.job(seed));
    if (!t) return t.error();
    const std::vector<double> passed = passing_times(*t, e.line);
    people.push_back(static_cast<double>(passed.size()));
    times.push_back(passed.empty() ? limit : passed.back() - recorded.first);
    differences.push_back(apart(passed, recorded.times));
    if (one_way) {
      const auto more = steady_diagram(*t, inside);
      ours.insert(ours.end(), more.begin(), more.end());
    }
  }
  std::vector<Cell> row = {std::string(e.name), cell(mean(people)), cell(mean(times)), cell(deviation(times))};
  if (!recorded.times.empty()) {
    const double theirs_all = recorded.times.back() - recorded.first;
    row.insert(row.end(), {static_cast<double>(recorded.times.size()), theirs_all, 100 * (mean(times) / theirs_all - 1),
                           cell(mean(differences))});
  }
  row.resize(table.columns.size());
  table.rows.push_back(std::move(row));
  return Done{};
}

Status experiments(const Runs& runs, BenchGroup& group) {
  Table table{"realism-experiments", "Experiments: from the first entry to the last passage of a line", {}, {}, {}};
  table.columns = {{"experiment"},  {"through", 1}, {"time s", 1},  {"sd", 1},
                   {"recorded", 0}, {"time s ", 1}, {"error %", 1}, {"k-th passage s", 2}};
  std::vector<crowd::FundamentalPoint> ours, theirs;
  for (const RecordedExperiment& e : recorded_experiments())
    if (Status s = experiment(runs, e, table, ours, theirs); !s) return s;
  table.notes = {
      runs.options.data.empty()
          ? "recordings are skipped: no data folder (--data or INHABIT_DATA); people enter evenly"
          : "people enter where and when they do in the recording; k-th passage: mean difference of the times "
            "at which the k-th person passes"};
  BenchCurve curve{"realism-corridors",
                   "Speed by density in corridors 1.8 m wide",
                   "density [1/m²]",
                   "speed [m/s]",
                   false,
                   false,
                   {medians_of("simulated", ours)}};
  if (!theirs.empty()) {
    curve.lines.push_back(medians_of("recorded", theirs));
    const crowd::CurveComparison c =
        crowd::compare_curves(crowd::density_bins(ours, kSlice), crowd::density_bins(theirs, kSlice), 5);
    table.notes.push_back("corridors of 1.8 m, median Voronoi speeds in " + std::to_string(c.bins) +
                          " slices of density: mean difference to the recordings " + fixed(c.mean, 3) +
                          " m/s, root mean square " + fixed(c.rmse, 3));
  }
  curve.lines.push_back(weidmann_line());
  group.tables.push_back(std::move(table)), group.curves.push_back(std::move(curve));
  return Done{};
}

Status single_file(const Runs& runs, BenchGroup& group) {
  Table table{"realism-single-file", "Single file in a ring of 18 m (ours) and 17.7 to 18.9 m", {}, {}, {}};
  table.columns = {{"people", 0}, {"density 1/m", 2},  {"speed m/s", 3},
                   {"sd", 3},     {"recorded 1/m", 2}, {"speed m/s ", 3}};
  std::vector<crowd::FundamentalPoint> ours, theirs;
  const auto middle = [](const std::vector<crowd::FundamentalPoint>& points) {
    std::vector<double> d, v;
    for (const auto& p : points) d.push_back(p.density), v.push_back(p.speed);
    return points.empty() ? crowd::FundamentalPoint{crowd::kUnknown, crowd::kUnknown}
                          : crowd::FundamentalPoint{median(d), median(v)};
  };
  for (const int people : {14, 20, 30}) {
    std::vector<double> densities, speeds;
    for (int seed = 1; seed <= runs.seeds() && !runs.stop(); ++seed) {
      runs.say(people / 30.0, "single file");
      const auto t = walked(experiment_single_file(people), 60, runs.job(seed));
      if (!t) return t.error();
      const auto points = ring_points(*t, true);
      densities.push_back(middle(points).density), speeds.push_back(middle(points).speed);
      ours.insert(ours.end(), points.begin(), points.end());
    }
    std::vector<Cell> row = {static_cast<double>(people), cell(mean(densities)), cell(mean(speeds)),
                             cell(deviation(speeds))};
    if (!runs.options.data.empty()) {
      const auto path = std::filesystem::path(runs.options.data) / "pedestrians/juelich/single_file/subaih2019" /
                        ("UX_" + std::to_string(people) + "_1.txt");
      const auto t = io::read_trajectories(path, {io::LengthUnit::metres, 25, {}});
      if (!t) return t.error();
      const auto points = ring_points(*t, false);
      row.insert(row.end(), {cell(middle(points).density), cell(middle(points).speed)});
      theirs.insert(theirs.end(), points.begin(), points.end());
    }
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  BenchCurve curve{
      "realism-single-file",          "Speed by density in single file", "density [1/m]", "speed [m/s]", false, false,
      {medians_of("simulated", ours)}};
  if (!theirs.empty()) curve.lines.push_back(medians_of("recorded", theirs));
  group.tables.push_back(std::move(table)), group.curves.push_back(std::move(curve));
  return Done{};
}

}  // namespace

Result<BenchGroup> bench_realism(const BenchOptions& options) {
  const Runs runs{options};
  BenchGroup group;
  for (Status (*part)(const Runs&, BenchGroup&) : {speed_density, flow_by_width, experiments, single_file}) {
    if (runs.stop()) break;
    if (Status s = part(runs, group); !s) return s.error();
  }
  return group;
}

}  // namespace inhabit::session
