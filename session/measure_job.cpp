#include "session/measure_job.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "crowd/measures/velocity.h"
#include "crowd/measures/voronoi_density.h"
#include "geometry/convex.h"

namespace inhabit::session {
namespace {

using namespace crowd;

constexpr double kSlice = 0.25;       // of density, people per square metre
constexpr double kBox = 2;            // metres along the flow
constexpr double kLaneBand = 0.4;     // metres either way: about a body's width
constexpr double kNoWallsCutOff = 1;  // metres, JPSreport's usual radius
constexpr std::size_t kMostCollisionFixes = 500'000;
constexpr std::size_t kMostFieldCells = 300'000;
constexpr double kMargin = 0.3;  // metres round the positions where no walls are known

/// The trajectories within the span of time, and the walls to measure with.
scene::Trajectories selected(const scene::Trajectories& all, const MeasureOptions& options) {
  scene::Trajectories t;
  t.frame_rate = all.frame_rate, t.name = all.name, t.remarks = all.remarks;
  t.walkable = options.walkable.empty() ? all.walkable : options.walkable;
  if (!options.from && !options.until) {
    t.fixes = all.fixes;
    return t;
  }
  for (const scene::Fix& fix : all.fixes) {
    const double seconds = fix.frame / all.frame_rate;
    if ((!options.from || seconds >= *options.from) && (!options.until || seconds <= *options.until))
      t.fixes.push_back(fix);
  }
  return t;
}

/// The convex hull of all positions, grown by kMargin: what is surely ground when nobody says.
Ring hull(const scene::Trajectories& t) {
  std::vector<Vec2> points;
  for (const scene::Fix& fix : t.fixes) points.push_back(fix.at());
  std::vector<Vec2> grown;
  for (const Vec2 p : convex_hull(std::move(points)))
    for (int k = 0; k < 8; ++k) grown.push_back(p + kMargin * direction(k * kPi / 4));
  return convex_hull(std::move(grown));
}

/// Metres of the line within the areas.
double walkable_width(const MeasureLine& line, const std::vector<Area>& walkable) {
  if (walkable.empty()) return line.length();
  // A millimetre's strip along the line has an area that says how much of it is free.
  constexpr double kStrip = 1e-3;
  double area = 0;
  for (const Area& part : intersection(walkable, box_around(line, kStrip), 0)) area += part.size();
  return std::min(area / kStrip, line.length());
}

MeasurePlace choose_place(const Recording& recording, const MainFlow& flow, const MeasureOptions& options) {
  MeasurePlace place;
  const std::vector<Area>& walkable = recording.trajectories.walkable;
  place.walls = !walkable.empty();
  place.line_given = options.line.has_value(), place.area_given = options.area.has_value();
  place.line = options.line ? *options.line : cross_line(recording, flow);
  place.width = walkable_width(place.line, walkable);
  place.area = make_measure_area(options.area ? *options.area : box_around(place.line, kBox), walkable);
  place.cut_off = options.cut_off > 0 || place.walls ? options.cut_off : kNoWallsCutOff;
  return place;
}

void note_odd_places(MeasureReport& report) {
  const MeasurePlace& place = report.place;
  if (!place.walls)
    report.remarks.push_back("no walls are known (--scene gives them): the ground is the hull of all positions and " +
                             fixed(kMargin, 1) + " m more");
  const double whole = std::abs(signed_area(place.area.ring));
  if (place.walls && place.area.size < 0.999 * whole)
    report.remarks.push_back("only " + fixed(place.area.size, 2) + " of the area's " + fixed(whole, 2) +
                             " m² can be walked on; densities are people per square metre of those");
  if (report.off_ground > 0)
    report.remarks.push_back(std::to_string(report.off_ground) + " of " + std::to_string(report.fixes) +
                             " positions lie off the ground and are left out of the Voronoi measures");
}

std::vector<double> known_sorted(const std::vector<double>& values) {
  std::vector<double> known_ones;
  for (const double v : values)
    if (known(v)) known_ones.push_back(v);
  std::ranges::sort(known_ones);
  return known_ones;
}

}  // namespace

Result<scene::Trajectories> open_trajectories(const std::string& path, const io::TrajectoryOptions& options) {
  return io::read_trajectories(std::filesystem::path(path), options);
}

Result<MeasureReport> measure_job(const scene::Trajectories& trajectories, const MeasureOptions& options) {
  const scene::Trajectories t = selected(trajectories, options);
  if (t.fixes.empty()) {
    if (trajectories.fixes.empty()) return invalid("", "there are no positions to measure");
    return invalid("", "nobody is there in the time asked for; the recording lasts from " +
                           fixed(trajectories.fixes.front().frame / t.frame_rate, 2) + " to " +
                           fixed(trajectories.fixes.back().frame / t.frame_rate, 2) + " s");
  }
  if (options.area) {
    if (const auto why = why_not_simple(*options.area)) return invalid("--area", *why);
  }
  if (options.line && !(options.line->length() > 0)) return invalid("--line", "both ends are the same point");

  const Recording recording(t);
  const int threads = options.threads;
  MeasureReport report;
  report.name = t.name, report.frame_rate = t.frame_rate, report.remarks = t.remarks;
  report.fixes = t.fixes.size(), report.frames = recording.frame_count();
  report.from = recording.seconds(t.fixes.front().frame), report.until = recording.seconds(t.fixes.back().frame);

  const std::vector<Vec2> velocity = velocities(recording, {options.window}, threads);
  const std::vector<double> speed = speeds(velocity);
  report.speeds = known_sorted(speed);
  report.main_flow = main_flow(recording, velocity);
  report.place = choose_place(recording, report.main_flow, options);
  if (!(report.place.line.length() > 0)) return invalid("", "people do not move; say where to measure by --line");
  if (!(report.place.area.size > 0)) return invalid("--area", "none of the area can be walked on");
  report.ground = report.place.walls ? t.walkable : std::vector<Area>{{hull(t), {}}};
  const VoronoiGround ground(report.ground, report.place.cut_off);

  report.presence = presence(recording);
  report.classic = classic_density(recording, report.place.area, speed, threads);
  VoronoiDensity voronoi = voronoi_density(recording, ground, report.place.area, speed, threads);
  report.voronoi = std::move(voronoi.rows), report.off_ground = voronoi.off_ground;
  report.crossings = crossings(recording, report.place.line);
  report.flow = flow(report.crossings, report.place.width);
  report.steady = steady_span(report.flow);
  report.points = report.steady ? fundamental_points(report.voronoi, report.steady->first, report.steady->second)
                                : fundamental_points(report.voronoi);
  report.bins = density_bins(report.points, kSlice);
  report.lanes = lanes(recording, velocity, {report.main_flow.axis, kLaneBand}, threads);
  report.radius = options.radius;
  const Radii radii{options.radius, {}};
  // Pairs within 10 m are hundreds a person in a crowd: of large recordings some frames must do.
  report.collision_frames = report.fixes / kMostCollisionFixes + 1;
  report.times_to_collision = times_to_collision(recording, velocity, radii, 10, 10, threads, report.collision_frames);
  report.paths = path_lengths(recording);
  report.overlaps = overlaps(recording, radii, threads);
  report.walls = wall_contacts(recording, radii, threads);
  if (options.field) {
    // As many frames as have kMostFieldCells cells together: more do not change the picture.
    const std::size_t frames = kMostFieldCells * report.frames / report.fixes;
    report.field = density_field(recording, ground, speed,
                                 {.most_frames = std::clamp<std::size_t>(frames, 10, 300), .threads = threads});
  }
  note_odd_places(report);
  return report;
}

}  // namespace inhabit::session
