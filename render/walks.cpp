#include "render/walks.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace inhabit::render {
namespace {

constexpr double kHalf = 0.5;  // seconds either side that a speed is taken over

/// Number of the first fix of the track that is not before `time`.
std::size_t first_from(const Walks& walks, std::span<const std::uint32_t> track, double time) {
  const auto at = std::ranges::lower_bound(track, time, {}, [&](std::uint32_t i) { return walks.time(walks.fix(i)); });
  return static_cast<std::size_t>(at - track.begin());
}

/// From the n-th fix as far as `span` seconds away without a gap; `step` is 1 or -1.
std::size_t reach(const Walks& walks, std::span<const std::uint32_t> track, std::size_t n, int step) {
  const double from = walks.time(walks.fix(track[n]));
  while (true) {
    if (step < 0 ? n == 0 : n + 1 == track.size()) return n;
    const std::size_t next = step < 0 ? n - 1 : n + 1;
    const double t = walks.time(walks.fix(track[next]));
    const bool near = std::abs(t - from) <= kHalf + 1e-9 || std::abs(t - from) <= walks.gap / 2;
    if (!near || std::abs(t - walks.time(walks.fix(track[n]))) > walks.gap) return n;
    n = next;
  }
}

}  // namespace

Walks walks_of(const scene::Trajectories& trajectories) {
  Walks walks;
  walks.trajectories = &trajectories;
  walks.tracks = scene::tracks_of(trajectories);
  const std::vector<scene::Fix>& fixes = trajectories.fixes;
  if (fixes.empty()) return walks;
  for (const scene::Fix& fix : fixes) walks.bounds.add(fix.at());
  walks.begin = walks.time(fixes.front());
  walks.end = walks.time(fixes.back());
  // Files with a fix every few seconds have steps longer than a second, which are no gaps.
  std::int64_t least = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const std::int64_t step = std::int64_t{fixes[i].frame} - fixes[i - 1].frame;
    if (step > 0 && (least == 0 || step < least)) least = step;
  }
  walks.gap = std::max(1.0, 2.0 * static_cast<double>(least) / trajectories.frame_rate) + 1e-9;
  return walks;
}

double fullest_moment(const scene::Trajectories& trajectories) {
  const scene::Frames frames = scene::frames_of(trajectories);
  std::uint32_t most = 0;
  std::vector<std::size_t> where;
  for (std::size_t f = 0; f < frames.frames.size(); ++f) {
    const std::uint32_t count = frames.first[f + 1] - frames.first[f];
    if (count < most) continue;
    if (count > most) where.clear();
    most = count;
    where.push_back(f);
  }
  return where.empty() ? 0 : frames.frames[where[where.size() / 2]] / trajectories.frame_rate;
}

std::optional<Vec2> position_at(const Walks& walks, std::size_t k, double time) {
  const auto track = walks.track(k);
  const std::size_t n = first_from(walks, track, time - 1e-9);
  if (n == track.size()) return std::nullopt;
  const scene::Fix& after = walks.fix(track[n]);
  const double t1 = walks.time(after);
  if (t1 <= time + 1e-9) return after.at();
  if (n == 0) return std::nullopt;
  const scene::Fix& before = walks.fix(track[n - 1]);
  const double t0 = walks.time(before);
  if (t1 - t0 > walks.gap) return std::nullopt;
  return before.at() + (time - t0) / (t1 - t0) * (after.at() - before.at());
}

double speed_at(const Walks& walks, std::size_t k, std::size_t n) {
  const auto track = walks.track(k);
  const scene::Fix& a = walks.fix(track[reach(walks, track, n, -1)]);
  const scene::Fix& b = walks.fix(track[reach(walks, track, n, 1)]);
  return a.frame == b.frame ? 0 : length(b.at() - a.at()) / (walks.time(b) - walks.time(a));
}

std::vector<Walker> walkers_at(const Walks& walks, double time) {
  std::vector<Walker> out;
  for (std::size_t k = 0; k < walks.size(); ++k) {
    const std::optional<Vec2> at = position_at(walks, k, time);
    if (!at) continue;
    const std::size_t n = std::min(first_from(walks, walks.track(k), time - 1e-9), walks.track(k).size() - 1);
    out.push_back({k, *at, speed_at(walks, k, n)});
  }
  return out;
}

double way_of(const Walks& walks, std::size_t k) {
  const auto track = walks.track(k);
  const Vec2 way = walks.fix(track.back()).at() - walks.fix(track.front()).at();
  return degrees(std::atan2(way.y, way.x));
}

}  // namespace inhabit::render
