#include <cmath>

#include "crowd/models/pbd_heed.h"

namespace inhabit::crowd::pbd_model::plainly {
namespace {

struct Vec {
  float x = 0, y = 0;
};
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }

/// p(e) of agent i, whose neighbour in row r is `neighbour(r)`.
template <class F>
float pace_along(const HeedWork& work, const HeedConstants& k, std::size_t i, std::uint32_t rows, F&& neighbour,
                 Vec e) {
  float pace = work.speed[i];
  for (std::uint32_t r = 0; r < rows; ++r) {
    const std::size_t j = neighbour(r);
    const Vec d = {work.x[j] - work.x[i], work.y[j] - work.y[i]};
    const float along = dot(d, e), across = (d.y * e.x - d.x * e.y) * k.slimness;
    const float reach = work.radius[i] + work.radius[j] + k.length;
    const float under = reach * reach - across * across;
    const bool behind = !(along + dot(d, {work.ex[j], work.ey[j]}) > 0);
    if (j == i || !(along > 0) || !(under > 0) || behind) continue;
    const float gap = std::max(along - std::sqrt(under), 0.0f);
    const float leader = std::max(dot({work.vx[j], work.vy[j]}, e), 0.0f);
    pace = std::min(pace, gap / k.headway + k.anticipation * leader);
  }
  return pace;
}

}  // namespace

void heed(HeedWork& work, const HeedConstants& k, const NeighbourRows& rows, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, (work.count + kLanes - 1) / kLanes * kLanes);
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t block = (i - begin) / kLanes, lane = i % kLanes;
    const auto neighbour = [&](std::uint32_t r) {
      return static_cast<std::size_t>(rows.items[(rows.first[block] + r) * kLanes + lane]);
    };
    const auto pace_of = [&](Vec e) {
      return pace_along(work, k, i, rows.first[block + 1] - rows.first[block], neighbour, e);
    };
    const Vec straight = {work.ex[i], work.ey[i]};
    Vec e = straight;
    float pace = pace_of(e), best = pace;
    for (std::size_t t = 0; t < k.turns; ++t) {
      const float c = k.turn_cos[t], s = k.turn_sin[t];
      const Vec turned = {c * straight.x - s * straight.y, s * straight.x + c * straight.y};
      const float there = pace_of(turned);
      if (c * there > best) best = c * there, pace = there, e = turned;
    }
    work.wish_x[i] = pace * e.x, work.wish_y[i] = pace * e.y;
  }
}

}  // namespace inhabit::crowd::pbd_model::plainly
