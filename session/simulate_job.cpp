#include "session/simulate_job.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"

namespace inhabit::session {
namespace {

constexpr std::array<std::string_view, 4> kPlanners = {"automatic", "straight", "paths", "field"};

/// The people of a moment in ascending order of number. Numbers are given one after the other, so most lie close
/// together and are sorted by counting.
class Roll {
 public:
  std::span<const io::Spot> call(const crowd::Simulation& simulation) {
    const crowd::Agents& agents = simulation.agents();
    const std::size_t n = agents.size();
    spots_.clear();
    if (n == 0) return spots_;
    const auto [low, high] = std::ranges::minmax(agents.id);
    order_.resize(n);
    if (high - low < 4 * n + 64) {
      at_.assign(high - low + 1, kNobody);
      for (std::uint32_t i = 0; i < n; ++i) at_[agents.id[i] - low] = i;
      std::size_t k = 0;
      for (const std::uint32_t i : at_)
        if (i != kNobody) order_[k++] = i;
    } else {
      for (std::uint32_t i = 0; i < n; ++i) order_[i] = i;
      std::ranges::sort(order_, {}, [&](std::uint32_t i) { return agents.id[i]; });
    }
    for (const std::uint32_t i : order_) {
      const geometry::Vec2 p = simulation.world().to_scene(agents.x[i], agents.y[i]);
      spots_.push_back({static_cast<std::int32_t>(agents.id[i]), p.x, p.y});
    }
    return spots_;
  }

 private:
  static constexpr std::uint32_t kNobody = 0xffffffff;
  std::vector<std::uint32_t> at_, order_;
  std::vector<io::Spot> spots_;
};

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

void measure(Simulated& done, crowd::OverlapMeter& meter, const crowd::Simulation& simulation, int threads) {
  const crowd::Overlap now = meter.measure(simulation.agents(), simulation.world().walls, threads);
  if (now.depth > done.worst.depth) done.worst_at = simulation.time();
  done.worst.depth = std::max(done.worst.depth, now.depth);
  done.worst.share = std::max(done.worst.share, now.share);
  done.worst.wall = std::max(done.worst.wall, now.wall);
}

io::TrajectoryHeader header_of(const scene::Scene& scene, const crowd::Simulation& simulation, const SimulateJob& job) {
  io::TrajectoryHeader header;
  header.frame_rate = 1 / (simulation.dt() * job.every);
  for (const geometry::Floor& floor : simulation.world().floors)
    header.walkable.push_back({floor.outline, floor.holes});
  header.title = scene.name;
  header.producer_notes = "inhabit simulate";
  return header;
}

}  // namespace

std::vector<std::string> Simulated::warnings() const {
  std::vector<std::string> list;
  for (const crowd::Intake& intake : intakes) {
    const std::string who = "population \"" + intake.population + "\": ";
    if (intake.asked == 0) list.push_back(who + "it has nobody in it");
    if (intake.placed < intake.asked)
      list.push_back(who + std::to_string(intake.placed) + " of " + counted(intake.asked, "person", "people") +
                     " placed; there is no room for the others");
    if (intake.moved > 0)
      list.push_back(who + counted(intake.moved, "person", "people") +
                     " stood in a wall, furniture or somebody else and moved to the nearest free place");
    if (intake.unreachable > 0)
      list.push_back(who + counted(intake.unreachable, "person", "people") + " of " + std::to_string(intake.placed) +
                     " cannot get to the goal from where they are");
  }
  if (waiting_outside > 0)
    list.push_back(counted(waiting_outside, "person", "people") + " of the sources still wait outside for room");
  if (put_back > 0)
    list.push_back("somebody was put back out of a wall " + counted(put_back, "time", "times") +
                   ": the step is too long for this model");
  return list;
}

Result<crowd::Simulation> start_simulation(const scene::Scene& scene, const SimulateJob& job) {
  const Result<scene::CrowdModel> model = choose_model(scene.crowd.model, job.model);
  if (!model) return model.error();
  crowd::Settings settings;
  settings.model = *model, settings.step = job.step, settings.seed = job.seed, settings.threads = job.threads;
  if (job.planner.empty()) return crowd::Simulation::make(scene, settings);
  const Result<scene::Planner> planner = planner_of(job.planner);
  if (!planner) return planner.error();
  scene::Scene planned = scene;
  planned.crowd.planner = *planner;
  return crowd::Simulation::make(planned, settings);
}

Result<Simulated> run_simulation(crowd::Simulation& simulation, double seconds, const SimulateJob& job,
                                 const FrameSink& sink) {
  Simulated done;
  const std::size_t every = static_cast<std::size_t>(std::max(1, job.every));
  // A run of 60 s has 2,880 steps of 1/48 s whatever rounding says.
  const auto steps = static_cast<std::size_t>(std::ceil(std::max(0.0, seconds) / simulation.dt() - 1e-6));
  Roll roll;
  crowd::OverlapMeter meter;
  const auto write = [&]() -> Status {
    measure(done, meter, simulation, job.threads);
    return sink ? sink(static_cast<std::int32_t>(done.frames++), roll.call(simulation)) : (++done.frames, Done{});
  };
  if (Status s = write(); !s) return s.error();
  std::chrono::duration<double> spent{0};
  while (simulation.steps() < steps && !simulation.finished()) {
    if (job.cancel && job.cancel->requested()) {
      done.cancelled = true;
      break;
    }
    const auto begin = std::chrono::steady_clock::now();
    simulation.step();
    spent += std::chrono::steady_clock::now() - begin;
    if (simulation.steps() % every == 0)
      if (Status s = write(); !s) return s.error();
    if (job.progress)
      job.progress(static_cast<double>(simulation.steps()) / static_cast<double>(steps),
                   fixed(simulation.time(), 0) + " s, " + counted(simulation.agents().size(), "person", "people"));
  }
  done.intakes.assign(simulation.intakes().begin(), simulation.intakes().end());
  done.people = simulation.people(), done.arrived = simulation.arrived();
  done.inside = simulation.agents().size(), done.waiting_outside = simulation.waiting_outside();
  done.steps = simulation.steps(), done.step = simulation.dt(), done.time = simulation.time();
  done.seconds = spent.count(), done.put_back = simulation.put_back();
  return done;
}

Result<Simulated> simulate_job(const scene::Scene& scene, const SimulateJob& job, const std::string& path) {
  Result<crowd::Simulation> simulation = start_simulation(scene, job);
  if (!simulation) return simulation.error();
  std::optional<io::TrajectoryWriter> writer;
  FrameSink sink;
  if (!path.empty()) {
    Result<io::TrajectoryWriter> opened = io::TrajectoryWriter::open(path, header_of(scene, *simulation, job));
    if (!opened) return opened.error();
    writer.emplace(std::move(*opened));
    sink = [&](std::int32_t frame, std::span<const io::Spot> people) { return writer->add(frame, people); };
  }
  Result<Simulated> done = run_simulation(*simulation, job.seconds.value_or(scene.crowd.seconds), job, sink);
  if (!done) return done.error();
  if (writer)
    if (Status s = writer->finish(); !s) return s.error();
  done->scene = scene.name;
  done->model = model_name(*choose_model(scene.crowd.model, job.model));
  done->planner = job.planner.empty() ? kPlanners[static_cast<std::size_t>(scene.crowd.planner)] : job.planner;
  return done;
}

std::string simulate_text(const Simulated& s) {
  std::string text = (s.scene.empty() ? "scene" : s.scene) + ": " + counted(s.people, "person", "people") + ", " +
                     std::to_string(s.arrived) + " arrived, " + std::to_string(s.inside) + " still there";
  if (s.waiting_outside > 0) text += ", " + std::to_string(s.waiting_outside) + " waiting outside";
  text += "\n  model " + s.model + ", planner " + s.planner + ", " + fixed(s.time, 2) + " s in " +
          counted(s.steps, "step", "steps") + " of " + fixed(1000 * s.step, 2) + " ms, " +
          counted(s.frames, "frame", "frames") + "\n";
  if (s.steps > 0)
    text += "  " + fixed(1000 * s.seconds / static_cast<double>(s.steps), 3) + " ms per step, " +
            fixed(s.seconds > 0 ? s.time / s.seconds : 0, 1) + " times real time\n";
  text += "  worst overlap of two people " + fixed(1000 * s.worst.depth, 1) + " mm (" + fixed(100 * s.worst.share, 2) +
          " % of their radii), at " + fixed(s.worst_at, 2) + " s; with a wall " + fixed(1000 * s.worst.wall, 1) +
          " mm\n";
  if (s.cancelled) text += "  interrupted: the file ends with the last frame\n";
  return text;
}

std::string simulate_json(const Simulated& s) {
  nlohmann::ordered_json json;
  json["scene"] = s.scene, json["model"] = s.model, json["planner"] = s.planner;
  json["people"] = s.people, json["arrived"] = s.arrived, json["inside"] = s.inside;
  json["waiting_outside"] = s.waiting_outside;
  json["time"] = s.time, json["step"] = s.step, json["steps"] = s.steps, json["frames"] = s.frames;
  json["seconds"] = s.seconds;
  json["steps_per_second"] = s.seconds > 0 ? static_cast<double>(s.steps) / s.seconds : 0;
  json["worst_overlap"] = {
      {"depth", s.worst.depth}, {"share", s.worst.share}, {"time", s.worst_at}, {"wall", s.worst.wall}};
  json["put_back"] = s.put_back;
  json["cancelled"] = s.cancelled;
  json["populations"] = nlohmann::ordered_json::array();
  for (const crowd::Intake& i : s.intakes)
    json["populations"].push_back({{"id", i.population},
                                   {"asked", i.asked},
                                   {"placed", i.placed},
                                   {"moved", i.moved},
                                   {"unreachable", i.unreachable}});
  json["warnings"] = s.warnings();
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace inhabit::session
