#include "render/plot.h"

#include <algorithm>

#include "core/text.h"
#include "render/frame.h"
#include "render/labels.h"

namespace inhabit::render {
namespace {

constexpr Color kPalette[] = {rgb(0x2f6690), rgb(0xc4663a), rgb(0x4d8b5a), rgb(0x8a5a8f), rgb(0xb9962e), rgb(0x5f6b78)};
constexpr double kText = 11.5;

bool usable(double v, const Axis& axis) { return std::abs(v) < 1e300 && (!axis.log || v > 0); }

/// An axis with its range settled.
struct Range {
  bool log = false;
  double low = 0, high = 1;
  std::vector<double> ticks;

  double share(double v) const {
    return log ? (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low)) : (v - low) / (high - low);
  }
};

Range settle(const Axis& axis, double low, double high, int wanted) {
  Range r{axis.log};
  if (axis.min && usable(*axis.min, axis)) low = *axis.min;
  if (axis.max && usable(*axis.max, axis)) high = *axis.max;
  if (!(low <= high)) low = axis.log ? 1 : 0, high = axis.log ? 10 : 1;
  if (axis.log) {
    if (high / low < 1.5) low /= 2, high *= 2;
    r.ticks = log_ticks(low, high);
    if (!axis.min) low /= std::pow(high / low, 0.03);
    if (!axis.max) high *= std::pow(high / low, 0.03);
  } else {
    if (!(high - low > 1e-12 * std::max({std::abs(low), std::abs(high), 1e-30}))) {
      const double grow = std::max(0.5 * std::abs(low), 0.5);
      low -= grow, high += grow;
    }
    r.ticks = nice_ticks(low, high, wanted);
    if (!axis.min && low != 0) low = std::min(low, r.ticks.front());
    if (!axis.max) high = std::max(high, r.ticks.back());
  }
  r.low = low, r.high = high;
  return r;
}

struct Canvas {
  Drawing drawing;
  Vec2 corner, size;  // of the plotting area: top left, extent
  Range x, y;

  Vec2 at(Vec2 p) const { return {corner.x + size.x * x.share(p.x), corner.y + size.y * (1 - y.share(p.y))}; }
};

std::string tick_text(double v) {
  const double a = std::abs(v);
  if (a != 0 && (a >= 1e6 || a < 1e-3)) {
    const int power = static_cast<int>(std::floor(std::log10(a) + 1e-9));
    const double m = v / std::pow(10.0, power);
    std::string digits;
    // Superscripts; the minus sign too.
    constexpr std::string_view kUp[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (const char c : std::to_string(power)) digits.append(c == '-' ? "⁻" : kUp[c - '0']);
    const double rounded = std::round(10 * m) / 10;
    std::string text = rounded == 1 ? std::string() : shortest(rounded).append(" · ");
    return text.append("10").append(digits);
  }
  std::string text = fixed(v, 6);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  // Thousands are parted.
  const std::size_t whole = std::min(text.find('.'), text.size());
  if (a >= 1e3)
    for (std::size_t i = whole; i > 3 + (v < 0 ? 1 : 0); i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

void draw_axes(Canvas& c, const Plot& plot) {
  const Vec2 low = c.corner + Vec2{0, c.size.y}, right = low + Vec2{c.size.x, 0};
  Path grid;
  double wide = 0;
  for (const double t : c.y.ticks) {
    const double y = c.corner.y + c.size.y * (1 - c.y.share(t));
    if (y < c.corner.y - 0.5 || y > low.y + 0.5) continue;
    grid.segment({low.x, y}, {right.x, y});
    const std::string text = tick_text(t);
    wide = std::max(wide, text_width(text, kText));
    write(c.drawing, {text, {low.x - 8, y + 0.36 * kText}, kText, ink::kText, Anchor::end});
  }
  Path marks;
  double last = -1e300;
  for (const double t : c.x.ticks) {
    const double x = c.corner.x + c.size.x * c.x.share(t);
    if (x < low.x - 0.5 || x > right.x + 0.5) continue;
    grid.segment({x, c.corner.y}, {x, low.y});
    marks.segment({x, low.y}, {x, low.y + 4});
    const std::string text = tick_text(t);
    const double half = text_width(text, kText) / 2;
    if (x - half < last + 6) continue;
    last = x + half;
    write(c.drawing, {text, {x, low.y + 8 + 0.8 * kText}, kText, ink::kText, Anchor::middle});
  }
  stroke(c.drawing, std::move(grid), rgb(0xe6e8eb), 0.7);
  stroke(c.drawing, std::move(marks), ink::kText, 0.8);
  stroke(c.drawing, Path{}.segment(low, right), ink::kText, 0.9);
  const auto caption = [](const Axis& axis) {
    return axis.unit.empty()
               ? axis.label
               : std::string(axis.label).append(axis.label.empty() ? "[" : " [").append(axis.unit).append("]");
  };
  write(c.drawing, {caption(plot.x), {c.corner.x + c.size.x / 2, low.y + 40}, kText, ink::kText, Anchor::middle});
  const double x = std::max(low.x - 8 - wide - 14, 0.9 * kText);
  write(c.drawing,
        {caption(plot.y), {x, c.corner.y + c.size.y / 2}, kText, ink::kText, Anchor::middle, false, -kPi / 2});
}

void draw_marker(Drawing& drawing, Marker marker, Vec2 p, Color color) {
  constexpr double r = 3.6;
  const Style style{.fill = color, .stroke = rgb(0xffffff), .width = 1};
  Path path;
  if (marker == Marker::circle) path.circle(p, r);
  if (marker == Marker::square) path.polygon(Box{p, {1, 0}, 0.9 * r, 0.9 * r});
  if (marker == Marker::triangle)
    path.move(p + Vec2{0, -1.2 * r}).line(p + Vec2{1.1 * r, 0.8 * r}).line(p + Vec2{-1.1 * r, 0.8 * r}).close();
  add(drawing, std::move(path), style);
}

void draw_band(Canvas& c, const Plot& plot, const Series& s, Color color) {
  if (s.band.size() != s.points.size()) return;
  Ring upper, lower;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const auto [low, high] = s.band[i];
    if (!usable(s.points[i].x, plot.x) || !usable(low, plot.y) || !usable(high, plot.y)) continue;
    lower.push_back(c.at({s.points[i].x, std::clamp(low, c.y.low, c.y.high)}));
    upper.push_back(c.at({s.points[i].x, std::clamp(high, c.y.low, c.y.high)}));
  }
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  color.alpha = 0.16;
  fill(c.drawing, Path{}.polygon(upper), color);
}

void draw_series(Canvas& c, const Plot& plot, const Series& s, Color color) {
  draw_band(c, plot, s, color);
  Path line;
  std::vector<Vec2> shown;
  bool open = false;
  for (const Vec2 p : s.points) {
    const bool in = usable(p.x, plot.x) && usable(p.y, plot.y) && p.x >= c.x.low && p.x <= c.x.high;
    if (!in) {
      open = false;
      continue;
    }
    const Vec2 q = c.at({p.x, std::clamp(p.y, c.y.low, c.y.high)});
    open ? line.line(q) : line.move(q);
    open = true;
    if (p.y >= c.y.low && p.y <= c.y.high) shown.push_back(q);
  }
  if (s.width > 0)
    add(c.drawing, std::move(line),
        {.stroke = color, .width = s.width, .dash = s.dashed ? 6.0 : 0.0, .gap = 4, .round = !s.dashed});
  if (s.marker != Marker::none)
    for (const Vec2 q : shown) draw_marker(c.drawing, s.marker, q, color);
}

void draw_guide(Canvas& c, const Plot& plot) {
  if (!plot.guide_slope || !plot.x.log || !plot.y.log || plot.series.empty()) return;
  for (const Vec2 p : plot.series[0].points) {
    if (!usable(p.x, plot.x) || !usable(p.y, plot.y)) continue;
    // y = p.y (x / p.x)^slope, as far as it stays in the picture.
    Vec2 end{c.x.high, p.y * std::pow(c.x.high / p.x, *plot.guide_slope)};
    if (end.y > c.y.high) end = {p.x * std::pow(c.y.high / p.y, 1 / *plot.guide_slope), c.y.high};
    if (end.y < c.y.low) end = {p.x * std::pow(c.y.low / p.y, 1 / *plot.guide_slope), c.y.low};
    const Vec2 a = c.at(p), b = c.at(end);
    add(c.drawing, Path{}.segment(a, b), {.stroke = ink::kFaint, .width = 1, .dash = 3, .gap = 3});
    if (!plot.guide_label.empty())
      write(c.drawing, {plot.guide_label, a + 0.98 * (b - a) + Vec2{0, 15}, 0.9 * kText, ink::kFaint, Anchor::end});
    return;
  }
}

void draw_annotations(Canvas& c, const Plot& plot) {
  std::vector<LabelRequest> requests;
  LabelField field;
  field.page.add(c.corner);
  field.page.add(c.corner + c.size);
  // Words keep off the lines that matter.
  for (const Series& s : plot.series) {
    for (std::size_t i = 1; i < s.points.size() && s.width > 1.5 && field.obstacles.size() < 4000; ++i) {
      const Vec2 p = s.points[i - 1], q = s.points[i];
      if (usable(p.x, plot.x) && usable(p.y, plot.y) && usable(q.x, plot.x) && usable(q.y, plot.y))
        field.obstacles.push_back({leader_box(c.at(p), c.at(q))});
    }
  }
  for (const Annotation& a : plot.annotations) {
    if (!usable(a.at.x, plot.x) || !usable(a.at.y, plot.y)) continue;
    const Vec2 p = c.at(a.at);
    fill(c.drawing, Path{}.circle(p, 4.4), rgb(0xffffff));
    fill(c.drawing, Path{}.circle(p, 3.2), a.color.value_or(ink::kText));
    requests.push_back({{p, {1, 0}, 4, 4}, {{text_width(a.text, kText) + 4, 1.25 * kText}}, -1, false});
  }
  const auto spots = place_labels(requests, field);
  std::size_t k = 0;
  for (const Annotation& a : plot.annotations) {
    if (!usable(a.at.x, plot.x) || !usable(a.at.y, plot.y)) continue;
    const LabelSpot& spot = spots[k++];
    if (!spot.placed) continue;
    fill(c.drawing, Path{}.polygon(spot.box), rgb(0xffffff, 0.8));
    write(c.drawing, {a.text, spot.box.center + Vec2{0, 0.36 * kText}, kText * spot.scale, a.color.value_or(ink::kText),
                      Anchor::middle});
  }
}

/// In one row above the plot, or more rows when it does not fit; returns its height.
double draw_legend(Drawing& drawing, const Plot& plot, const std::vector<Color>& colors, Vec2 at, double width,
                   bool draw) {
  double x = 0, y = 0;
  bool any = false;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    if (s.label.empty()) continue;
    any = true;
    const double wide = 30 + text_width(s.label, kText) + 18;
    if (x > 0 && x + wide > width) x = 0, y += 18;
    if (draw) {
      const Vec2 p = at + Vec2{x, y};
      if (s.width > 0)
        add(drawing, Path{}.segment(p, p + Vec2{22, 0}),
            {.stroke = colors[i], .width = s.width, .dash = s.dashed ? 6.0 : 0.0, .gap = 4});
      if (s.marker != Marker::none) draw_marker(drawing, s.marker, p + Vec2{11, 0}, colors[i]);
      write(drawing, {s.label, p + Vec2{30, 0.36 * kText}, kText, ink::kText});
    }
    x += wide;
  }
  return any ? y + 24 : 0;
}

std::pair<Bounds, bool> extent(const Plot& plot) {
  Bounds b;
  bool any = false;
  for (const Series& s : plot.series) {
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const Vec2 p = s.points[i];
      if (!usable(p.x, plot.x) || !usable(p.y, plot.y)) continue;
      b.add(p), any = true;
      if (s.band.size() != s.points.size()) continue;
      for (const double v : {s.band[i].first, s.band[i].second})
        if (usable(v, plot.y)) b.add({p.x, v});
    }
  }
  return {b, any};
}

}  // namespace

std::vector<double> nice_ticks(double low, double high, int wanted) {
  const double raw = (high - low) / std::max(wanted, 1), power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double m : {5.0, 2.0, 1.0})
    if (m * power >= raw * 0.999) step = m * power;
  std::vector<double> ticks;
  const double first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
  for (double k = first; k <= last && ticks.size() < 1000; ++k) ticks.push_back(k * step);
  return ticks;
}

std::vector<double> log_ticks(double low, double high) {
  std::vector<double> ticks;
  const double from = std::floor(std::log10(low) + 1e-9), to = std::ceil(std::log10(high) - 1e-9);
  const bool fine = std::log10(high / low) < 2.2;
  const double stride = std::max(1.0, std::ceil((to - from) / 9));
  for (double e = from; e <= to; e += stride) {
    for (const double m : {1.0, 2.0, 5.0}) {
      const double v = m * std::pow(10.0, e);
      if ((m == 1 || fine) && v >= low * 0.999 && v <= high * 1.001) ticks.push_back(v);
    }
  }
  return ticks;
}

Drawing draw_plot(const Plot& plot) {
  const auto [b, any] = extent(plot);
  Canvas c;
  c.drawing = {plot.size, rgb(0xffffff), plot.title, {}};
  const double width = plot.size.x - 84 - 28;
  std::vector<Color> colors;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    colors.push_back(plot.series[i].color.value_or(kPalette[i % std::size(kPalette)]));
  double top = 20;
  if (!plot.title.empty())
    write(c.drawing, {fitted(plot.title, width, 17, true), {84, top += 16}, 17, ink::kText, Anchor::start, true});
  if (!plot.subtitle.empty())
    write(c.drawing, {fitted(plot.subtitle, width, kText), {84, top += 19}, kText, ink::kFaint});
  top += 16;
  top += draw_legend(c.drawing, plot, colors, {84, top + 6}, width, true);
  c.corner = {84, top};
  c.size = {width, std::max(plot.size.y - top - 60, 40.0)};
  c.x = settle(plot.x, any ? b.min.x : 1, any ? b.max.x : 0, static_cast<int>(width / 90));
  c.y = settle(plot.y, any ? b.min.y : 1, any ? b.max.y : 0, static_cast<int>(c.size.y / 55));
  draw_axes(c, plot);
  draw_guide(c, plot);
  for (std::size_t i = 0; i < plot.series.size(); ++i) draw_series(c, plot, plot.series[i], colors[i]);
  draw_annotations(c, plot);
  return std::move(c.drawing);
}

}  // namespace inhabit::render
