#include "core/text.h"
#include "session/bench.h"
#include "session/published_curves.h"

namespace inhabit::session {
namespace {

constexpr double kSlice = 0.25;

BenchCurve::Line line_of(const std::string& name, const std::vector<crowd::FundamentalPoint>& points) {
  BenchCurve::Line line{name, {}, {}};
  for (const crowd::DensityBin& bin : crowd::density_bins(points, kSlice)) {
    if (bin.count < 5) continue;
    line.x.push_back(bin.density), line.y.push_back(bin.median);
  }
  return line;
}

BenchCurve curve_of(const CurveAgreement& a) {
  BenchCurve curve{"measures",
                   "Median speed by density: " + a.experiment + " (ours), " + a.against + " (published)",
                   "density [1/m²]",
                   "speed [m/s]",
                   false,
                   false,
                   {}};
  curve.lines = {line_of("ours", a.ours), line_of("published", a.theirs)};
  BenchCurve::Line weidmann{"Weidmann", {}, {}};
  for (double d = 0.25; d <= 4; d += 0.25) weidmann.x.push_back(d), weidmann.y.push_back(crowd::weidmann_speed(d));
  curve.lines.push_back(std::move(weidmann));
  return curve;
}

}  // namespace

Result<BenchGroup> bench_measures(const BenchOptions& options) {
  if (options.data.empty())
    return Error{ErrorCode::not_found, "measures needs the data folder: --data or the variable INHABIT_DATA", ""};
  const Result<std::vector<CurveAgreement>> curves = curve_agreements(options.data);
  if (!curves) return curves.error();
  const Result<std::vector<FlowAgreement>> flows = flow_agreements(options.data);
  if (!flows) return flows.error();
  BenchGroup group;
  Table speeds{"measures", "Voronoi fundamental diagrams of recordings, ours and published", {}, {}, {}};
  speeds.columns = {{"experiment"},   {"against"},    {"slices", 0},    {"mean m/s", 3},  {"rms m/s", 3},
                    {"worst m/s", 3}, {"density", 3}, {"published", 3}, {"speed m/s", 3}, {"published m/s", 3}};
  for (const CurveAgreement& a : *curves) {
    std::vector<Cell> row = {a.experiment, a.against,    static_cast<double>(a.speed.bins),
                             a.speed.mean, a.speed.rmse, a.speed.worst};
    if (a.same_run)
      for (const double value :
           {a.our_median.density, a.their_median.density, a.our_median.speed, a.their_median.speed})
        row.emplace_back(value);
    row.resize(speeds.columns.size());
    speeds.rows.push_back(std::move(row));
  }
  speeds.notes = {
      "differences of median speeds (ours - published) in slices of 0.25 people per square metre, per metre in "
      "single file,",
      "with at least 5 points each; medians of density and speed over all points where the run is the same"};
  Table widths{"measures-flow", "Flow through bottlenecks, people per second", {}, {}, {}};
  widths.columns = {{"recording"}, {"width m", 2}, {"flow", 3}, {"published least", 3}, {"most", 3}, {"of runs", 0}};
  for (const FlowAgreement& f : *flows)
    widths.rows.push_back({f.experiment, f.width, f.flow, f.low, f.high, static_cast<double>(f.published)});
  group.tables = {std::move(speeds), std::move(widths)};
  group.curves = {curve_of(curves->front())};
  return group;
}

}  // namespace inhabit::session
