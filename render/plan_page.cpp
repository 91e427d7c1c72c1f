#include <algorithm>

#include "core/text.h"
#include "render/plan_parts.h"

/// What stands round a plan: title, measures, scale bar, verdict, legend.
namespace inhabit::render {
namespace {

/// 1, 2 or 5 times a power of ten, at most `value`.
double nice_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double m : {5.0, 2.0})
    if (m * power <= value) return m * power;
  return power;
}

/// A measure between two points: line, slanted ticks, text above it.
void draw_measure(Drawing& drawing, const Page& page, Vec2 a, Vec2 b, const std::string& text) {
  const Vec2 d = unit(b - a), tick = 4.0 * page.text * unit(d + perp(d));
  Path line;
  line.segment(a - 5 * d, b + 5 * d);
  stroke(drawing, std::move(line), ink::kFaint, 0.6 * page.line);
  Path ticks;
  ticks.segment(a - tick, a + tick).segment(b - tick, b + tick);
  stroke(drawing, std::move(ticks), ink::kText, 1.1 * page.line);
  const double size = 11 * page.text;
  // A piece of paper behind the text interrupts the line.
  const Vec2 middle = 0.5 * (a + b);
  Box gap{middle, d, text_width(text, size) / 2 + 5, 0.7 * size};
  fill(drawing, Path{}.polygon(gap), drawing.background);
  write(drawing, {text, middle + 0.36 * size * perp(d), size, ink::kText, Anchor::middle, false, angle_of(d)});
}

std::string count_text(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

/// What is wrong, in a few words each; nothing when all is well.
std::vector<std::string> problems(const layout::CheckReport& report, const Stock& stock) {
  std::vector<std::string> out;
  std::size_t outside = 0;
  double deepest = 0;
  for (const auto& o : report.outside) outside += std::isfinite(o.depth) ? 1 : 0;
  for (const auto& o : report.overlaps) deepest = std::max(deepest, o.depth);
  if (!report.overlaps.empty())
    out.push_back(count_text(report.overlaps.size(), "overlap", "overlaps") + ", deepest " + metres_text(deepest));
  if (outside > 0) out.push_back(std::to_string(outside) + " outside the room");
  if (stock.waiting > 0) out.push_back(std::to_string(stock.waiting) + " not placed");
  if (!report.blocked_doors.empty())
    out.push_back(count_text(report.blocked_doors.size(), "door blocked", "doors blocked"));
  if (!report.reachable.unreachable.empty())
    out.push_back(std::to_string(report.reachable.unreachable.size()) + " out of reach");
  return out;
}

/// A dot and a line of text; returns nothing, right-aligned at `at`.
void draw_verdict(Drawing& drawing, const Page& page, const Stock& stock, const layout::CheckReport& report, Vec2 at) {
  const double size = 11 * page.text;
  const std::string head = report.feasible ? "feasible" : "not feasible";
  const std::string energy = "energy " + fixed(report.energy, report.energy < 10 ? 3 : 1);
  const Color color = report.feasible ? ink::kGood : ink::kProblem;
  write(drawing, {energy, at, size, ink::kFaint, Anchor::end});
  const Vec2 left = at - Vec2{text_width(energy, size) + 12 * page.text, 0};
  write(drawing, {head, left, size, color, Anchor::end, true});
  fill(drawing, Path{}.circle(left - Vec2{text_width(head, size, true) + 9 * page.text, 0.36 * size}, 3.4 * page.text),
       color);
  std::string line;
  for (const std::string& problem : problems(report, stock)) line += (line.empty() ? "" : "  ·  ") + problem;
  write(drawing,
        {fitted(line, 0.6 * page.size.x, 0.9 * size), at + Vec2{0, 1.4 * size}, 0.9 * size, ink::kText, Anchor::end});
}

/// The legend in columns; returns its height.
double draw_legend(Drawing& drawing, const Page& page, const std::vector<LegendRow>& legend, Vec2 at, double width) {
  const double size = 10.5 * page.text, line = 20 * page.text, icon = 15 * page.text;
  double column = 0;
  for (const LegendRow& row : legend) column = std::max(column, text_width(row.text, size));
  column = std::min(column + icon + 26 * page.text, width);
  const auto columns = static_cast<std::size_t>(std::max(1.0, width / column));
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const LegendRow& row = legend[i];
    const Vec2 p = at + Vec2{static_cast<double>(i % columns) * column, static_cast<double>(i / columns) * line};
    const Vec2 middle = p + Vec2{icon / 2, 0};
    if (row.sample) {
      Box box{middle, {0, 1}, row.sample->box.half_depth, row.sample->box.half_width};
      const double shrink = icon / 2 / std::max({box.half_depth, box.half_width, 1e-9});
      // At least a third as thick as long, so that a pencil is more than a line.
      box.half_depth = std::max(box.half_depth * shrink, icon / 6);
      box.half_width = std::max(box.half_width * shrink, icon / 6);
      draw_symbol(drawing, *row.sample, box, shrink, page.line);
    } else {
      write(drawing, {row.key, p + Vec2{icon, 0.36 * size}, size, ink::kText, Anchor::end, true});
    }
    write(drawing, {fitted(row.text, column - icon - 10 * page.text, size), p + Vec2{icon + 8 * page.text, 0.36 * size},
                    size, ink::kText});
  }
  return legend.empty() ? 0 : line * static_cast<double>((legend.size() + columns - 1) / columns);
}

}  // namespace

void draw_scale_bar(Drawing& drawing, const Page& page, Vec2 at) {
  const double longest = 0.24 * page.size.x / page.frame.scale;
  const double unit_length = nice_below(longest / 2);
  const bool cm = unit_length < 0.5;
  const int parts = std::max(1, std::min(5, static_cast<int>(longest / unit_length)));
  const double step = page.frame.scale * unit_length, height = 4 * page.text, size = 9.5 * page.text;
  for (int i = 0; i < parts; ++i) {
    const Box part{at + Vec2{(i + 0.5) * step, height / 2}, {1, 0}, step / 2, height / 2};
    add(drawing, Path{}.polygon(part),
        {.fill = i % 2 ? ink::kFloor : ink::kText, .stroke = ink::kText, .width = 0.7 * page.line});
  }
  for (int i = 0; i <= parts; ++i) {
    std::string text = shortest(std::round(1e6 * i * unit_length * (cm ? 100 : 1)) / 1e6);
    if (i == parts) text += cm ? " cm" : " m";
    // The unit hangs over the right end, so that the numbers stand under their ticks.
    const double shift =
        i == parts ? text_width(shortest(std::round(1e6 * i * unit_length * (cm ? 100 : 1)) / 1e6), size) / 2 : 0;
    write(drawing, {text, at + Vec2{i * step - shift, height + 1.25 * size}, size, ink::kText,
                    i == parts ? Anchor::start : Anchor::middle});
  }
}

Vec2 measures_corner(const Page& page, const Stock& stock) {
  const double off = page.frame.scale * stock.wall + 20 * page.text;
  return page.frame.page(stock.furnished.min) + Vec2{-off, off};
}

void draw_title(Drawing& drawing, const Page& page, const Stock& stock, const scene::Scene& scene) {
  const double x = page.area.min.x + 16 * page.text, width = page.size.x - 2 * x;
  const std::string name = scene.name.empty() ? "Plan" : scene.name;
  write(drawing, {fitted(name, width, 20 * page.text, true),
                  {x, 34 * page.text},
                  20 * page.text,
                  ink::kText,
                  Anchor::start,
                  true});
  const Vec2 size = stock.room.size();
  std::string line = fixed(size.x, 2) + " × " + fixed(size.y, 2) + " m";
  const double area = scene.space.outline.size() >= 3 ? std::abs(signed_area(scene.space.outline)) : 0;
  if (area > 0 && area < 1e12) line += "  ·  " + fixed(area, area < 10 ? 2 : area < 1000 ? 1 : 0) + " m²";
  line += "  ·  " + count_text(scene.objects.size(), "object", "objects");
  if (stock.far > 0) line += "  ·  " + std::to_string(stock.far) + " too far outside to be shown";
  write(drawing, {fitted(line, width, 11.5 * page.text), {x, 53 * page.text}, 11.5 * page.text, ink::kFaint});
}

void draw_dimensions(Drawing& drawing, const Page& page, const Stock& stock) {
  const Vec2 a = page.frame.page(stock.room.min), b = page.frame.page(stock.room.max), size = stock.room.size();
  const Vec2 at = measures_corner(page, stock);
  draw_measure(drawing, page, {a.x, at.y}, {b.x, at.y}, fixed(size.x, 2) + " m");
  draw_measure(drawing, page, {at.x, a.y}, {at.x, b.y}, fixed(size.y, 2) + " m");
}

void draw_footer(Drawing& drawing, Page& page, const Stock& stock, const std::vector<LegendRow>& legend,
                 const PlanOptions& options) {
  const double left = page.area.min.x + 16 * page.text, right = page.size.x - left;
  double y = page.size.y;
  if (options.scale_bar) draw_scale_bar(drawing, page, {left, y});
  if (options.report && options.verdict)
    draw_verdict(drawing, page, stock, *options.report, {right, y + 6 * page.text});
  if (options.scale_bar || (options.report && options.verdict)) y += 36 * page.text;
  if (!legend.empty()) {
    stroke(drawing, Path{}.segment({left, y}, {right, y}), ink::kHairline, 0.7 * page.line);
    y += 17 * page.text;
    y += draw_legend(drawing, page, legend, {left, y}, right - left);
  }
  page.size.y = y + (y > page.size.y ? 4 * page.text : 0);
}

}  // namespace inhabit::render
