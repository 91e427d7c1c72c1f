#include "render/priors_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"
#include "render/frame.h"
#include "render/plot.h"

namespace inhabit::render {
namespace {

constexpr double kSmall = 9.5;
constexpr int kBins = 24;

/// On the page, y down: an angle counted counter-clockwise from up.
Vec2 spoke(double angle) {
  const Vec2 d = direction(wrap_angle(angle));
  return {-d.y, -d.x};
}

Color lighter(Color c, double alpha) {
  c.alpha = alpha;
  return c;
}

}  // namespace

Color mode_color(int mode) {
  constexpr std::array kColors = {rgb(0x2f6690), rgb(0xc4663a), rgb(0x4d8b5a), rgb(0x8a5a8f),
                                  rgb(0xb9962e), rgb(0x5f6b78), rgb(0xa94a5b), rgb(0x3f9a9a)};
  return kColors[static_cast<std::size_t>(std::max(mode, 0)) % kColors.size()];
}

void draw_histogram(Drawing& drawing, Vec2 corner, Vec2 size, const std::vector<Tally>& values,
                    const std::vector<Bell>& modes, std::string_view label) {
  double low = 0, high = 0.2;
  for (const Tally& t : values) low = std::min(low, t.value), high = std::max(high, t.value);
  high += 0.05 * (high - low);
  const std::vector<double> ticks = nice_ticks(low, high, 5);
  low = std::min(low, ticks.front()), high = std::max(high, ticks.back());
  const auto x = [&](double v) { return corner.x + size.x * (v - low) / (high - low); };
  constexpr std::size_t kBars = 30;
  std::vector<std::vector<int>> bars(kBars);
  std::size_t most = 1;
  for (const Tally& t : values) {
    auto& bar = bars[std::min(kBars - 1, static_cast<std::size_t>((t.value - low) / (high - low) * kBars))];
    bar.push_back(t.mode);
    most = std::max(most, bar.size());
  }
  const double floor = corner.y + size.y, top = corner.y + 16, step = (floor - top) / static_cast<double>(most);
  const double wide = size.x / kBars;
  for (std::size_t b = 0; b < kBars; ++b) {
    std::ranges::sort(bars[b]);
    for (std::size_t i = 0; i < bars[b].size(); ++i) {
      const double left = corner.x + wide * static_cast<double>(b), y = floor - step * static_cast<double>(i + 1);
      const std::array box = {Vec2{left + 0.6, y}, Vec2{left + wide - 0.6, y}, Vec2{left + wide - 0.6, y + step},
                              Vec2{left + 0.6, y + step}};
      fill(drawing, Path{}.polygon(box), lighter(mode_color(bars[b][i]), 0.75));
    }
  }
  stroke(drawing, Path{}.segment({corner.x, floor}, {corner.x + size.x, floor}), ink::kText, 0.9);
  for (const double t : ticks) {
    stroke(drawing, Path{}.segment({x(t), floor}, {x(t), floor + 3}), ink::kText, 0.8);
    write(drawing, {shortest(std::round(t * 1e6) / 1e6), {x(t), floor + 13}, kSmall, ink::kText, Anchor::middle});
  }
  write(drawing, {std::string(label), {corner.x + size.x / 2, floor + 28}, kSmall, ink::kFaint, Anchor::middle});
  write(drawing, {std::to_string(most), {corner.x - 4, top + 4}, kSmall, ink::kFaint, Anchor::end});
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Color color = mode_color(static_cast<int>(m));
    const double y = corner.y + 5, from = x(std::max(low, modes[m].mean - modes[m].deviation)),
                 to = x(std::min(high, modes[m].mean + modes[m].deviation));
    add(drawing, Path{}.segment({x(modes[m].mean), y}, {x(modes[m].mean), floor}),
        {.stroke = color, .width = 1, .dash = 3, .gap = 2});
    stroke(drawing, Path{}.segment({from, y}, {to, y}), color, 3);
    fill(drawing, Path{}.circle({x(modes[m].mean), y}, 3.4), color);
  }
}

void draw_rose(Drawing& drawing, Vec2 center, double radius, const std::vector<Tally>& angles,
               const std::vector<Bell>& modes) {
  std::vector<std::vector<int>> bins(kBins);
  std::size_t most = 1;
  for (const Tally& t : angles) {
    const double turn = wrap_angle(t.value) / (2 * kPi) * kBins + 0.5;
    auto& bin = bins[static_cast<std::size_t>(static_cast<int>(std::floor(turn)) + kBins) % kBins];
    bin.push_back(t.mode);
    most = std::max(most, bin.size());
  }
  for (const double share : {0.5, 1.0}) stroke(drawing, Path{}.circle(center, share * radius), ink::kHairline, 0.7);
  Path cross;
  for (int k = 0; k < 4; ++k) cross.segment(center, center + radius * spoke(k * kPi / 2));
  stroke(drawing, cross, ink::kHairline, 0.7);
  for (int b = 0; b < kBins; ++b) {
    auto& bin = bins[static_cast<std::size_t>(b)];
    std::ranges::sort(bin);
    double inner = 0;
    for (std::size_t i = 0; i < bin.size(); ++i) {
      const double outer = 0.86 * radius * std::sqrt(static_cast<double>(i + 1) / static_cast<double>(most));
      // Neighbours of one mode are drawn as one piece.
      if (i + 1 < bin.size() && bin[i + 1] == bin[i]) continue;
      const double from = (b - 0.46) * 2 * kPi / kBins, to = (b + 0.46) * 2 * kPi / kBins;
      Path wedge;
      wedge.arc(center, outer * spoke(0), outer * spoke(kPi / 2), from, to);
      wedge.arc(center, inner * spoke(0), inner * spoke(kPi / 2), to, from);
      fill(drawing, wedge.close(), lighter(mode_color(bin[i]), 0.75));
      inner = outer;
    }
  }
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Color color = mode_color(static_cast<int>(m));
    const double around = std::min(modes[m].deviation, kPi);
    // Beyond a right angle of deviation there is no direction to speak of.
    Path arc;
    const double r = radius * (0.94 + 0.05 * static_cast<double>(m % 3));
    arc.arc(center, r * spoke(0), r * spoke(kPi / 2), modes[m].mean - around, modes[m].mean + around);
    stroke(drawing, arc, color, 2.4);
    if (around > kPi / 2) continue;
    const Vec2 way = spoke(modes[m].mean), tip = center + r * way;
    stroke(drawing, Path{}.segment(center, tip), color, 1.6);
    fill(drawing, Path{}.move(tip).line(tip - 8 * way + 3.6 * perp(way)).line(tip - 8 * way - 3.6 * perp(way)).close(),
         color);
  }
}

}  // namespace inhabit::render
