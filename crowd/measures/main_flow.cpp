#include "crowd/measures/main_flow.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace inhabit::crowd {
namespace {

/// The fix after half of the way.
Vec2 half_way(const Recording& recording, std::span<const std::uint32_t> track) {
  double whole = 0;
  for (std::size_t k = 1; k < track.size(); ++k)
    whole += length(recording.fix(track[k]).at() - recording.fix(track[k - 1]).at());
  double walked = 0;
  for (std::size_t k = 1; k < track.size(); ++k) {
    walked += length(recording.fix(track[k]).at() - recording.fix(track[k - 1]).at());
    if (walked >= whole / 2) return recording.fix(track[k]).at();
  }
  return recording.fix(track.front()).at();
}

/// How far one can go from p along the unit vector d before a wall comes, metres; nothing without walls on that way.
std::optional<double> way_to_wall(const std::vector<Area>& walkable, Vec2 p, Vec2 d) {
  std::optional<double> nearest;
  const auto try_ring = [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], e = ring[(k + 1) % ring.size()] - a;
      const double det = cross(d, e);
      if (det == 0) continue;
      const double t = cross(a - p, e) / det, s = cross(a - p, d) / det;
      if (t > 0 && s >= 0 && s <= 1 && (!nearest || t < *nearest)) nearest = t;
    }
  };
  for (const Area& area : walkable) {
    try_ring(area.outline);
    for (const Ring& hole : area.holes) try_ring(hole);
  }
  return nearest;
}

}  // namespace

MainFlow main_flow(const Recording& recording, std::span<const Vec2> velocities) {
  MainFlow flow;
  std::vector<double> xs, ys;
  for (std::size_t t = 0; t < recording.tracks.size(); ++t) {
    const Vec2 p = half_way(recording, recording.tracks[t]);
    xs.push_back(p.x), ys.push_back(p.y);
  }
  const Vec2 middle{median(xs), median(ys)};
  double nearest = 1e300;
  for (std::size_t i = 0; i < recording.fix_count(); ++i) {
    const Vec2 d = recording.fix(i).at() - middle;
    if (dot(d, d) < nearest) nearest = dot(d, d), flow.center = recording.fix(i).at();
  }
  double xx = 0, xy = 0, yy = 0;
  std::vector<Vec2> near;
  for (std::size_t i = 0; i < recording.fix_count(); ++i) {
    const Vec2 v = velocities[i];
    if (length(recording.fix(i).at() - flow.center) > 1 || !known(v)) continue;
    near.push_back(v);
    xx += v.x * v.x, xy += v.x * v.y, yy += v.y * v.y;
  }
  if (xx + yy == 0) return flow;
  flow.axis = direction(0.5 * std::atan2(2 * xy, xx - yy));
  const auto forward = std::ranges::count_if(near, [&](Vec2 v) { return dot(v, flow.axis) >= 0; });
  flow.two_way = 1 - static_cast<double>(forward) / static_cast<double>(near.size());
  if (flow.two_way > 0.5) flow.axis = -flow.axis, flow.two_way = 1 - flow.two_way;
  return flow;
}

MeasureLine cross_line(const Recording& recording, const MainFlow& flow) {
  const Vec2 left = perp(flow.axis);
  double low = 0, high = 0;
  for (const scene::Fix& fix : recording.trajectories.fixes) {
    const Vec2 d = fix.at() - flow.center;
    if (std::abs(dot(d, flow.axis)) > 0.5) continue;
    low = std::min(low, dot(d, left)), high = std::max(high, dot(d, left));
  }
  low -= 0.2, high += 0.2;
  const auto to_left = way_to_wall(recording.trajectories.walkable, flow.center, left);
  const auto to_right = way_to_wall(recording.trajectories.walkable, flow.center, -left);
  if (to_left) high = *to_left;
  if (to_right) low = -*to_right;
  // From left to right: forward() of a line is to its left.
  return {flow.center + high * left, flow.center + low * left};
}

Ring box_around(const MeasureLine& line, double depth) {
  const Vec2 h = (depth / 2) * line.forward();
  return {line.a - h, line.b - h, line.b + h, line.a + h};
}

}  // namespace inhabit::crowd
