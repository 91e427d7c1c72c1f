#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "crowd/measures/recording.h"
#include "render/heat_map.h"
#include "render/plot.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

using crowd::known;
using render::Axis;
using render::Plot;
using render::Series;

// A plot shows no more; what is left out is evenly spread.
constexpr std::size_t kMostDots = 1500, kMostPoints = 2000, kMostWalkers = 250;
constexpr render::Color kDots = render::rgb(0x9db2c4, 0.6);

/// Every k-th of the points, so that at most `most` are left.
std::vector<Vec2> thinned(const std::vector<Vec2>& points, std::size_t most) {
  const std::size_t step = points.size() / most + 1;
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); i += step) kept.push_back(points[i]);
  return kept;
}

std::vector<Vec2> xy(const std::vector<crowd::FundamentalPoint>& points) {
  std::vector<Vec2> list;
  for (const crowd::FundamentalPoint& p : points) list.push_back({p.density, p.speed});
  return list;
}

/// Bars as a line that goes up and down.
Series histogram(const std::vector<double>& values, double width) {
  Series series;
  if (values.empty()) return series;
  const double low = std::floor(values.front() / width);
  std::vector<double> counts(static_cast<std::size_t>(std::floor(values.back() / width) - low) + 1);
  for (const double v : values) counts[static_cast<std::size_t>(std::floor(v / width) - low)] += 1;
  series.points.push_back({low * width, 0});
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double x = (low + static_cast<double>(k)) * width, share = counts[k] / static_cast<double>(values.size());
    series.points.push_back({x, share / width});
    series.points.push_back({x + width, share / width});
  }
  series.points.push_back({series.points.back().x, 0});
  return series;
}

Plot people_plot(const MeasureReport& r) {
  Plot plot{"People over time", r.name, {"time", "s"}, {"people"}, {}, {}, {}, {}};
  Series there{"there at the time", {}, {}, {}, render::Marker::none};
  for (const crowd::Presence::Row& row : r.presence.rows)
    there.points.push_back({row.seconds, static_cast<double>(row.people)});
  there.points = thinned(there.points, kMostPoints);
  Series crossed{"have crossed the line", {}, {}, {}, render::Marker::none};
  for (std::size_t k = 0; k < r.flow.times.size(); ++k) {
    crossed.points.push_back({r.flow.times[k], static_cast<double>(k)});
    crossed.points.push_back({r.flow.times[k], static_cast<double>(k + 1)});
  }
  plot.series = {there, crossed};
  return plot;
}

Plot diagram_plot(const MeasureReport& r, const std::vector<crowd::FundamentalPoint>& reference) {
  Plot plot{"Fundamental diagram", r.name, {"density", "1/m²"}, {"speed", "m/s"}, {}, {}, {}, {}};
  plot.x.min = 0, plot.y.min = 0;
  if (r.steady)
    plot.subtitle += " · steady from " + fixed(r.steady->first, 1) + " to " + fixed(r.steady->second, 1) + " s";
  plot.series.push_back(
      {"Voronoi, one dot per frame", thinned(xy(r.points), kMostDots), {}, kDots, render::Marker::circle, 0});
  if (!reference.empty())
    plot.series.push_back(
        {"published", thinned(xy(reference), kMostDots), {}, render::rgb(0xc4663a, 0.8), render::Marker::triangle, 0});
  Series medians{"median and quartiles", {}, {}, render::rgb(0x1f4e79), render::Marker::square, 2};
  double most = 1;
  for (const crowd::DensityBin& bin : r.bins) {
    if (bin.count < 5) continue;
    medians.points.push_back({bin.density, bin.median});
    medians.band.emplace_back(bin.lower, bin.upper);
    most = std::max(most, bin.high);
  }
  plot.series.push_back(medians);
  Series curve{"Weidmann", {}, {}, render::rgb(0x5f6b78), render::Marker::none, 1.5, true};
  for (double d = 0; d <= std::min(most + 0.5, 5.4); d += 0.05) curve.points.push_back({d, crowd::weidmann_speed(d)});
  plot.series.push_back(curve);
  return plot;
}

Plot density_plot(const MeasureReport& r) {
  Plot plot{"Density in the area", r.name, {"time", "s"}, {"density", "1/m²"}, {}, {}, {}, {}};
  plot.y.min = 0;
  Series voronoi{"Voronoi", {}, {}, {}, render::Marker::none, 2};
  Series classic{"classic", {}, {}, kDots, render::Marker::none, 1};
  for (const crowd::AreaRow& row : r.voronoi) voronoi.points.push_back({row.seconds, row.density});
  for (const crowd::AreaRow& row : r.classic) classic.points.push_back({row.seconds, row.density});
  voronoi.points = thinned(voronoi.points, kMostPoints), classic.points = thinned(classic.points, kMostPoints);
  plot.series = {classic, voronoi};
  return plot;
}

Plot speed_plot(const MeasureReport& r) {
  Plot plot{"Speeds of all positions", r.name, {"speed", "m/s"}, {"share", "per m/s"}, {}, {}, {}, {}};
  std::vector<double> usual;
  for (const double v : r.speeds)
    if (v < 4) usual.push_back(v);
  plot.series = {histogram(usual, 0.05)};
  return plot;
}

Plot collision_plot(const MeasureReport& r) {
  const crowd::TimesToCollision& ttc = r.times_to_collision;
  Plot plot{"Time to collision of pairs", r.name, {"time", "s"}, {"share", "per s"}, {}, {}, {}, {}};
  plot.subtitle += " · discs of " + shortest(r.radius) + " m nearer than 10 m";
  Series series;
  for (std::size_t k = 0; k < ttc.histogram.size(); ++k) {
    const double x = static_cast<double>(k) * ttc.step;
    const double share =
        static_cast<double>(ttc.histogram[k]) / (static_cast<double>(std::max<std::size_t>(ttc.pairs, 1)) * ttc.step);
    series.points.push_back({x, share});
    series.points.push_back({x + ttc.step, share});
  }
  plot.series = {series};
  return plot;
}

/// Everybody's way along the main flow over time.
Plot space_time_plot(const scene::Trajectories& t, const MeasureReport& r) {
  Plot plot{"Space and time", r.name, {"time", "s"}, {"way along the main flow", "m"}, {}, {}, {}, {}};
  const crowd::Recording recording(t);
  const std::size_t step = recording.tracks.size() / kMostWalkers + 1;
  if (step > 1) plot.subtitle += " · one in " + std::to_string(step) + " people";
  for (std::size_t k = 0; k < recording.tracks.size(); k += step) {
    const auto track = recording.tracks[k];
    Series series{"", {}, {}, {}, render::Marker::none, 0.9};
    const std::size_t stride = track.size() / 60 + 1;
    std::int32_t before = recording.fix(track.front()).frame;
    for (std::size_t i = 0; i < track.size(); i += stride) {
      const scene::Fix& fix = recording.fix(track[i]);
      const double seconds = recording.seconds(fix.frame);
      if (seconds < r.from || seconds > r.until) continue;
      // Who was away for a second and more is no line.
      if (recording.seconds(fix.frame - before) > 1 + recording.seconds(static_cast<std::int32_t>(stride)))
        series.points.push_back({crowd::kUnknown, 0});
      before = fix.frame;
      series.points.push_back({seconds, dot(fix.at() - r.main_flow.center, r.main_flow.axis)});
    }
    if (series.points.size() < 2) continue;
    const bool along = series.points.back().y >= series.points.front().y;
    series.color = along ? render::rgb(0x2f6690, 0.55) : render::rgb(0xc4663a, 0.55);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

render::HeatMap field_map(const MeasureReport& r) {
  render::HeatMap map;
  map.title = "Mean density", map.subtitle = r.name;
  map.label = "density", map.unit = "1/m²";
  map.origin = r.field.origin, map.cell = r.field.cell, map.columns = r.field.columns, map.rows = r.field.rows;
  map.values = r.field.density;
  map.ground = r.ground, map.outlines = {r.place.area.ring}, map.lines = {{r.place.line.a, r.place.line.b}};
  return map;
}

}  // namespace

Result<std::vector<std::pair<std::string, std::string>>> measure_plots(
    const scene::Trajectories& trajectories, const MeasureReport& report, const std::string& format,
    const std::vector<crowd::FundamentalPoint>& reference) {
  const std::optional<render::Format> kind = render::format_of("plot." + format);
  if (!kind) return Error{ErrorCode::unsupported, "a plot is svg, png or pdf, not " + format, ""};
  std::vector<std::pair<std::string, render::Drawing>> drawings;
  drawings.emplace_back("people", render::draw_plot(people_plot(report)));
  drawings.emplace_back("fundamental-diagram", render::draw_plot(diagram_plot(report, reference)));
  drawings.emplace_back("density", render::draw_plot(density_plot(report)));
  drawings.emplace_back("speeds", render::draw_plot(speed_plot(report)));
  drawings.emplace_back("time-to-collision", render::draw_plot(collision_plot(report)));
  drawings.emplace_back("space-time", render::draw_plot(space_time_plot(trajectories, report)));
  if (!report.field.density.empty()) drawings.emplace_back("density-field", render::draw_heat_map(field_map(report)));
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [name, drawing] : drawings) {
    Result<std::string> bytes = render::encode(drawing, *kind, {1600});
    if (!bytes) return bytes.error();
    files.emplace_back(name, std::move(*bytes));
  }
  return files;
}

}  // namespace inhabit::session
