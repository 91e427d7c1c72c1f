#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "crowd/measures/spread.h"
#include "session/bench.h"
#include "session/crowd_scenes.h"
#include "session/emergence.h"

/// What crowds do by themselves: that all arrive, lanes, arches, a group that keeps its shape, the light who give way.
namespace inhabit::session {
namespace {

using geometry::Vec2;

/// Of each scene: a hundred would show the same and take hours.
constexpr int kMostSeeds = 20;

/// A row: a scene with a choice of the model.
struct Case {
  std::string scene, far;
  std::vector<std::string> set = {};
  std::string words() const {
    std::string all = far;
    for (const std::string& s : set) all += (all.empty() ? "" : ", ") + s;
    return all.empty() ? "contact only" : all;
  }
};

struct Seeds {
  std::vector<EmergentRun> runs;
  std::optional<Error> error;
};

using Watch = std::function<void(std::size_t seed, const crowd::Simulation&)>;

/// Runs of seeds 1 … n, several at once; `watch` is called from several threads, for one seed from one.
Seeds run_seeds(const scene::Scene& scene, const Case& row, const BenchOptions& options, const Watch& watch) {
  const auto count = static_cast<std::size_t>(std::min(options.seeds, kMostSeeds));
  std::vector<std::optional<Result<EmergentRun>>> results(count);
  std::atomic<int> done = 0;
  parallel_for(count, 0, [&](std::size_t k) {
    SimulateJob job;
    job.model.far = row.far, job.model.set = row.set, job.seed = k + 1, job.cancel = options.cancel;
    if (std::holds_alternative<scene::PbdModel>(scene.crowd.model))
      job.model.set.insert(job.model.set.end(), options.set.begin(), options.set.end());
    results[k] = emergent_run(scene, job, [&](const crowd::Simulation& s) {
      if (watch) watch(k, s);
    });
    if (options.progress && ++done % 2 == 0)
      options.progress(static_cast<double>(done) / static_cast<double>(count), scene.name);
  });
  Seeds seeds;
  for (auto& result : results) {
    if (!*result) return {{}, result->error()};
    seeds.runs.push_back(**result);
  }
  return seeds;
}

struct Statistics {
  double mean = 0, deviation = 0, least = 0, most = 0;
};
Statistics statistics(const std::vector<double>& values) {
  Statistics s;
  if (values.empty()) return s;
  const double n = static_cast<double>(values.size());
  for (const double v : values) s.mean += v / n;
  for (const double v : values) s.deviation += (v - s.mean) * (v - s.mean) / n;
  s.deviation = std::sqrt(s.deviation);
  s.least = *std::ranges::min_element(values), s.most = *std::ranges::max_element(values);
  return s;
}

Table arrivals_table() {
  Table table{"emergence", "Who arrives, and the deepest overlap after any step", {}, {}, {}};
  table.columns = {{"scene"},          {"far"},    {"people", 0}, {"seeds", 0},     {"seeds with all", 0},
                   {"not arrived", 0}, {"last s"}, {"worst %"},   {"into walls mm"}};
  table.notes = {
      "last: the last arrival, median of the seeds with all; worst: overlap over the radii's sum, all seeds"};
  return table;
}

void add_arrivals(Table& table, const Case& row, const Seeds& seeds) {
  std::vector<double> last;
  double all = 0, missing = 0, worst = 0, wall = 0;
  for (const EmergentRun& run : seeds.runs) {
    if (run.all()) ++all, last.push_back(run.last);
    missing += static_cast<double>(run.people - run.arrived);
    worst = std::max(worst, run.worst.share), wall = std::max(wall, run.worst.wall);
  }
  table.rows.push_back({row.scene, row.words(), static_cast<double>(seeds.runs.front().people),
                        static_cast<double>(seeds.runs.size()), all, missing,
                        last.empty() ? Cell() : Cell(median(last)), 100 * worst, 1e3 * wall});
}

// Lanes.

using LaneRows = std::vector<std::vector<LaneMoment>>;  ///< [seed][second], as long as all are there

/// The moment when the groups lie on each other.
const LaneMoment& amid(const std::vector<LaneMoment>& rows) {
  return *std::ranges::min_element(rows, {}, &LaneMoment::apart);
}

Table lanes_table() {
  Table table{"emergence-lanes", "Lanes: order while two groups lie on each other", {}, {}, {}};
  table.columns = {{"scene"},    {"far"},          {"at start", 3}, {"narrow", 3},   {"deviation", 3},
                   {"least", 3}, {"by chance", 3}, {"wide", 3},     {"by chance", 3}};
  table.notes = {
      "order parameter [Rex07, Nowak12] of bands of 0.4 m (narrow) and 2 m (wide) either way, mean of the seeds",
      "by chance: the same places with the ways dealt out anew; at start rows of both groups face each other"};
  return table;
}

void add_lanes(Table& table, BenchCurve& curve, const Case& row, const LaneRows& seeds, bool drawn) {
  std::vector<double> start, narrow, wide, narrow_chance, wide_chance;
  for (const std::vector<LaneMoment>& rows : seeds) {
    if (rows.empty()) continue;
    const LaneMoment& moment = amid(rows);
    start.push_back(rows.front().narrow), narrow.push_back(moment.narrow), wide.push_back(moment.wide);
    narrow_chance.push_back(moment.narrow_chance), wide_chance.push_back(moment.wide_chance);
  }
  const Statistics n = statistics(narrow);
  table.rows.push_back({row.scene, row.words(), statistics(start).mean, n.mean, n.deviation, n.least,
                        statistics(narrow_chance).mean, statistics(wide).mean, statistics(wide_chance).mean});
  if (!drawn) return;
  BenchCurve::Line line{row.scene + ", " + row.words(), {}, {}}, chance{"by chance", {}, {}};
  for (std::size_t second = 0;; ++second) {
    std::vector<double> order, dealt;
    for (const auto& rows : seeds)
      if (second < rows.size()) order.push_back(rows[second].narrow), dealt.push_back(rows[second].narrow_chance);
    if (order.size() < seeds.size()) break;
    line.x.push_back(static_cast<double>(second)), line.y.push_back(statistics(order).mean);
    chance.x.push_back(static_cast<double>(second)), chance.y.push_back(statistics(dealt).mean);
  }
  curve.lines.push_back(std::move(line));
  if (curve.lines.size() == 1) curve.lines.push_back(std::move(chance));
}

// Arches.

Table arches_table() {
  Table table{"emergence-arches", "Arches and half discs before a bottleneck", {}, {}, {}};
  table.columns = {{"scene"},     {"width m", 0}, {"seeds", 0},  {"moments", 0},    {"with arch %", 1},    {"radius m"},
                   {"people", 0}, {"arch m/s"},   {"mouth m/s"}, {"unround start"}, {"unround in the jam"}};
  table.notes = {
      "arch: a half ring of people below 0.7 m/s, each touching the next, from wall to wall, within two widths of the "
      "opening's",
      "middle (crowd/measures/arches.h); moments: each second after 15 s with 100 people or more before the wall; "
      "medians",
      "mouth: speed in the half disc of the opening's width; unround: deviation over mean of the outermost people's "
      "distance"};
  return table;
}

void add_arches(Table& table, BenchCurve& curve, const scene::Scene& scene, double width,
                const std::vector<std::vector<JamMoment>>& seeds) {
  std::vector<double> radius, people, speed, mouth, start, jam;
  std::vector<double> speeds, covers, counts;
  double moments = 0;
  for (const std::vector<JamMoment>& rows : seeds)
    for (std::size_t second = 0; second < rows.size(); ++second) {
      const JamMoment& m = rows[second];
      if (second == 0) start.push_back(m.roundness);
      if (second < 15 || m.before < 100) continue;
      ++moments, jam.push_back(m.roundness);
      if (m.arch && m.arch->radius <= 2 * width) {
        radius.push_back(m.arch->radius), speed.push_back(m.arch->speed);
        people.push_back(static_cast<double>(m.arch->people.size()));
      }
      speeds.resize(m.speed.size()), covers.resize(m.speed.size()), counts.resize(m.speed.size());
      for (std::size_t k = 0; k < m.speed.size(); ++k) {
        if (!crowd::known(m.speed[k])) continue;
        speeds[k] += m.speed[k], covers[k] += m.cover[k], ++counts[k];
        if (static_cast<double>(k) + 1 <= width / 2) mouth.push_back(m.speed[k]);
      }
    }
  table.rows.push_back({scene.name, width, static_cast<double>(seeds.size()), moments,
                        moments > 0 ? 100 * static_cast<double>(radius.size()) / moments : 0, median(radius),
                        median(people), median(speed), median(mouth), median(start), median(jam)});
  BenchCurve::Line v{"speed [m/s], " + scene.name, {}, {}}, c{"share covered by bodies, " + scene.name, {}, {}};
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (counts[k] < moments / 2) continue;
    v.x.push_back(static_cast<double>(k) + 0.5), v.y.push_back(speeds[k] / counts[k]);
    c.x.push_back(static_cast<double>(k) + 0.5), c.y.push_back(covers[k] / counts[k]);
  }
  curve.lines.push_back(std::move(v)), curve.lines.push_back(std::move(c));
}

// The ellipse.

using Pictures = std::vector<std::vector<Vec2>>;  ///< [second][person]

bool all_there(const std::vector<Vec2>& places) {
  return std::ranges::all_of(places, [](Vec2 p) { return crowd::known(p); });
}

Table shape_table() {
  Table table{"emergence-shape", "An ellipse of 320 keeps its shape through 1,600", {}, {}, {}};
  table.columns = {{"moment"}, {"s", 0}, {"length m"}, {"width m"}, {"ratio", 3}, {"deviation", 3}, {"distortion m"}};
  table.notes = {
      "length and width: four standard deviations along the principal axes, the axes of an even ellipse",
      "the moment is the last second before somebody arrives; alone: the same people without the other group",
      "distortion: root mean square of how far people are from their places among the others, against the start"};
  return table;
}

void add_shapes(Table& table, const std::vector<Pictures>& among, const std::vector<Pictures>& alone) {
  struct Sums {
    std::vector<double> second, length, width, ratio, distortion;
  } start, end, free;
  const auto put = [](Sums& sums, const Pictures& pictures, std::size_t second) {
    const crowd::Spread spread = crowd::spread_of(pictures[second]);
    sums.second.push_back(static_cast<double>(second)), sums.ratio.push_back(spread.ratio());
    sums.length.push_back(4 * spread.longer), sums.width.push_back(4 * spread.shorter);
    sums.distortion.push_back(crowd::distortion(pictures[0], pictures[second]));
  };
  for (std::size_t seed = 0; seed < among.size(); ++seed) {
    std::size_t second = 0;
    const std::size_t most = std::min(among[seed].size(), alone[seed].size());
    while (second + 1 < most && all_there(among[seed][second + 1]) && all_there(alone[seed][second + 1])) ++second;
    put(start, among[seed], 0), put(end, among[seed], second), put(free, alone[seed], second);
  }
  const auto add = [&](const char* words, const Sums& sums) {
    const Statistics ratio = statistics(sums.ratio);
    table.rows.push_back({words, median(sums.second), median(sums.length), median(sums.width), ratio.mean,
                          ratio.deviation, median(sums.distortion)});
  };
  add("at the start", start), add("behind the others", end), add("alone, the same second", free);
}

// Bears and rabbits.

Table aside_table() {
  Table table{"emergence-aside", "Rabbits give way to bears: metres aside of the straight way", {}, {}, {}};
  table.columns = {{"who"},  {"far"},  {"rabbits, median"},  {"mean"}, {"95 %"}, {"bears, median"},
                   {"mean"}, {"95 %"}, {"mean over mean", 1}};
  table.notes = {"the farthest that each one came from the line on which he began; 1,024 rabbits, 128 bears a seed"};
  return table;
}

/// Who walks in a row about bears and rabbits.
struct Walk {
  const char* words;
  std::string far;
  bool rabbits, bears;
  double mass = 30;  ///< of a bear
};

void add_aside(Table& table, const Walk& walk, std::size_t rabbits, const std::vector<std::vector<double>>& seeds) {
  std::vector<double> groups[2];
  for (const auto& aside : seeds)
    for (std::size_t k = 0; k < aside.size(); ++k) groups[k < rabbits ? 0 : 1].push_back(aside[k]);
  std::vector<Cell> row = {walk.words, walk.far};
  for (const auto& group : groups)
    for (const double value : {median(group), statistics(group).mean, quantile(group, 0.95)})
      row.push_back(group.empty() ? Cell() : Cell(value));
  row.push_back(walk.rabbits && walk.bears ? Cell(statistics(groups[0]).mean / statistics(groups[1]).mean) : Cell());
  table.rows.push_back(std::move(row));
}

// The rows of the tables.

struct Emergence {
  const BenchOptions& options;
  Table arrivals = arrivals_table(), lanes = lanes_table(), arches = arches_table(), shapes = shape_table(),
        aside = aside_table();
  BenchCurve order{"lanes",    "Order of lanes while two groups pass, mean of the seeds",
                   "time [s]", "order, bands of 0.4 m",
                   false,      false,
                   {}};
  BenchCurve profile{"arches",
                     "Before the bottlenecks, mean over the jam",
                     "distance from the opening's middle [m]",
                     "m/s, share",
                     false,
                     false,
                     {}};

  std::size_t count() const { return static_cast<std::size_t>(std::min(options.seeds, kMostSeeds)); }
  bool stopped() const { return options.cancel && options.cancel->requested(); }
};

scene::Scene built(const std::string& name) { return find_crowd_scene(name)->build(); }

Status passing_row(Emergence& e, const Case& row) {
  LaneRows moments(e.count());
  scene::Scene scene = built(row.scene);
  if (!row.set.empty()) scene.crowd.seconds *= 4;
  const Seeds seeds = run_seeds(scene, row, e.options, [&](std::size_t k, const crowd::Simulation& s) {
    if (s.agents().size() == s.people()) moments[k].push_back(lane_moment(s, k));
  });
  if (seeds.error) return *seeds.error;
  add_arrivals(e.arrivals, row, seeds);
  add_lanes(e.lanes, e.order, row, moments, row.scene == "sparse-passing" || row.scene == "dense-passing");
  return Done{};
}

Status plain_row(Emergence& e, const Case& row) {
  const Seeds seeds = run_seeds(built(row.scene), row, e.options, {});
  if (seeds.error) return *seeds.error;
  add_arrivals(e.arrivals, row.far.empty() ? Case{row.scene, "power-law"} : row, seeds);
  return Done{};
}

Status aside_row(Emergence& e, const Walk& walk) {
  scene::Scene scene = built("bears-and-rabbits");
  scene.crowd.populations[1].mass = walk.mass;
  if (!walk.bears) scene.crowd.populations.pop_back();
  if (!walk.rabbits) scene.crowd.populations.erase(scene.crowd.populations.begin());
  const std::size_t rabbits = walk.rabbits ? 1024 : 0, people = rabbits + (walk.bears ? 128 : 0);
  std::vector<std::vector<double>> most(e.count(), std::vector<double>(people, 0));
  std::vector<std::vector<Vec2>> begin(e.count());
  const Case row{"bears-and-rabbits", walk.far};
  const Seeds seeds = run_seeds(scene, row, e.options, [&](std::size_t k, const crowd::Simulation& s) {
    const std::vector<Vec2> now = places_of(s, people);
    if (begin[k].empty()) begin[k] = now;
    for (std::size_t i = 0; i < people; ++i)
      if (crowd::known(now[i])) most[k][i] = std::max(most[k][i], std::abs(now[i].y - begin[k][i].y));
  });
  if (seeds.error) return *seeds.error;
  if (walk.rabbits && walk.bears && walk.mass == 30) add_arrivals(e.arrivals, row, seeds);
  add_aside(e.aside, walk, rabbits, most);
  return Done{};
}

Status shape_rows(Emergence& e) {
  scene::Scene scene = built("dense-ellipsoid");
  const Case row{"dense-ellipsoid", "avoidance"};
  const std::size_t people = 320;
  const auto pictures = [&](std::vector<Pictures>& all) {
    all.resize(e.count());
    return run_seeds(scene, row, e.options,
                     [&](std::size_t k, const crowd::Simulation& s) { all[k].push_back(places_of(s, people)); });
  };
  std::vector<Pictures> among, alone;
  const Seeds seeds = pictures(among);
  if (seeds.error) return *seeds.error;
  add_arrivals(e.arrivals, row, seeds);
  scene.crowd.populations.resize(1);
  if (const Seeds free = pictures(alone); free.error) return *free.error;
  add_shapes(e.shapes, among, alone);
  return Done{};
}

Status arches_row(Emergence& e, const std::string& name, double width) {
  std::vector<std::vector<JamMoment>> moments(e.count());
  const scene::Scene scene = built(name);
  const Seeds seeds = run_seeds(scene, {name, ""}, e.options, [&](std::size_t k, const crowd::Simulation& s) {
    moments[k].push_back(jam_moment(s, width));
  });
  if (seeds.error) return *seeds.error;
  add_arches(e.arches, e.profile, scene, width, moments);
  return Done{};
}

}  // namespace

Result<BenchGroup> bench_emergence(const BenchOptions& options) {
  Emergence e{options};
  const std::string lr = "long-range", av = "avoidance";
  std::vector<std::function<Status()>> jobs;
  // The thesis's people cohere too (4.2.3), which makes lanes thicker (6.1.2.2, 6.1.2.4) and people slower.
  for (const Case& row : {Case{"sparse-passing", lr},
                          {"sparse-passing", av},
                          {"dense-passing", lr},
                          {"dense-passing", av},
                          {"dense-passing", av, {"cohesion=0.05"}},
                          {"dense-passing-10k", lr},
                          {"dense-passing-10k", av},
                          {"proximal", lr},
                          {"proximal", av}})
    jobs.push_back([&e, row] { return passing_row(e, row); });
  for (const Case& row : {Case{"target-locomotion", lr}, {"power-law-sparse", ""}})
    jobs.push_back([&e, row] { return plain_row(e, row); });
  for (const Walk& walk : {Walk{"both", av, true, true},
                           {"both", lr, true, true},
                           {"both, bears of mass 1", lr, true, true, 1},
                           {"rabbits alone", av, true, false},
                           {"bears alone", av, false, true},
                           {"rabbits alone", lr, true, false},
                           {"bears alone", lr, false, true}})
    jobs.push_back([&e, walk] { return aside_row(e, walk); });
  jobs.push_back([&e] { return shape_rows(e); });
  jobs.push_back([&e] { return arches_row(e, "bottleneck-480", 6); });
  jobs.push_back([&e] { return arches_row(e, "bottleneck-3600", 12); });
  for (const auto& job : jobs) {
    if (e.stopped()) break;
    if (const Status s = job(); !s) return s.error();
  }
  return BenchGroup{{e.arrivals, e.lanes, e.arches, e.shapes, e.aside}, {e.order, e.profile}};
}

}  // namespace inhabit::session
