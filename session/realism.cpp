#include "session/realism.h"

#include <algorithm>
#include <cmath>

#include "crowd/measures/main_flow.h"
#include "crowd/measures/single_file.h"
#include "crowd/measures/velocity.h"
#include "crowd/measures/voronoi_density.h"
#include "session/crowd_builder.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

const io::TrajectoryOptions kHermes{io::LengthUnit::centimetres, 16, {}};
const io::TrajectoryOptions kMetres16{io::LengthUnit::metres, 16, {}}, kMetres25{io::LengthUnit::metres, 25, {}};

constexpr double kLength = 115, kAhead = 55, kWidth = 5;  ///< of the corridor, metres
constexpr double kFrom = 15, kUntil = 35;                 ///< measured then, seconds

/// From where people start, for a body of the scene: the middle of its area.
Vec2 middle(const Ring& area) { return bounds(area).center(); }

/// The body whose area is nearest to a place.
const Body& body_at(const Crowd& crowd, Vec2 p) {
  const Body* best = nullptr;
  double least = 1e300;
  const auto look = [&](const Body& body, const Ring& area) {
    const double distance = geometry::length(middle(area) - p);
    if (distance < least) least = distance, best = &body;
  };
  for (const Population& population : crowd.populations) look(population, population.area);
  for (const Source& source : crowd.sources) look(source, source.area);
  return *best;
}

}  // namespace

std::span<const RecordedExperiment> recorded_experiments() {
  static const std::vector<RecordedExperiment> all = {
      {"corner", "experiment-corner", "hermes_corner/traj.txt", kMetres16, {{0, 3.8}, {-3, 3.8}}},
      {"T-junction",
       "experiment-t-junction",
       "hermes_t_junction/traj_KO_240_050_240.txt",
       kMetres16,
       {{0, 3.8}, {-2.4, 3.8}}},
      {"entrance, 0.5 m",
       "experiment-bottleneck-040",
       "bottleneck_wuppertal2018/040_c_56_h-.txt",
       kMetres25,
       {{0.35, -0.3}, {-0.35, -0.3}}},
      {"one-way 050-180-180",
       "experiment-unidirectional-050-180-180",
       "hermes_uo/uo-050-180-180.txt",
       kHermes,
       {{2.8, -5.5}, {-1, -5.5}}},
      {"one-way 100-180-180",
       "experiment-unidirectional-100-180-180",
       "hermes_uo/uo-100-180-180.txt",
       kHermes,
       {{2.8, -5.5}, {-1, -5.5}}},
      {"one-way 145-180-180",
       "experiment-unidirectional-145-180-180",
       "hermes_uo/uo-145-180-180.txt",
       kHermes,
       {{2.8, -5.5}, {-1, -5.5}}},
      {"one-way 180-180-120",
       "experiment-unidirectional-180-180-120",
       "hermes_uo/uo-180-180-120.txt",
       kHermes,
       {{2.8, -5.5}, {-1, -5.5}}},
      {"one-way, 5 m wide",
       "experiment-unidirectional-500",
       "basigo_unidir/traj_UNI_CORR_500_01.txt",
       kMetres25,
       {{-5.2, 5}, {-5.2, 0}}},
      {"two-way 050", "experiment-bidirectional-050", "hermes_bo/bo-360-050-050.txt", kHermes, {{0, 0}, {3.6, 0}}},
      {"two-way 090", "experiment-bidirectional-090", "hermes_bo/bo-360-090-090.txt", kHermes, {{0, 0}, {3.6, 0}}}};
  return all;
}

Result<Trajectories> walked(const Scene& scene, double seconds, SimulateJob job) {
  job.every = 3;
  Result<crowd::Simulation> simulation = start_simulation(scene, job);
  if (!simulation) return simulation.error();
  Trajectories t;
  t.frame_rate = 1 / (simulation->dt() * job.every);
  for (const geometry::Floor& floor : simulation->world().floors) t.walkable.push_back({floor.outline, floor.holes});
  const auto keep = [&](std::int32_t frame, std::span<const io::Spot> people) -> Status {
    for (const io::Spot& spot : people) t.fixes.push_back({frame, spot.person, spot.x, spot.y});
    return Done{};
  };
  const Result<Simulated> done = run_simulation(*simulation, seconds, job, keep);
  if (!done) return done.error();
  return t;
}

Scene realism_corridor(double density) {
  Scene scene;
  scene.name = "corridor";
  scene.space.outline = rectangle(0, 0, kLength + kAhead, kWidth);
  scene.crowd.goals = {direction_goal("ahead", 0)};
  scene.crowd.planner = Planner::straight;
  Body body = pedestrian_body();
  body.goal = route_to({"ahead"});
  const int count = static_cast<int>(std::lround(density * kLength * kWidth));
  // At random as long as that is easy, then on a grid: of discs thrown at random 4 to the square metre find no room.
  if (density < 2.5) {
    scene.crowd.populations = {people_in("walkers", rectangle(0, 0, kLength, kWidth), count, body)};
  } else {
    const double spacing = 1 / std::sqrt(density), rim = 2 * body.radius.high;
    const int rows = static_cast<int>(std::floor((kWidth - rim) / spacing + 1e-9)) + 1;
    const int columns = count / rows;
    const double jitter = std::max(0.0, (spacing - rim) / 2 - 0.005);
    const double y = (kWidth - spacing * (rows - 1)) / 2;
    scene.crowd.populations = {grid_of_people("walkers", {spacing / 2, y}, columns, rows, spacing, jitter, body)};
  }
  return scene;
}

Result<crowd::FundamentalPoint> corridor_point(double density, const SimulateJob& job) {
  const Result<Trajectories> t = walked(realism_corridor(density), kUntil, job);
  if (!t) return t.error();
  const crowd::Recording recording(*t);
  const auto area = crowd::make_measure_area(rectangle(55, 0, 65, kWidth), t->walkable);
  const std::vector<crowd::AreaRow> rows =
      crowd::classic_density(recording, area, crowd::speeds(crowd::velocities(recording, {}), Vec2{1, 0}));
  crowd::FundamentalPoint sum;
  const auto points = crowd::fundamental_points(rows, kFrom, kUntil - 1);
  for (const crowd::FundamentalPoint& p : points) sum.density += p.density, sum.speed += p.speed;
  const double n = std::max<double>(1, static_cast<double>(points.size()));
  return crowd::FundamentalPoint{sum.density / n, sum.speed / n};
}

Scene realism_bottleneck(double width) {
  Scene scene;
  scene.name = "bottleneck";
  const double half = width / 2, side = std::max(3.0, 1.5 * width);
  const int count = static_cast<int>(std::lround(100 * std::max(1.0, width)));
  const double depth = count / 3.0 / (2 * side);
  scene.space.outline = {{-side, 0}, {-half, 0}, {-half, -1}, {-side, -1}, {-side, -5},       {side, -5},
                         {side, -1}, {half, -1}, {half, 0},   {side, 0},   {side, depth + 2}, {-side, depth + 2}};
  for (Vec2& p : scene.space.outline) p = {neat(p.x), neat(p.y)};
  scene.crowd.goals = {area_goal("behind", rectangle(-side, -5, side, -3.5))};
  Body body = pedestrian_body();
  body.goal = route_to({"behind"});
  scene.crowd.populations = {people_in("crowd", rectangle(-side, 1, side, 1 + depth), count, body)};
  return scene;
}

Result<double> bottleneck_flow(double width, const SimulateJob& job) {
  const Scene scene = realism_bottleneck(width);
  const int count = people_asked(scene.crowd);
  const Result<Trajectories> t = walked(scene, 240, job);
  if (!t) return t.error();
  const std::vector<double> times = passing_times(*t, {{width / 2, -0.5}, {-width / 2, -0.5}});
  if (static_cast<double>(times.size()) < 0.9 * count) return 0.0;
  const auto at = [&](double share) { return static_cast<std::size_t>(share * static_cast<double>(times.size() - 1)); };
  const std::size_t first = at(0.2), last = at(0.8);
  return static_cast<double>(last - first) / (times[last] - times[first]);
}

Result<std::vector<crowd::FundamentalPoint>> published_flows(const std::filesystem::path& data) {
  std::vector<crowd::FundamentalPoint> flows;
  for (const char* run : {"2006EG", "2006Kretz", "2009Seyfried", "2009AO", "2010Daamen"}) {
    const std::string path = (data / "pedestrians/reference_fd/flow_vs_width" / (std::string(run) + ".txt")).string();
    const auto points = read_curve(path);
    if (!points) return invalid(path, points.error().text());
    flows.insert(flows.end(), points->begin(), points->end());
  }
  return flows;
}

PublishedFlow published_near(std::span<const crowd::FundamentalPoint> flows, double width) {
  PublishedFlow near;
  for (const crowd::FundamentalPoint& p : flows) {  // width and flow
    if (std::abs(p.density - width) > 0.15 + 1e-9) continue;
    const double specific = p.speed / p.density;
    near.low = near.count == 0 ? specific : std::min(near.low, specific);
    near.high = std::max(near.high, specific);
    ++near.count;
  }
  return near;
}

Scene entering_as_recorded(Scene scene, const Trajectories& recording) {
  const scene::Tracks tracks = scene::tracks_of(recording);
  Crowd crowd = scene.crowd;
  crowd.populations.clear(), crowd.sources.clear();
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const Fix& fix = recording.fixes[tracks[k].front()];
    const Vec2 p = {neat(fix.x), neat(fix.y)};
    const Body& body = body_at(scene.crowd, p);
    const std::string id = std::to_string(recording.fixes[tracks[k].front()].person);
    if (fix.frame == recording.fixes.front().frame && !scene.crowd.populations.empty()) {
      crowd.populations.push_back(grid_of_people(id, p, 1, 1, 0.5, 0, body));
      continue;
    }
    constexpr double kRoom = 0.12;  // a head may be nearer to a wall than a disc can be
    Source source;
    static_cast<Body&>(source) = body;
    source.id = id, source.count = 1, source.rate = 1000, source.from = fix.frame / recording.frame_rate;
    source.area = rectangle(p.x - kRoom, p.y - kRoom, p.x + kRoom, p.y + kRoom);
    crowd.sources.push_back(std::move(source));
  }
  scene.crowd = std::move(crowd);
  return scene;
}

std::vector<double> passing_times(const Trajectories& trajectories, const crowd::MeasureLine& line) {
  return crowd::flow(crowd::crossings(crowd::Recording(trajectories), line), line.length()).times;
}

std::vector<crowd::FundamentalPoint> steady_diagram(const Trajectories& trajectories, const crowd::MeasureLine& line) {
  const crowd::Recording recording(trajectories);
  const auto span = crowd::steady_span(crowd::flow(crowd::crossings(recording, line), line.length()));
  if (!span) return {};
  const crowd::VoronoiDensity voronoi =
      crowd::voronoi_density(recording, crowd::VoronoiGround(trajectories.walkable),
                             crowd::make_measure_area(crowd::box_around(line, 2), trajectories.walkable),
                             crowd::speeds(crowd::velocities(recording, {})));
  return crowd::fundamental_points(voronoi.rows, span->first, span->second);
}

std::vector<crowd::FundamentalPoint> ring_points(const Trajectories& trajectories, bool simulated) {
  if (!simulated) {
    const crowd::Recording recording(trajectories);
    return crowd::single_file_points(recording, crowd::velocities(recording, {}), {{0, 0}, {1, 0}, 0, 3.14});
  }
  Trajectories lower = trajectories;
  std::erase_if(lower.fixes, [&](const Fix& fix) { return fix.y > -1.5 || fix.frame < 10 * trajectories.frame_rate; });
  const crowd::Recording recording(lower);
  return crowd::single_file_points(recording, crowd::velocities(recording, {}), {{-1.57, 0}, {1, 0}, 0, 3.14}, 4);
}

}  // namespace inhabit::session
