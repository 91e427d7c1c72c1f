#pragma once
#include "render/crowd_picture.h"

/// Colours of people and of their paths, in levels: one shape for each keeps files small.
namespace inhabit::render {

constexpr int kCrowdLevels = 24;

struct CrowdScale {
  PathColor color = PathColor::speed;
  double low = 0, high = 2;
  int level(double value) const;
};
/// What a scale colours: of the n-th fix of person `k`.
double value(const Walks& walks, PathColor color, std::size_t k, std::size_t n);
CrowdScale crowd_scale(const Walks& walks, const CrowdPictureOptions& options);
/// Speed: red stands, blue is fast. Time: dark to light. Way: round the compass, east orange, west blue.
Color crowd_color(PathColor color, int level);
/// A bar of the colours with its numbers, `at` its upper right corner.
void draw_crowd_legend(Drawing& drawing, const CrowdScale& scale, Vec2 at);

/// Every track as lines in the colours of a scale, one shape for each colour, through `place`(fix): a point of the
/// page.
template <class Place>
std::vector<Path> colored_tracks(const Walks& walks, const CrowdScale& scale, const Place& place) {
  constexpr double kNear = 0.4;  // points: less is not seen
  std::vector<Path> paths(kCrowdLevels);
  for (std::size_t k = 0; k < walks.size(); ++k) {
    const auto track = walks.track(k);
    int level = -1;  // of the line that goes on
    Vec2 last;
    for (std::size_t n = 0; n < track.size(); ++n) {
      const scene::Fix& fix = walks.fix(track[n]);
      const Vec2 p = place(fix);
      const bool gap = n > 0 && walks.time(fix) - walks.time(walks.fix(track[n - 1])) > walks.gap;
      if (n == 0 || gap) {
        level = -1, last = p;
        continue;
      }
      if (length(p - last) < kNear && n + 1 < track.size()) continue;
      const int now = scale.level(value(walks, scale.color, k, n));
      if (now != level) paths[static_cast<std::size_t>(now)].move(last);
      paths[static_cast<std::size_t>(now)].line(p);
      level = now, last = p;
    }
  }
  return paths;
}

}  // namespace inhabit::render
