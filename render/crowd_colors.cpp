#include "render/crowd_colors.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "render/plot.h"

namespace inhabit::render {

int CrowdScale::level(double value) const {
  if (!(high > low) || !(value > low)) return 0;
  return std::min(static_cast<int>(kCrowdLevels * std::min((value - low) / (high - low), 1.0)), kCrowdLevels - 1);
}

double value(const Walks& walks, PathColor color, std::size_t k, std::size_t n) {
  if (color == PathColor::time) return walks.time(walks.fix(walks.track(k)[n]));
  return color == PathColor::way ? way_of(walks, k) : speed_at(walks, k, n);
}

CrowdScale crowd_scale(const Walks& walks, const CrowdPictureOptions& options) {
  if (options.color == PathColor::time) return {PathColor::time, walks.begin, walks.end};
  if (options.color == PathColor::way) return {PathColor::way, -180, 180};
  return {PathColor::speed, 0, options.fastest};
}

Color crowd_color(PathColor color, int level) {
  constexpr std::uint32_t kSpeed[] = {0xb01030, 0xe0632f, 0xe2b030, 0x3fa67a, 0x2379a8, 0x2b3f8f};
  constexpr std::uint32_t kTime[] = {0x2c0f58, 0x6b1d81, 0xb13679, 0xe8605c, 0xf5a24a, 0xe5cf3f};
  // A ring: west at both ends, east (the middle) between the third and the fourth.
  constexpr std::uint32_t kWay[] = {0x2379a8, 0x7b4fa3, 0xd8452f, 0xe8963a, 0x55a24b, 0x2379a8};
  const std::uint32_t* stops = color == PathColor::speed ? kSpeed : color == PathColor::time ? kTime : kWay;
  const double at = 5.0 * std::clamp(level, 0, kCrowdLevels - 1) / (kCrowdLevels - 1);
  const int k = std::min(static_cast<int>(at), 4);
  const Color a = rgb(stops[k]), b = rgb(stops[k + 1]);
  const auto mix = [&](std::uint8_t low, std::uint8_t high) {
    return static_cast<std::uint8_t>(std::lround(low + (at - k) * (high - low)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 1};
}

void draw_crowd_legend(Drawing& drawing, const CrowdScale& scale, Vec2 at) {
  constexpr double kWide = 168, kHigh = 8, kText = 9.5;
  const double left = at.x - kWide, step = kWide / kCrowdLevels;
  for (int k = 0; k < kCrowdLevels; ++k) {
    const double x = left + k * step, end = k + 1 == kCrowdLevels ? at.x : x + step + 0.3;  // no seams
    fill(drawing, Path{}.polygon(Ring{{x, at.y}, {end, at.y}, {end, at.y + kHigh}, {x, at.y + kHigh}}),
         crowd_color(scale.color, k));
  }
  const bool speed = scale.color == PathColor::speed;
  const bool way = scale.color == PathColor::way;
  write(drawing, {speed ? "speed [m/s]"
                  : way ? "way [°]"
                        : "time [s]",
                  {left - 10, at.y + kHigh},
                  kText,
                  ink::kText,
                  Anchor::end});
  if (!(scale.high > scale.low)) return;
  const std::vector<double> ticks =
      way ? std::vector<double>{-180, -90, 0, 90, 180} : nice_ticks(scale.low, scale.high, 4);
  for (const double t : ticks) {
    const double share = (t - scale.low) / (scale.high - scale.low);
    if (share < -1e-9 || share > 1 + 1e-9) continue;
    const bool most = speed && share > 1 - 1e-9;
    write(drawing, {(most ? "≥ " : "") + shortest(std::round(1e6 * t) / 1e6),
                    {left + share * kWide, at.y + kHigh + 1.25 * kText},
                    kText,
                    ink::kText,
                    Anchor::middle});
  }
}

}  // namespace inhabit::render
