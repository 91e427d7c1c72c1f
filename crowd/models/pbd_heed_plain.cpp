#include <cmath>

#include "crowd/models/pbd_heed.h"

namespace inhabit::crowd::pbd_model::plainly {
namespace {

struct Vec {
  float x = 0, y = 0;
};
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }

/// p(e) and q(e) of agent i, whose neighbour in row r is `neighbour(r)`.
struct Paces {
  float allowed = 0, clear = 0;
};
template <class F>
Paces paces_along(const HeedWork& work, const HeedConstants& k, std::size_t i, std::uint32_t rows, F&& neighbour,
                  Vec e) {
  float allowed = work.speed[i], clear = allowed;
  for (std::uint32_t r = 0; r < rows; ++r) {
    const std::size_t j = neighbour(r);
    const Vec d = {work.x[j] - work.x[i], work.y[j] - work.y[i]}, other = {work.ex[j], work.ey[j]};
    const float along = dot(d, e), across = (d.y * e.x - d.x * e.y) * k.slimness;
    const float reach = work.radius[i] + work.radius[j] + k.length;
    const float under = reach * reach - across * across;
    if (j == i || !(along > 0) || !(under > 0)) continue;
    const float closing = std::max(along - std::sqrt(under), 0.0f) / k.headway;
    if (along + dot(d, other) > 0) allowed = std::min(allowed, closing + k.anticipation * work.pace[j]);
    if (dot({work.ex[i], work.ey[i]}, other) < 0) clear = std::min(clear, std::max(closing, kPress * work.speed[i]));
  }
  return {allowed, std::min(allowed, clear)};
}

}  // namespace

void heed(HeedWork& work, const HeedConstants& k, const NeighbourRows& rows, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, (work.count + kLanes - 1) / kLanes * kLanes);
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t block = (i - begin) / kLanes, lane = i % kLanes;
    const auto neighbour = [&](std::uint32_t r) {
      return static_cast<std::size_t>(rows.items[(rows.first[block] + r) * kLanes + lane]);
    };
    const auto paces = [&](Vec e) {
      return paces_along(work, k, i, rows.first[block + 1] - rows.first[block], neighbour, e);
    };
    const Vec straight = {work.ex[i], work.ey[i]};
    Vec e = straight;
    const Paces ahead = paces(e);
    float pace = ahead.allowed, best = ahead.clear;
    for (std::size_t t = 0; t < k.turns; ++t) {
      const float c = k.turn_cos[t], s = k.turn_sin[t];
      const Vec turned = {c * straight.x - s * straight.y, s * straight.x + c * straight.y};
      const Paces there = paces(turned);
      const float room = s > 0 ? work.left[i] : work.right[i];
      const float barred = std::max(room / (k.headway * std::abs(s)), kPress * work.speed[i]);
      const float gain = c * (room < kRoom ? std::min(there.clear, barred) : there.clear);
      if (gain > best) best = gain, pace = there.allowed, e = turned;
    }
    work.wish_x[i] = pace * e.x, work.wish_y[i] = pace * e.y;
  }
}

}  // namespace inhabit::crowd::pbd_model::plainly
