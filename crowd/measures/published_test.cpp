#include "core/statistics.h"
#include "crowd/measures/crossings.h"
#include "crowd/measures/single_file.h"
#include "crowd/measures/test_published.h"
#include "crowd/measures/velocity.h"
#include "crowd/measures/voronoi_density.h"

/// Our measures of real recordings against the curves that others published for these experiments. Medians of the speed
/// in slices of 0.25 people per square metre (0.25 per metre in single file) with at least five published points. The
/// published points of one slice have quartiles 0.05 to 0.15 m/s from their median, so two honest measurements of a
/// curve may differ by 0.1 m/s in the mean square; the bounds below are that, and less where the very same run was
/// measured.
using namespace inhabit;
using namespace inhabit::crowd;

namespace {

constexpr double kSlice = 0.25;
constexpr std::size_t kLeast = 5;

/// Voronoi density and speed in `ring` while the middle three fifths of the people cross `line`: the published points
/// are from the steady part of each run too, chosen by eye there.
std::vector<FundamentalPoint> steady_points(const scene::Trajectories& t, const Ring& ring, const MeasureLine& line) {
  const Recording r(t);
  const std::vector<double> times = flow(crossings(r, line), line.length()).times;
  REQUIRE(times.size() > 50);
  const double from = times[times.size() / 5], until = times[times.size() * 4 / 5];
  VoronoiDensity v =
      voronoi_density(r, VoronoiGround(t.walkable), make_measure_area(ring, t.walkable), speeds(velocities(r, {})));
  std::erase_if(v.rows, [&](const AreaRow& row) { return row.seconds < from || row.seconds > until; });
  return fundamental_points(v.rows);
}

CurveComparison compare(const std::vector<FundamentalPoint>& ours, const std::vector<FundamentalPoint>& theirs) {
  const CurveComparison c = compare_curves(density_bins(ours, kSlice), density_bins(theirs, kSlice), kLeast);
  MESSAGE(ours.size(), " points against ", theirs.size(), ": ", c.bins, " slices, mean ", c.mean, " m/s, rms ", c.rmse,
          ", worst ", c.worst);
  return c;
}

const Ring kOneWay = {{2.8, -6.5}, {2.8, -4}, {1.8, -4}, {1.8, 4}, {2.8, 4}, {2.8, 8},
                      {-1, 8},     {-1, 4},   {0, 4},    {0, -4},  {-1, -4}, {-1, -6.5}};

}  // namespace

TEST_CASE("published: one-way corridors have the fundamental diagram of the Hermes series") {
  const auto theirs = published({"fd_uo_open_corridor/uo-080-300-300.dat", "fd_uo_open_corridor/uo-120-300-300.dat",
                                 "fd_uo_open_corridor/uo-180-300-300.dat", "fd_uo_open_corridor/uo-300-300-080.dat",
                                 "fd_uo_open_corridor/uo-300-300-120.dat", "fd_uo_open_corridor/uo-300-300-200.dat",
                                 "fd_uo_open_corridor/uo-300-300-300.dat"});
  std::vector<FundamentalPoint> ours;
  for (const char* name : {"uo-050-180-180", "uo-100-180-180", "uo-145-180-180", "uo-180-180-120"}) {
    const auto t = recorded("hermes_uo/" + std::string(name) + ".txt", 16, 0.01, kOneWay);
    if (!t || theirs.empty()) return;
    const auto points = steady_points(*t, rectangle(0, -1, 1.8, 1), {{0, 0}, {1.8, 0}});
    ours.insert(ours.end(), points.begin(), points.end());
  }
  const CurveComparison c = compare(ours, theirs);
  CHECK(c.bins >= 9);
  CHECK(std::abs(c.mean) < 0.06);
  CHECK(c.rmse < 0.1);
}

TEST_CASE("published: two-way corridors have the fundamental diagram of the Hermes series") {
  const auto theirs = published({"fd_bo_bidirectional/bot-360-050-050.dat", "fd_bo_bidirectional/bot-360-090-090.dat",
                                 "fd_bo_bidirectional/bot-360-120-120.dat"});
  std::vector<FundamentalPoint> ours;
  for (const char* name : {"bo-360-050-050", "bo-360-090-090"}) {
    const auto t = recorded("hermes_bo/" + std::string(name) + ".txt", 16, 0.01, rectangle(0, -4, 3.6, 4));
    if (!t || theirs.empty()) return;
    const auto points = steady_points(*t, rectangle(0, -1, 3.6, 1), {{0, 0}, {3.6, 0}});
    ours.insert(ours.end(), points.begin(), points.end());
  }
  const CurveComparison c = compare(ours, theirs);
  CHECK(c.bins == 4);
  CHECK(std::abs(c.mean) < 0.06);
  CHECK(c.rmse < 0.1);
}

TEST_CASE("published: a corner has the fundamental diagram before and behind it") {
  const auto t = recorded("hermes_corner/traj.txt", 16, 1, {{-3, 5}, {-3, -3}, {5, -3}, {5, 0}, {0, 0}, {0, 5}});
  const auto before = published({"fd_eo_corner/eo-240-050-240_id_1.dat", "fd_eo_corner/eo-240-060-240_id_1.dat",
                                 "fd_eo_corner/eo-240-100-240_id_1.dat", "fd_eo_corner/eo-240-150-240_id_1.dat"});
  const auto behind = published({"fd_eo_corner/eo-240-060-240_id_2.dat", "fd_eo_corner/eo-240-080-240_id_2.dat",
                                 "fd_eo_corner/eo-240-150-240_id_2.dat", "fd_eo_corner/eo-240-240-240_id_2.dat"});
  if (!t || before.empty() || behind.empty()) return;
  for (const CurveComparison& c : {compare(steady_points(*t, rectangle(0, -3, 2, 0), {{1, 0}, {1, -3}}), before),
                                   compare(steady_points(*t, rectangle(-3, 0, 0, 2), {{-3, 1}, {0, 1}}), behind)}) {
    CHECK(c.bins >= 4);
    CHECK(std::abs(c.mean) < 0.06);
    CHECK(c.rmse < 0.1);
  }
}

TEST_CASE("published: the very run of a T-junction is measured as its publishers did") {
  const auto t = recorded("hermes_t_junction/traj_KO_240_050_240.txt", 16, 1,
                          {{-5, -2.4}, {4, -2.4}, {4, 0}, {0, 0}, {0, 4.5}, {-2.4, 4.5}, {-2.4, 0}, {-5, 0}});
  struct Arm {
    std::string curve;
    Ring area;
    MeasureLine line;
  };
  const std::vector<Arm> arms = {
      {"fd_ko_t_junction/ko-240-050-240_id_1.dat", rectangle(-2.4, 0.5, 0, 2.5), {{-2.4, 1.5}, {0, 1.5}}},
      {"fd_ko_t_junction/ko-240-050-240_id_2.dat", rectangle(-4.5, -2.4, -2.5, 0), {{-3.5, 0}, {-3.5, -2.4}}},
      {"fd_ko_t_junction/ko-240-050-240_id_3.dat", rectangle(0.1, -2.4, 2.1, 0), {{1.1, 0}, {1.1, -2.4}}}};
  for (const Arm& arm : arms) {
    const auto theirs = published({arm.curve});
    if (!t || theirs.empty()) return;
    const auto ours = steady_points(*t, arm.area, arm.line);
    CHECK(compare(ours, theirs).rmse < 0.1);
    const auto medians = [](const std::vector<FundamentalPoint>& points) {
      std::vector<double> densities, speeds;
      for (const FundamentalPoint& p : points) densities.push_back(p.density), speeds.push_back(p.speed);
      return FundamentalPoint{median(densities), median(speeds)};
    };
    const FundamentalPoint a = medians(ours), b = medians(theirs);
    MESSAGE(arm.curve, ": medians ", a.density, " and ", b.density, " /m2, ", a.speed, " and ", b.speed, " m/s");
    // Where exactly their areas lay along the arms is not known; half a metre moves the medians by about this much.
    CHECK(std::abs(a.density - b.density) < 0.08);
    CHECK(std::abs(a.speed - b.speed) < 0.05);
  }
}

TEST_CASE("published: single file has the density and speed of Seyfried 2005 and of the larger ring") {
  std::vector<FundamentalPoint> ours;
  const auto seyfried = published({"single_file_2col/01_FD_germany_seyfried2005_all.txt"});
  const auto ring = published({"fd_1d_single_file/n14.dat", "fd_1d_single_file/n20.dat", "fd_1d_single_file/n22.dat",
                               "fd_1d_single_file/n28.dat", "fd_1d_single_file/n34.dat", "fd_1d_single_file/n45.dat",
                               "fd_1d_single_file/n56.dat", "fd_1d_single_file/n70.dat"});
  for (const char* name : {"UX_14_1", "UX_20_1", "UX_30_1"}) {
    const auto t = recorded("single_file/subaih2019/" + std::string(name) + ".txt", 25, 1, {});
    if (!t || seyfried.empty() || ring.empty()) return;
    const Recording r(*t);
    const auto points = single_file_points(r, velocities(r, {}), {{0, 0}, {1, 0}, 0, 3.14});
    ours.insert(ours.end(), points.begin(), points.end());
  }
  // Another country's people: the series differ by 0.1 m/s and more among themselves.
  CHECK(compare(ours, seyfried).rmse < 0.12);
  CHECK(compare(ours, ring).rmse < 0.12);
  CHECK(std::abs(compare(ours, ring).mean) < 0.1);
}

TEST_CASE("published: bottlenecks let as many people through as those of the same width") {
  struct Run {
    std::string name;
    double rate, unit, width;
    MeasureLine line;
    double low, high;  // of the five published series at that width, or next to it
  };
  const std::vector<Run> runs = {
      {"bottleneck_wuppertal2018/040_c_56_h-.txt", 25, 1, 0.5, {{-0.35, -0.3}, {0.35, -0.3}}, 1.007, 1.114},
      {"hermes_uo/uo-050-180-180.txt", 16, 0.01, 0.5, {{-1, -3}, {2.8, -3}}, 1.007, 1.114},
      {"hermes_uo/uo-100-180-180.txt", 16, 0.01, 1.0, {{-1, -3}, {2.8, -3}}, 1.710, 2.774},
      {"hermes_uo/uo-180-180-120.txt", 16, 0.01, 1.2, {{-1, -3}, {2.8, -3}}, 2.033, 2.364}};
  for (const Run& run : runs) {
    const auto t = recorded(run.name, run.rate, run.unit, {});
    if (!t) return;
    const Recording r(*t);
    const Flow f = flow(crossings(r, run.line), run.width);
    MESSAGE(run.name, ": ", f.flow, " people/s, ", f.specific, " per metre; published ", run.low, " to ", run.high);
    // A run is one sample: what the last of the queue do moves its mean flow by a tenth.
    CHECK(f.flow > 0.9 * run.low);
    CHECK(f.flow < 1.1 * run.high);
  }
}
