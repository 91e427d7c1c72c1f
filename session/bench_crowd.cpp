#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/text.h"
#include "crowd/overlap.h"
#include "session/bench.h"
#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"
#include "session/machine_limits.h"
#include "session/simulate_job.h"

namespace inhabit::session {
namespace {

/// A scene from its first step to its last, every step looked at.
struct CrowdRun {
  std::vector<double> milliseconds;  ///< of each step: people enter, wish, move, arrive; the looking is not in it
  crowd::StepTimes times;
  crowd::Overlap worst;
  crowd::Effort effort;  ///< of all steps
  std::size_t people = 0, arrived = 0, through = 0, put_back = 0;
  double mean() const {
    double sum = 0;
    for (const double ms : milliseconds) sum += ms;
    return milliseconds.empty() ? 0 : sum / static_cast<double>(milliseconds.size());
  }
  /// Mean milliseconds per step of one phase.
  double each(double seconds) const {
    return milliseconds.empty() ? 0 : 1000 * seconds / static_cast<double>(milliseconds.size());
  }
};

/// Behind the corridor of the bottlenecks, metres.
constexpr double kBehindCorridor = 20;

/// `look`: whether overlaps are measured after every step; `at_end` sees the simulation before it goes.
using AtEnd = std::function<void(const crowd::Simulation&)>;

Result<CrowdRun> run_scene(const Scene& scene, const BenchOptions& options, bool look = true,
                           const AtEnd& at_end = {}) {
  SimulateJob job;
  job.threads = options.threads;
  Result<crowd::Simulation> simulation = start_simulation(scene, job);
  if (!simulation) return simulation.error();
  const double seconds = options.seconds > 0 ? std::min(options.seconds, scene.crowd.seconds) : scene.crowd.seconds;
  const auto steps = static_cast<std::size_t>(std::ceil(seconds / simulation->dt() - 1e-6));
  CrowdRun run;
  crowd::OverlapMeter meter;
  while (simulation->steps() < steps && !simulation->finished()) {
    if (options.cancel && options.cancel->requested()) break;
    const double before = simulation->times().sum();
    simulation->step();
    const crowd::Effort effort = simulation->effort();
    run.effort.flops += effort.flops, run.effort.bytes += effort.bytes;
    run.milliseconds.push_back(1000 * (simulation->times().sum() - before));
    if (look) {
      const crowd::Overlap now = meter.measure(simulation->agents(), simulation->world().walls, options.threads);
      run.worst = {std::max(run.worst.depth, now.depth), std::max(run.worst.share, now.share),
                   std::max(run.worst.wall, now.wall)};
    }
    if (options.progress && simulation->steps() % 16 == 0)
      options.progress(static_cast<double>(simulation->steps()) / static_cast<double>(steps), scene.name);
  }
  run.times = simulation->times();
  run.people = simulation->people(), run.arrived = simulation->arrived(), run.put_back = simulation->put_back();
  const crowd::Agents& agents = simulation->agents();
  for (std::size_t i = 0; i < agents.size(); ++i)
    run.through += simulation->world().to_scene(agents.x[i], agents.y[i]).x > kBehindCorridor;
  if (at_end) at_end(*simulation);
  return run;
}

/// What is done about collisions to come, and the time published for it.
struct Variant {
  Far far;
  double published;
};

/// The thesis's scenes with the model that each row was published for.
Result<Table> thesis_table(const BenchOptions& options) {
  Table table{"crowd", "The thesis's scenes (table 6.1): milliseconds for a frame of two steps of 1/48 s", {}, {}, {}};
  table.columns = {{"scene"},      {"collisions to come"}, {"people", 0},       {"mean ms", 3},
                   {"p95 ms", 3},  {"published"},          {"times faster", 1}, {"overlap mm", 2},
                   {"share %", 3}, {"in wall mm", 3},      {"arrived", 0},      {"put back", 0}};
  for (const CrowdScene& row : crowd_scenes()) {
    for (const Variant& v : {Variant{Far::long_range, row.long_range_ms}, Variant{Far::avoidance, row.avoidance_ms},
                             Variant{Far::off, row.contact_ms}}) {
      if (v.published == 0) continue;
      Scene scene = row.build();
      std::get<PbdModel>(scene.crowd.model).far = static_cast<Choice>(v.far);
      const Result<CrowdRun> run = run_scene(scene, options);
      if (!run) return run.error();
      const double mean = 2 * run->mean();
      table.rows.push_back({std::string(row.name),
                            v.far == Far::off          ? "off"
                            : v.far == Far::long_range ? "long-range"
                                                       : "avoidance",
                            static_cast<double>(run->people), mean, 2 * quantile(run->milliseconds, 0.95), v.published,
                            v.published / mean, 1000 * run->worst.depth, 100 * run->worst.share, 1000 * run->worst.wall,
                            static_cast<double>(run->arrived), static_cast<double>(run->put_back)});
      if (options.cancel && options.cancel->requested()) return table;
    }
  }
  table.notes = {"published: one GPU; overlap after any step, as depth and as share of the radii's sum"};
  return table;
}

/// Times of RVO2 on a machine like this one, two threads, milliseconds per step.
struct Peer {
  std::string_view name;
  double rvo2_ms, target_ms, most_overlap_mm;
};
constexpr Peer kPeers[] = {{"peers-passing-1600", 0.79, 0.3, 2},
                           {"peers-passing-10032", 5.1, 1.2, 2},
                           {"peers-passing-100000", 56.9, 10, 2},
                           {"peers-bottleneck-480", 0.29, 0, 15},
                           {"peers-bottleneck-3600", 2.3, 0.6, 15},
                           {"peers-bottleneck-100048", 58.7, 15, 15},
                           {"peers-crush", 82, 15, 40}};

Result<Table> peers_table(const BenchOptions& options) {
  Table table{"crowd-peers", "Scenes that other programs ran: milliseconds per step of 1/48 s", {}, {}, {}};
  table.columns = {{"scene"},         {"mean ms", 3},     {"p95 ms", 3},     {"model ms", 3}, {"planning ms", 3},
                   {"keeping ms", 3}, {"arriving ms", 3}, {"target ms", 1},  {"RVO2 ms", 2},  {"times faster", 1},
                   {"overlap mm", 2}, {"target mm", 0},   {"in wall mm", 3}, {"through", 0}};
  for (const Peer& peer : kPeers) {
    const Result<CrowdRun> run = run_scene(find_crowd_scene(peer.name)->build(), options);
    if (!run) return run.error();
    const bool corridor = peer.name.find("bottleneck") != std::string_view::npos;
    table.rows.push_back({std::string(peer.name), run->mean(), quantile(run->milliseconds, 0.95),
                          run->each(run->times.model), run->each(run->times.planning), run->each(run->times.keeping),
                          run->each(run->times.arriving), peer.target_ms > 0 ? Cell(peer.target_ms) : Cell(),
                          peer.rvo2_ms, peer.rvo2_ms / run->mean(), 1000 * run->worst.depth, peer.most_overlap_mm,
                          1000 * run->worst.wall, corridor ? Cell(static_cast<double>(run->through)) : Cell()});
    if (options.cancel && options.cancel->requested()) break;
  }
  table.notes = {
      "RVO2: two threads of another machine of 2 cores, tuned build; overlap after any step",
      "through: people 20 m behind the wall at the end; RVO2 548 of 3,600 in 60 s and 477 of 100,048 in 30 s"};
  return table;
}

double resident_bytes() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// People at random all over a square, one for each 4 square metres, half of them heading east and half west:
/// everybody meets somebody all the time, in a small crowd as in a large one.
Scene mixed_crowd(int people) {
  const double half = std::sqrt(static_cast<double>(people));
  Scene scene;
  scene.name = "mixed-" + std::to_string(people);
  scene.space.outline = rectangle(-half - 20, -half - 20, half + 20, half + 20);
  scene.crowd.goals = {direction_goal("east", 0), direction_goal("west", 180)};
  Body body = game_body();
  body.speed = {1.4, 0, 2};
  for (const char* side : {"east", "west"}) {
    body.goal = route_to({side});
    scene.crowd.populations.push_back(people_in(side, rectangle(-half, -half, half, half), people / 2, body));
  }
  scene.crowd.model = game_model(Far::long_range);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = 3;
  return scene;
}

constexpr int kSizes[] = {1000, 3000, 10000, 30000, 100000, 300000, 1000000};

Status growth_table(const BenchOptions& options, BenchGroup& group) {
  Table table{"crowd-growth", "Growth: two crowds mixed at random, one person for each 4 square metres", {}, {}, {}};
  table.columns = {
      {"people", 0}, {"ms per step", 3}, {"ns per person", 1}, {"one thread ns", 1}, {"bytes per person", 0}};
  BenchCurve curve{"crowd-growth", "Time of a step", "people", "ns per person and step", true, false, {}};
  curve.lines = {{"all threads", {}, {}}, {"one thread", {}, {}}};
  for (const int people : kSizes) {
    if (people > options.max_people || (options.cancel && options.cancel->requested())) break;
    const Scene scene = mixed_crowd(people);
    BenchOptions one = options;
    one.threads = 1;
    const double before = resident_bytes();
    double held = 0;
    const Result<CrowdRun> alone =
        run_scene(scene, one, false, [&](const crowd::Simulation&) { held = resident_bytes(); });
    const Result<CrowdRun> all = alone ? run_scene(scene, options, false) : alone;
    if (!all) return all.error();
    const double n = people, each = 1e6 / n;
    table.rows.push_back({n, all->mean(), each * all->mean(), each * alone->mean(), (held - before) / n});
    curve.lines[0].x.push_back(n), curve.lines[0].y.push_back(each * all->mean());
    curve.lines[1].x.push_back(n), curve.lines[1].y.push_back(each * alone->mean());
  }
  table.notes = {
      "bytes: what the whole process holds more at the end of the run than before it, scene and planner included"};
  group.tables.push_back(std::move(table));
  group.curves.push_back(std::move(curve));
  return Done{};
}

/// The model's own loops against what the machine can do at best.
Result<Table> roofline_table(const BenchOptions& options) {
  Table table{
      "crowd-roofline", "Roofline: what the model computes and moves, against the most this machine does", {}, {}, {}};
  table.columns = {{"scene"},        {"flops each", 0}, {"bytes each", 0},     {"model ms", 3}, {"GFLOP/s", 1},
                   {"of peak %", 1}, {"GB/s", 1},       {"of bandwidth %", 1}, {"least ms", 3}};
  constexpr std::size_t kWorking = 20'000'000, kFar = 400'000'000;
  const double peak = peak_flops(options.threads), near = bandwidth(kWorking, options.threads);
  const double far = bandwidth(kFar, options.threads);
  for (const char* name : {"peers-passing-10032", "peers-passing-100000", "peers-bottleneck-100048", "peers-crush"}) {
    if (options.cancel && options.cancel->requested()) break;
    BenchOptions some = options;
    some.seconds = options.seconds > 0 ? std::min(options.seconds, 5.0) : 5;
    const Result<CrowdRun> run = run_scene(find_crowd_scene(name)->build(), some, false);
    if (!run) return run.error();
    const double each = static_cast<double>(run->people * run->milliseconds.size());
    const double flops = run->effort.flops / run->times.model, bytes = run->effort.bytes / run->times.model;
    const double steps = static_cast<double>(run->milliseconds.size());
    table.rows.push_back({name, run->effort.flops / each, run->effort.bytes / each, run->each(run->times.model),
                          1e-9 * flops, 100 * flops / peak, 1e-9 * bytes, 100 * bytes / near,
                          1000 * std::max(run->effort.flops / peak, run->effort.bytes / near) / steps});
  }
  table.notes = {"each: per person and step, the first 5 s; least: what the larger of the two shares would take",
                 "the most: " + fixed(1e-9 * peak, 0) + " GFLOP/s, " + fixed(1e-9 * near, 1) + " GB/s over 20 MB, " +
                     fixed(1e-9 * far, 1) + " GB/s over 400 MB, measured by this run",
                 "model ms holds the search of neighbours too, which the counts leave out"};
  return table;
}

}  // namespace

Result<BenchGroup> bench_crowd(const BenchOptions& options) {
  BenchGroup group;
  for (const auto& run : {peers_table, thesis_table, roofline_table}) {
    Result<Table> table = run(options);
    if (!table) return table.error();
    group.tables.push_back(*std::move(table));
    if (options.cancel && options.cancel->requested()) return group;
  }
  if (Status s = growth_table(options, group); !s) return s.error();
  return group;
}

}  // namespace inhabit::session
