#include "crowd/measures/crossings.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

namespace inhabit::crowd {

std::vector<Crossing> crossings(const Recording& recording, const MeasureLine& line, double longest_gap) {
  std::vector<Crossing> found;
  const Vec2 d = line.b - line.a;
  const double dd = dot(d, d), rate = recording.trajectories.frame_rate;
  if (!(dd > 0)) return found;
  for (std::size_t t = 0; t < recording.tracks.size(); ++t) {
    const std::span<const std::uint32_t> track = recording.tracks[t];
    for (std::size_t k = 1; k < track.size(); ++k) {
      const scene::Fix& p = recording.fix(track[k - 1]);
      const scene::Fix& q = recording.fix(track[k]);
      const double before = cross(d, p.at() - line.a), after = cross(d, q.at() - line.a);
      if ((before >= 0) == (after >= 0)) continue;
      const double dt = (q.frame - p.frame) / rate;
      if (dt > longest_gap) continue;
      const double share = before / (before - after);
      const Vec2 at = p.at() + share * (q.at() - p.at());
      const double along = dot(at - line.a, d);
      if (along < 0 || along > dd) continue;
      found.push_back({recording.seconds(p.frame) + share * dt, p.person, after >= 0 ? 1 : -1, at,
                       std::abs(after - before) / (std::sqrt(dd) * dt)});
    }
  }
  std::ranges::sort(found, {}, [](const Crossing& c) { return std::tuple(c.seconds, c.person); });
  return found;
}

Flow flow(std::span<const Crossing> crossings, double width) {
  Flow flow;
  std::unordered_set<std::int32_t> seen_unsorted;
  double sum = 0;
  for (const Crossing& c : crossings) {
    if (!seen_unsorted.insert(c.person).second) continue;
    (c.direction > 0 ? flow.forward : flow.backward) += 1;
    if (!flow.times.empty()) flow.headways.push_back(c.seconds - flow.times.back());
    flow.times.push_back(c.seconds);
    sum += c.speed;
  }
  if (flow.times.empty()) return flow;
  const auto n = static_cast<double>(flow.times.size());
  flow.from = flow.times.front(), flow.until = flow.times.back();
  flow.speed = sum / n;
  if (flow.until > flow.from) {
    flow.flow = (n - 1) / (flow.until - flow.from);
    if (width > 0) flow.specific = flow.flow / width;
  }
  return flow;
}

std::optional<std::pair<double, double>> steady_span(const Flow& flow) {
  const std::size_t n = flow.times.size();
  if (n < 20) return std::nullopt;
  return std::pair(flow.times[n / 5], flow.times[n * 4 / 5]);
}

std::vector<Vec2> flow_over_time(const Flow& flow, double step) {
  std::vector<Vec2> rows;
  if (flow.times.empty() || !(step > 0)) return rows;
  std::size_t k = 0;
  for (int i = 0; k < flow.times.size(); ++i) {
    const double end = flow.from + (i + 1) * step;
    int people = 0;
    for (; k < flow.times.size() && flow.times[k] < end; ++k) ++people;
    rows.push_back({end - step / 2, people / step});
  }
  return rows;
}

}  // namespace inhabit::crowd
