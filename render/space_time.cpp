#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "render/crowd_colors.h"
#include "render/plot.h"

namespace inhabit::render {
namespace {

constexpr double kLeft = 70, kRight = 24, kTop = 66, kBottom = 84, kText = 11.5;

struct Span {
  double low = 0, high = 1;
};

Span widened(double low, double high) {
  if (high - low < 1e-3) return {low - 0.5, high + 0.5};
  return {low, high};
}

void draw_axes(Drawing& drawing, Vec2 corner, Vec2 size, Span time, Span place, char axis) {
  Path grid, frame;
  for (const double t : nice_ticks(time.low, time.high, static_cast<int>(size.x / 90))) {
    const double x = corner.x + size.x * (t - time.low) / (time.high - time.low);
    if (x < corner.x - 0.5 || x > corner.x + size.x + 0.5) continue;
    grid.segment({x, corner.y}, {x, corner.y + size.y});
    write(drawing, {shortest(std::round(1e6 * t) / 1e6),
                    {x, corner.y + size.y + 8 + 0.8 * kText},
                    kText,
                    ink::kText,
                    Anchor::middle});
  }
  for (const double v : nice_ticks(place.low, place.high, static_cast<int>(size.y / 60))) {
    const double y = corner.y + size.y * (place.high - v) / (place.high - place.low);
    if (y < corner.y - 0.5 || y > corner.y + size.y + 0.5) continue;
    grid.segment({corner.x, y}, {corner.x + size.x, y});
    write(drawing,
          {shortest(std::round(1e6 * v) / 1e6), {corner.x - 8, y + 0.36 * kText}, kText, ink::kText, Anchor::end});
  }
  frame.polygon(Ring{corner, corner + Vec2{size.x, 0}, corner + size, corner + Vec2{0, size.y}});
  stroke(drawing, std::move(grid), ink::kHairline, 0.5);
  stroke(drawing, std::move(frame), ink::kText, 0.8);
  write(drawing, {"time [s]", {corner.x + size.x / 2, corner.y + size.y + 40}, kText, ink::kText, Anchor::middle});
  write(drawing, {std::string(1, axis) + " [m]",
                  {corner.x - 50, corner.y + size.y / 2},
                  kText,
                  ink::kText,
                  Anchor::middle,
                  false,
                  -kPi / 2});
}

}  // namespace

Drawing draw_space_time(const Walks& walks, SpaceAxis axis, const CrowdPictureOptions& options) {
  const bool along_x = axis == SpaceAxis::x;
  const Span time = widened(walks.begin, walks.end);
  const Span place = walks.size() == 0 ? Span{}
                     : along_x         ? widened(walks.bounds.min.x, walks.bounds.max.x)
                                       : widened(walks.bounds.min.y, walks.bounds.max.y);
  const Vec2 page{std::max(options.width, 400.0),
                  std::clamp(0.62 * options.width, 300.0, std::max(options.height, 300.0))};
  const Vec2 corner{kLeft, kTop}, size{page.x - kLeft - kRight, page.y - kTop - kBottom};
  Drawing drawing{page, rgb(0xffffff), options.title, {}};
  write(drawing, {fitted(options.title, size.x, 17, true), {kLeft, 30}, 17, ink::kText, Anchor::start, true});
  const std::size_t n = walks.size();
  write(drawing, {std::to_string(n) + (n == 1 ? " person" : " people") + ", position along " + (along_x ? "x" : "y") +
                      " against time",
                  {kLeft, 49},
                  kText,
                  ink::kFaint});
  draw_axes(drawing, corner, size, time, place, along_x ? 'x' : 'y');
  const CrowdScale scale = crowd_scale(walks, options);
  std::vector<Path> paths = colored_tracks(walks, scale, [&](const scene::Fix& fix) {
    const double v = along_x ? fix.x : fix.y;
    return corner + Vec2{size.x * (walks.time(fix) - time.low) / (time.high - time.low),
                         size.y * (place.high - v) / (place.high - place.low)};
  });
  const double many = std::clamp(std::log10(std::max<double>(1, static_cast<double>(n))) / 4, 0.0, 1.0);
  for (int k = 0; k < kCrowdLevels; ++k)
    stroke(drawing, std::move(paths[static_cast<std::size_t>(k)]), crowd_color(scale.color, k), 1.3 - 0.9 * many);
  draw_crowd_legend(drawing, scale, {page.x - kRight, page.y - 28});
  return drawing;
}

}  // namespace inhabit::render
