#pragma once
#include <algorithm>
#include <functional>

#include "scene/trajectories.h"

/// For tests only: small recordings written down by hand.
namespace inhabit::crowd {

/// Person p is at way(p, seconds) in the frames 0 … frames - 1, or absent where the way says so by NaN.
inline scene::Trajectories walkers(int people, int frames, double rate,
                                   const std::function<geometry::Vec2(int, double)>& way) {
  scene::Trajectories t;
  t.frame_rate = rate;
  for (int frame = 0; frame < frames; ++frame) {
    for (int p = 0; p < people; ++p) {
      const geometry::Vec2 at = way(p, frame / rate);
      if (at.x == at.x) t.fixes.push_back({frame, p, at.x, at.y});
    }
  }
  return t;
}

inline geometry::Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace inhabit::crowd
