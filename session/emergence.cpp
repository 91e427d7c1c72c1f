#include "session/emergence.h"

#include <algorithm>
#include <cmath>

#include "core/rng.h"
#include "crowd/measures/lanes.h"

namespace inhabit::session {
namespace {

constexpr std::size_t kRings = 20, kSectors = 12;

double deviation_over_mean(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean) / static_cast<double>(values.size());
  return mean > 0 ? std::sqrt(square) / mean : 0;
}

}  // namespace

Result<EmergentRun> emergent_run(const scene::Scene& scene, const SimulateJob& job, const EmergentLook& look) {
  SimulateJob single = job;
  single.threads = 1;
  Result<crowd::Simulation> simulation = start_simulation(scene, single);
  if (!simulation) return simulation.error();
  EmergentRun run;
  crowd::OverlapMeter meter;
  const auto measure = [&] {
    const crowd::Overlap now = meter.measure(simulation->agents(), simulation->world().walls, 1);
    run.worst.depth = std::max(run.worst.depth, now.depth), run.worst.share = std::max(run.worst.share, now.share);
    run.worst.wall = std::max(run.worst.wall, now.wall);
  };
  const auto in_second = static_cast<std::size_t>(std::lround(1 / simulation->dt()));
  const auto steps = static_cast<std::size_t>(std::ceil(job.seconds.value_or(scene.crowd.seconds) / simulation->dt()));
  measure();
  if (look) look(*simulation);
  while (simulation->steps() < steps && simulation->arrived() < simulation->people()) {
    if (job.cancel && job.cancel->requested()) break;
    simulation->step();
    measure();
    if (look && simulation->steps() % in_second == 0) look(*simulation);
  }
  run.people = simulation->people(), run.arrived = simulation->arrived(), run.put_back = simulation->put_back();
  run.last = simulation->time();
  return run;
}

std::vector<geometry::Vec2> places_of(const crowd::Simulation& simulation, std::size_t count) {
  std::vector<geometry::Vec2> places(count, {crowd::kUnknown, crowd::kUnknown});
  const crowd::Agents& agents = simulation.agents();
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (agents.id[i] < count) places[agents.id[i]] = simulation.world().to_scene(agents.x[i], agents.y[i]);
  return places;
}

LaneMoment lane_moment(const crowd::Simulation& simulation, std::uint64_t seed) {
  const crowd::Agents& agents = simulation.agents();
  const std::size_t n = agents.size(), first = simulation.intakes()[0].placed;
  scene::Trajectories now;
  std::vector<geometry::Vec2> ways(n);
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return agents.id[i]; });
  LaneMoment moment{simulation.time()};
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t i = order[k];
    const geometry::Vec2 p = simulation.world().to_scene(agents.x[i], agents.y[i]);
    now.fixes.push_back({0, static_cast<std::int32_t>(agents.id[i]), p.x, p.y});
    // Whose lane it is says where he wants to go, also while he stands.
    const bool of_first = agents.id[i] < first;
    ways[k] = {of_first ? 1.0 : -1.0, 0};
    moment.apart += of_first ? p.x / static_cast<double>(first) : -p.x / static_cast<double>(n - first);
  }
  moment.apart = std::abs(moment.apart);
  const crowd::Recording recording(now);
  const auto of = [&](double band) {
    return crowd::mean_order(crowd::lanes(recording, ways, {.band = band, .least = 1}, 1));
  };
  moment.narrow = of(LaneMoment::kNarrow), moment.wide = of(LaneMoment::kWide);
  Rng rng(seed, simulation.steps());
  for (std::size_t k = n; k > 1; --k) std::swap(ways[k - 1], ways[rng.index(static_cast<std::uint32_t>(k))]);
  moment.narrow_chance = of(LaneMoment::kNarrow), moment.wide_chance = of(LaneMoment::kWide);
  return moment;
}

JamMoment jam_moment(const crowd::Simulation& simulation, double width) {
  const crowd::Agents& agents = simulation.agents();
  JamMoment moment;
  std::vector<crowd::Standing> crowd;
  std::vector<double> speeds(kRings, 0), bodies(kRings, 0), counts(kRings, 0), farthest(kSectors, 0);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const geometry::Vec2 p = simulation.world().to_scene(agents.x[i], agents.y[i]);
    if (p.x >= 0) continue;
    const double speed = std::hypot(agents.vx[i], agents.vy[i]), distance = geometry::length(p);
    crowd.push_back({p, agents.radius[i], speed});
    if (const auto ring = static_cast<std::size_t>(distance); ring < kRings)
      speeds[ring] += speed, bodies[ring] += kPi * agents.radius[i] * agents.radius[i], counts[ring] += 1;
    const double angle = std::atan2(-p.x, p.y);  // 0 and pi along the wall
    const auto sector = std::min(static_cast<std::size_t>(angle / kPi * kSectors), kSectors - 1);
    farthest[sector] = std::max(farthest[sector], distance);
  }
  moment.before = crowd.size();
  moment.arch = crowd::innermost_arch(crowd, {{0, -width / 2}, {0, width / 2}});
  moment.roundness = deviation_over_mean(farthest);
  for (std::size_t k = 0; k < kRings; ++k) {
    const double inner = static_cast<double>(k), area = kPi / 2 * (2 * inner + 1);
    moment.speed.push_back(counts[k] > 0 ? speeds[k] / counts[k] : crowd::kUnknown);
    moment.cover.push_back(bodies[k] / area);
  }
  return moment;
}

}  // namespace inhabit::session
