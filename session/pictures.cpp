#include "session/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "render/plan.h"
#include "render/plot.h"
#include "render/sheet.h"

namespace inhabit::session {
namespace {

Result<render::Format> format_for(std::string_view file_name) {
  if (const std::optional<render::Format> format = render::format_of(file_name)) return *format;
  return Error{ErrorCode::unsupported, "a picture is written as .svg, .png or .pdf", ""};
}

render::PlanOptions plan_options(const PictureOptions& options) {
  render::PlanOptions plan;
  if (!options.labels) plan.labels = render::PlanOptions::Labels::none;
  plan.clearances = options.clearances;
  plan.views = options.views;
  plan.door_zones = options.door_zones;
  return plan;
}

Result<std::string> encoded(const render::Drawing& drawing, std::string_view file_name, const PictureOptions& options) {
  const Result<render::Format> format = format_for(file_name);
  if (!format) return format.error();
  return render::encode(drawing, *format, {options.pixels});
}

render::Drawing plan_of(const Scene& scene, const PictureOptions& options) {
  render::PlanOptions plan = plan_options(options);
  if (!options.problems) return render::draw_plan(scene, plan);
  const layout::CheckReport report = layout::check(scene);
  plan.report = &report;
  return render::draw_plan(scene, plan);
}

}  // namespace

Status check_picture_name(std::string_view file_name) {
  const Result<render::Format> format = format_for(file_name);
  if (!format) return format.error();
  return Done{};
}

Result<std::string> plan_picture(const Document& document, std::string_view file_name, const PictureOptions& options) {
  if (document.scenes.size() == 1) return encoded(plan_of(document.scenes.front(), options), file_name, options);
  std::vector<layout::CheckReport> reports;
  if (options.problems)
    for (const Scene& scene : document.scenes) reports.push_back(layout::check(scene));
  std::vector<render::SheetCell> cells;
  for (std::size_t i = 0; i < document.scenes.size(); ++i) {
    render::SheetCell cell;
    cell.scene = &document.scenes[i];
    cell.caption = document.scenes[i].name;
    if (options.problems) cell.report = &reports[i];
    cells.push_back(std::move(cell));
  }
  render::SheetOptions sheet;
  sheet.title = document.name;
  sheet.labels = options.labels;
  return encoded(render::draw_sheet(cells, sheet), file_name, options);
}

Result<std::string> sheet_picture(const Furnished& furnished, std::string_view file_name,
                                  const PictureOptions& options) {
  std::vector<render::SheetCell> cells;
  for (const FurnishedRoom& room : furnished.rooms)
    for (std::size_t k = 0; k < room.suggestions.size(); ++k) {
      const Suggestion& suggestion = room.suggestions[k];
      render::SheetCell cell;
      cell.scene = &suggestion.scene;
      if (furnished.rooms.size() > 1) cell.caption = room.name + " · ";
      cell.caption += std::to_string(k + 1);
      if (k == 0) cell.caption += " · best";
      cell.feasible = suggestion.report.feasible;
      cell.energy = suggestion.report.energy;
      cells.push_back(std::move(cell));
    }
  if (cells.empty()) return Error{ErrorCode::not_found, "there is nothing to draw: no room was furnished", ""};
  render::SheetOptions sheet;
  sheet.title = furnished.rooms.size() == 1 ? furnished.rooms.front().name : "Suggestions";
  sheet.labels = options.labels;
  return encoded(render::draw_sheet(cells, sheet), file_name, options);
}

Result<std::string> trace_picture(const std::vector<layout::TraceRow>& trace, std::string_view title,
                                  std::string_view file_name) {
  render::Drawing drawing = render::draw_energy(trace);
  if (!title.empty()) drawing.title = title;
  return encoded(drawing, file_name, {});
}

Result<std::string> sheet_picture(const BenchSheet& sheet, std::string_view file_name) {
  std::vector<render::SheetCell> cells;
  for (const BenchSheet::Cell& c : sheet.cells) {
    render::SheetCell cell;
    cell.scene = &c.scene, cell.caption = c.caption;
    cells.push_back(std::move(cell));
  }
  if (cells.empty()) return Error{ErrorCode::not_found, "there is nothing to draw: no room was furnished", ""};
  render::SheetOptions options;
  options.title = sheet.title, options.columns = sheet.columns;
  return encoded(render::draw_sheet(cells, options), file_name, {});
}

Result<std::string> trace_picture(const std::vector<annealing::TraceRow>& trace, std::string_view title,
                                  std::string_view file_name) {
  // The cheapest start: rows of one start follow each other.
  std::map<int, double> last;
  for (const annealing::TraceRow& row : trace) last[row.start] = row.cost;
  const auto best = std::ranges::min_element(last, {}, [](const auto& entry) { return entry.second; });
  render::Plot plot;
  plot.title = title.empty() ? "Cost by term" : std::string(title);
  plot.subtitle = "weighted, as annealing goes on";
  if (last.size() > 1) plot.subtitle += "; the cheapest of " + std::to_string(last.size()) + " starts";
  plot.x.label = "iteration";
  plot.y.label = "cost";
  plot.y.log = true;
  render::Series total{"all"};
  total.color = render::rgb(0x222222), total.width = 2.4;
  std::vector<render::Series> parts;
  constexpr std::array kColors = {0xc2603au, 0x2e8b57u, 0x7b4fa0u, 0xb8952eu, 0x5a6778u,
                                  0x1f6fb2u, 0xd04a8cu, 0xc0392bu, 0x8a8a8au};
  for (const std::string_view name : annealing::term_names()) {
    render::Series part{std::string(name)};
    part.color = render::rgb(kColors[parts.size() % kColors.size()]);
    part.width = 1.4, part.dashed = parts.size() >= 7;  // our own two
    parts.push_back(std::move(part));
  }
  double most = 0;
  for (const annealing::TraceRow& row : trace) most = std::max(most, row.cost);
  // Below a hundred thousandth nothing is to be seen; a logarithm needs something.
  const double least = most * 1e-5;
  for (const annealing::TraceRow& row : trace) {
    if (row.start != best->first) continue;
    const auto x = static_cast<double>(row.iteration);
    total.points.push_back({x, std::max(row.cost, least)});
    for (std::size_t k = 0; k < parts.size(); ++k)
      parts[k].points.push_back({x, row.parts[k] > least ? row.parts[k] : std::nan("")});
  }
  plot.series.push_back(std::move(total));
  for (render::Series& part : parts)
    if (std::ranges::any_of(part.points, [](Vec2 p) { return p.y > 0; })) plot.series.push_back(std::move(part));
  return encoded(render::draw_plot(plot), file_name, {});
}

Result<std::string> curve_picture(const BenchCurve& curve, std::string_view file_name) {
  render::Plot plot;
  plot.title = curve.title;
  plot.x.label = curve.x_label;
  plot.x.log = curve.log_x;
  plot.y.label = curve.y_label;
  plot.y.log = curve.log_y;
  for (const BenchCurve::Line& line : curve.lines) {
    render::Series series;
    series.label = line.name;
    series.marker = render::Marker::circle;
    for (std::size_t i = 0; i < line.x.size(); ++i) series.points.push_back({line.x[i], line.y[i]});
    plot.series.push_back(std::move(series));
  }
  return encoded(render::draw_plot(plot), file_name, {});
}

}  // namespace inhabit::session
