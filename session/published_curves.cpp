#include "session/published_curves.h"

#include <algorithm>

#include "crowd/measures/single_file.h"
#include "crowd/measures/velocity.h"
#include "crowd/measures/voronoi_density.h"

namespace inhabit::session {
namespace {

using namespace crowd;
using Points = std::vector<FundamentalPoint>;

constexpr double kSlice = 0.25;
constexpr std::size_t kLeast = 5;

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// Where a recording's files lie, what they do not say, and between which walls people walked.
struct Source {
  std::vector<std::string> files;
  io::TrajectoryOptions reading;
  Ring walls;
};

const io::TrajectoryOptions kHermes{io::LengthUnit::centimetres, 16, {}};
const io::TrajectoryOptions kMetres16{io::LengthUnit::metres, 16, {}}, kMetres25{io::LengthUnit::metres, 25, {}};
const Ring kOneWay = {{2.8, -6.5}, {2.8, -4}, {1.8, -4}, {1.8, 4}, {2.8, 4}, {2.8, 8},
                      {-1, 8},     {-1, 4},   {0, 4},    {0, -4},  {-1, -4}, {-1, -6.5}};
const Ring kCorner = {{-3, 5}, {-3, -3}, {5, -3}, {5, 0}, {0, 0}, {0, 5}};
const Ring kJunction = {{-5, -2.4}, {4, -2.4}, {4, 0}, {0, 0}, {0, 4.5}, {-2.4, 4.5}, {-2.4, 0}, {-5, 0}};

struct Comparison {
  std::string experiment, against;
  bool same_run = false;
  Source source;
  MeasureLine line;  ///< the middle of the area
  std::vector<std::string> curves;
};

std::vector<Comparison> comparisons() {
  const Source one_way{{"hermes_uo/uo-050-180-180.txt", "hermes_uo/uo-100-180-180.txt", "hermes_uo/uo-145-180-180.txt",
                        "hermes_uo/uo-180-180-120.txt"},
                       kHermes,
                       kOneWay};
  const Source two_way{{"hermes_bo/bo-360-050-050.txt", "hermes_bo/bo-360-090-090.txt"}, kHermes, box(0, -4, 3.6, 4)};
  const Source corner{{"hermes_corner/traj.txt"}, kMetres16, kCorner};
  const Source junction{{"hermes_t_junction/traj_KO_240_050_240.txt"}, kMetres16, kJunction};
  return {
      {"one-way corridor, 1.8 m",
       "UO, 3.0 m",
       false,
       one_way,
       {{1.8, 0}, {0, 0}},
       {"fd_uo_open_corridor/uo-080-300-300.dat", "fd_uo_open_corridor/uo-120-300-300.dat",
        "fd_uo_open_corridor/uo-180-300-300.dat", "fd_uo_open_corridor/uo-300-300-080.dat",
        "fd_uo_open_corridor/uo-300-300-120.dat", "fd_uo_open_corridor/uo-300-300-200.dat",
        "fd_uo_open_corridor/uo-300-300-300.dat"}},
      {"two-way corridor, 3.6 m",
       "BOT, 3.6 m",
       false,
       two_way,
       {{0, 0}, {3.6, 0}},
       {"fd_bo_bidirectional/bot-360-050-050.dat", "fd_bo_bidirectional/bot-360-090-090.dat",
        "fd_bo_bidirectional/bot-360-120-120.dat"}},
      {"corner, 3.0 m, before",
       "EO, 2.4 m, before",
       false,
       corner,
       {{1, 0}, {1, -3}},
       {"fd_eo_corner/eo-240-050-240_id_1.dat", "fd_eo_corner/eo-240-060-240_id_1.dat",
        "fd_eo_corner/eo-240-100-240_id_1.dat", "fd_eo_corner/eo-240-150-240_id_1.dat"}},
      {"corner, 3.0 m, behind",
       "EO, 2.4 m, behind",
       false,
       corner,
       {{-3, 1}, {0, 1}},
       {"fd_eo_corner/eo-240-060-240_id_2.dat", "fd_eo_corner/eo-240-080-240_id_2.dat",
        "fd_eo_corner/eo-240-150-240_id_2.dat", "fd_eo_corner/eo-240-240-240_id_2.dat"}},
      {"T-junction, 2.4 m, front",
       "KO, the same run",
       true,
       junction,
       {{-2.4, 1.5}, {0, 1.5}},
       {"fd_ko_t_junction/ko-240-050-240_id_1.dat"}},
      {"T-junction, 2.4 m, left",
       "KO, the same run",
       true,
       junction,
       {{-3.5, 0}, {-3.5, -2.4}},
       {"fd_ko_t_junction/ko-240-050-240_id_2.dat"}},
      {"T-junction, 2.4 m, right",
       "KO, the same run",
       true,
       junction,
       {{1.1, 0}, {1.1, -2.4}},
       {"fd_ko_t_junction/ko-240-050-240_id_3.dat"}},
  };
}

Result<scene::Trajectories> recording_of(const std::filesystem::path& data, const std::string& file,
                                         const io::TrajectoryOptions& reading) {
  return io::read_trajectories(data / "pedestrians/juelich" / file, reading);
}

Result<Points> curve_of(const std::filesystem::path& data, const std::vector<std::string>& files) {
  Points points;
  for (const std::string& file : files) {
    const std::string path = (data / "pedestrians/reference_fd" / file).string();
    Result<Points> more = read_curve(path);
    if (!more) return invalid(path, more.error().text());
    points.insert(points.end(), more->begin(), more->end());
  }
  return points;
}

Points steady_points(scene::Trajectories t, const Ring& walls, const MeasureLine& line) {
  t.walkable = {{walls, {}}};
  const Recording recording(t);
  const auto span = steady_span(flow(crossings(recording, line), line.length()));
  if (!span) return {};
  const VoronoiDensity voronoi =
      voronoi_density(recording, VoronoiGround(t.walkable), make_measure_area(box_around(line, 2), t.walkable),
                      speeds(velocities(recording, {})));
  return fundamental_points(voronoi.rows, span->first, span->second);
}

FundamentalPoint medians(const Points& points) {
  std::vector<double> densities, speeds;
  for (const FundamentalPoint& p : points) densities.push_back(p.density), speeds.push_back(p.speed);
  return {median(densities), median(speeds)};
}

void judge(CurveAgreement& agreement) {
  agreement.speed =
      compare_curves(density_bins(agreement.ours, kSlice), density_bins(agreement.theirs, kSlice), kLeast);
  agreement.our_median = medians(agreement.ours), agreement.their_median = medians(agreement.theirs);
}

/// People one behind the other on the filmed straight of an oval.
Result<Points> single_file(const std::filesystem::path& data) {
  Points points;
  for (const char* file : {"UX_14_1", "UX_20_1", "UX_30_1"}) {
    const auto t = recording_of(data, "single_file/subaih2019/" + std::string(file) + ".txt", kMetres25);
    if (!t) return t.error();
    const Recording recording(*t);
    const Points more = single_file_points(recording, velocities(recording, {}), {{0, 0}, {1, 0}, 0, 3.14});
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

}  // namespace

Result<std::vector<CurveAgreement>> curve_agreements(const std::filesystem::path& data) {
  std::vector<CurveAgreement> agreements;
  for (const Comparison& c : comparisons()) {
    CurveAgreement agreement{c.experiment, c.against, c.same_run};
    Result<Points> theirs = curve_of(data, c.curves);
    if (!theirs) return theirs.error();
    agreement.theirs = std::move(*theirs);
    for (const std::string& file : c.source.files) {
      Result<scene::Trajectories> t = recording_of(data, file, c.source.reading);
      if (!t) return t.error();
      const Points more = steady_points(std::move(*t), c.source.walls, c.line);
      agreement.ours.insert(agreement.ours.end(), more.begin(), more.end());
    }
    judge(agreement);
    agreements.push_back(std::move(agreement));
  }
  const Result<Points> file = single_file(data);
  if (!file) return file.error();
  std::vector<std::string> rings;
  for (const char* n : {"14", "20", "22", "28", "34", "45", "56", "70"})
    rings.push_back("fd_1d_single_file/n" + std::string(n) + ".dat");
  for (const auto& [against, curves] :
       {std::pair{std::string("Seyfried 2005, ring"),
                  std::vector<std::string>{"single_file_2col/01_FD_germany_seyfried2005_all.txt"}},
        std::pair{std::string("N = 14 … 70, ring"), rings}}) {
    CurveAgreement agreement{"single file, oval (per metre)", against};
    Result<Points> theirs = curve_of(data, curves);
    if (!theirs) return theirs.error();
    agreement.ours = *file, agreement.theirs = std::move(*theirs);
    judge(agreement);
    agreements.push_back(std::move(agreement));
  }
  return agreements;
}

Result<std::vector<FlowAgreement>> flow_agreements(const std::filesystem::path& data) {
  struct Run {
    const char* file;
    io::TrajectoryOptions reading;
    double width;
    MeasureLine line;
  };
  const MeasureLine behind{{2.8, -3}, {-1, -3}};
  const std::vector<Run> runs = {
      {"bottleneck_wuppertal2018/040_c_56_h-.txt", kMetres25, 0.5, {{0.35, -0.3}, {-0.35, -0.3}}},
      {"hermes_uo/uo-050-180-180.txt", kHermes, 0.5, behind},
      {"hermes_uo/uo-100-180-180.txt", kHermes, 1.0, behind},
      {"hermes_uo/uo-180-180-120.txt", kHermes, 1.2, behind}};
  const Result<Points> published =
      curve_of(data, {"flow_vs_width/2006EG.txt", "flow_vs_width/2006Kretz.txt", "flow_vs_width/2009Seyfried.txt",
                      "flow_vs_width/2009AO.txt", "flow_vs_width/2010Daamen.txt"});
  if (!published) return published.error();
  std::vector<FlowAgreement> agreements;
  for (const Run& run : runs) {
    const Result<scene::Trajectories> t = recording_of(data, run.file, run.reading);
    if (!t) return t.error();
    FlowAgreement agreement{run.file, run.width};
    agreement.flow = flow(crossings(Recording(*t), run.line), run.width).flow;
    for (const FundamentalPoint& p : *published) {  // width and flow
      if (std::abs(p.density - run.width) > 1e-9) continue;
      agreement.low = agreement.published == 0 ? p.speed : std::min(agreement.low, p.speed);
      agreement.high = std::max(agreement.high, p.speed);
      ++agreement.published;
    }
    agreements.push_back(agreement);
  }
  return agreements;
}

}  // namespace inhabit::session
