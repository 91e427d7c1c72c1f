#include "render/heat_map.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "render/frame.h"
#include "render/plot.h"

namespace inhabit::render {
namespace {

constexpr double kText = 11.5, kLeft = 64, kRight = 96, kTop = 66, kBottom = 56;
constexpr int kLevels = 32;

int level_of(double value, double most) { return std::clamp(static_cast<int>(kLevels * value / most), 0, kLevels - 1); }

/// The cells of each row, those of one colour side by side as one rectangle.
void draw_cells(Drawing& drawing, const HeatMap& map, const Frame& frame, double most) {
  // One path for each colour keeps the file small.
  std::vector<Path> paths(kLevels);
  const double side = frame.scale * map.cell;
  for (int row = 0; row < map.rows; ++row) {
    const auto level = [&](int column) {
      const float v = map.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + column];
      return v == v ? level_of(v, most) : -1;
    };
    for (int column = 0; column < map.columns;) {
      const int now = level(column), begin = column;
      while (column < map.columns && level(column) == now) ++column;
      if (now < 0) continue;
      const Vec2 low = frame.page(map.origin + map.cell * Vec2{static_cast<double>(begin), static_cast<double>(row)});
      // A little larger than it is, so that no seams show.
      const Vec2 a = low - Vec2{0, side + 0.25}, b = low + Vec2{side * (column - begin) + 0.25, 0};
      paths[static_cast<std::size_t>(now)].polygon(Ring{a, {b.x, a.y}, b, {a.x, b.y}});
    }
  }
  for (int k = 0; k < kLevels; ++k)
    if (!paths[k].points.empty()) fill(drawing, std::move(paths[k]), heat_color((k + 0.5) / kLevels));
}

void draw_axes(Drawing& drawing, const Frame& frame, const Bounds& b) {
  const Vec2 low = frame.page(b.min), high = frame.page(b.max);
  const auto text = [](double v) {
    std::string t = fixed(v, 2);
    while (t.back() == '0') t.pop_back();
    if (t.back() == '.') t.pop_back();
    return t == "-0" ? "0" : t;
  };
  Path marks;
  for (const double t : nice_ticks(b.min.x, b.max.x, static_cast<int>((high.x - low.x) / 80) + 1)) {
    const double x = frame.page(Vec2{t, 0}).x;
    if (x < low.x - 0.5 || x > high.x + 0.5) continue;
    marks.segment({x, low.y}, {x, low.y + 4});
    write(drawing, {text(t), {x, low.y + 8 + 0.8 * kText}, kText, ink::kText, Anchor::middle});
  }
  for (const double t : nice_ticks(b.min.y, b.max.y, static_cast<int>((low.y - high.y) / 60) + 1)) {
    const double y = frame.page(Vec2{0, t}).y;
    if (y < high.y - 0.5 || y > low.y + 0.5) continue;
    marks.segment({low.x - 4, y}, {low.x, y});
    write(drawing, {text(t), {low.x - 8, y + 0.36 * kText}, kText, ink::kText, Anchor::end});
  }
  stroke(drawing, std::move(marks), ink::kText, 0.8);
  write(drawing, {"x [m]", {(low.x + high.x) / 2, low.y + 40}, kText, ink::kText, Anchor::middle});
  write(drawing, {"y [m]", {low.x - 46, (low.y + high.y) / 2}, kText, ink::kText, Anchor::middle, false, -kPi / 2});
}

void draw_scale(Drawing& drawing, const HeatMap& map, Vec2 at, double height, double most) {
  constexpr double wide = 16;
  for (int k = 0; k < kLevels; ++k) {
    const double y = at.y + height * (1 - (k + 1.0) / kLevels), h = height / kLevels + 0.25;
    fill(drawing, Path{}.polygon(Ring{{at.x, y}, {at.x + wide, y}, {at.x + wide, y + h}, {at.x, y + h}}),
         heat_color((k + 0.5) / kLevels));
  }
  for (const double t : nice_ticks(0, most, static_cast<int>(height / 50) + 1)) {
    if (t > most * 1.001) continue;
    std::string text = fixed(t, 2);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    write(drawing, {text, {at.x + wide + 6, at.y + height * (1 - t / most) + 0.36 * kText}, kText, ink::kText});
  }
  write(drawing, {map.label + " [" + map.unit + "]",
                  {at.x + wide + 44, at.y + height / 2},
                  kText,
                  ink::kText,
                  Anchor::middle,
                  false,
                  -kPi / 2});
}

}  // namespace

Color heat_color(double share) {
  constexpr std::uint32_t kStops[] = {0xf7f4ec, 0xf6d88a, 0xef9b4a, 0xd3523b, 0x7a1f4b, 0x2b0f3a};
  constexpr int last = static_cast<int>(std::size(kStops)) - 1;
  const double at = std::clamp(share, 0.0, 1.0) * last;
  const int k = std::min(static_cast<int>(at), last - 1);
  const Color a = rgb(kStops[k]), b = rgb(kStops[k + 1]);
  const auto mix = [&](std::uint8_t low, std::uint8_t high) {
    return static_cast<std::uint8_t>(std::lround(low + (at - k) * (high - low)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 1};
}

Drawing draw_heat_map(const HeatMap& map) {
  Bounds b{map.origin, map.origin + map.cell * Vec2{static_cast<double>(map.columns), static_cast<double>(map.rows)}};
  double most = 0;
  for (const float v : map.values)
    if (v == v) most = std::max(most, static_cast<double>(v));
  if (map.most) most = *map.most;
  if (!(most > 0)) most = 1;
  const Vec2 extent{std::max(b.size().x, 1e-3), std::max(b.size().y, 1e-3)};
  const double scale = std::min((map.size - kLeft - kRight) / extent.x, (map.size - kTop - kBottom) / extent.y);
  const Vec2 size{std::max(scale * extent.x, 200.0), std::max(scale * extent.y, 120.0)};
  Drawing drawing{{size.x + kLeft + kRight, size.y + kTop + kBottom}, rgb(0xffffff), map.title, {}};
  const Frame frame{scale, {kLeft - scale * b.min.x, kTop + size.y + scale * b.min.y}};
  const double width = drawing.size.x - kLeft - 20;
  write(drawing, {fitted(map.title, width, 17, true), {kLeft, 30}, 17, ink::kText, Anchor::start, true});
  write(drawing, {fitted(map.subtitle, width, kText), {kLeft, 49}, kText, ink::kFaint});
  draw_cells(drawing, map, frame, most);
  Path walls;
  for (const Area& area : map.ground) {
    walls.polygon(frame.page(area.outline));
    for (const Ring& hole : area.holes) walls.polygon(frame.page(hole));
  }
  stroke(drawing, std::move(walls), ink::kWall, 1.6);
  for (const Ring& ring : map.outlines)
    add(drawing, Path{}.polygon(frame.page(ring)), {.stroke = rgb(0x2f6690), .width = 1.4, .dash = 6, .gap = 4});
  for (const auto& [p, q] : map.lines)
    add(drawing, Path{}.segment(frame.page(p), frame.page(q)), {.stroke = rgb(0x2f6690), .width = 2});
  draw_axes(drawing, frame, b);
  draw_scale(drawing, map, {kLeft + size.x + 18, kTop}, size.y, most);
  return drawing;
}

}  // namespace inhabit::render
