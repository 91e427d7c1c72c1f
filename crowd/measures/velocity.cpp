#include "crowd/measures/velocity.h"

#include <algorithm>
#include <cmath>

namespace inhabit::crowd {
namespace {

struct Window {
  std::size_t from = 0, to = 0;
};

/// The outermost fixes of a track that are at most `reach` frames from that of `k`.
Window within(const Recording& r, std::span<const std::uint32_t> track, std::size_t k, std::int32_t reach) {
  const std::int32_t frame = r.fix(track[k]).frame;
  Window w{k, k};
  while (w.from > 0 && frame - r.fix(track[w.from - 1]).frame <= reach) --w.from;
  while (w.to + 1 < track.size() && r.fix(track[w.to + 1]).frame - frame <= reach) ++w.to;
  return w;
}

Vec2 velocity(const Recording& r, std::span<const std::uint32_t> track, std::size_t k, std::int32_t n,
              SpeedWindow::Ends ends) {
  const std::int32_t frame = r.fix(track[k]).frame;
  Window w = within(r, track, k, n);
  const std::int32_t before = frame - r.fix(track[w.from]).frame, after = r.fix(track[w.to]).frame - frame;
  if (ends == SpeedWindow::Ends::exclude && (before < n || after < n)) return {kUnknown, kUnknown};
  if (ends == SpeedWindow::Ends::shrink && before != after) w = within(r, track, k, std::min(before, after));
  if (w.from == w.to) return {kUnknown, kUnknown};
  const scene::Fix& a = r.fix(track[w.from]);
  const scene::Fix& b = r.fix(track[w.to]);
  return (r.trajectories.frame_rate / (b.frame - a.frame)) * (b.at() - a.at());
}

}  // namespace

int window_frames(const SpeedWindow& window, double frame_rate) {
  if (window.frames > 0) return window.frames;
  return std::max(1, static_cast<int>(std::lround(std::min(frame_rate, 1e6) * 5 / 16)));
}

std::vector<Vec2> velocities(const Recording& recording, const SpeedWindow& window, int threads) {
  const std::int32_t n = window_frames(window, recording.trajectories.frame_rate);
  std::vector<Vec2> result(recording.fix_count());
  parallel_for(recording.tracks.size(), threads, [&](std::size_t t) {
    const std::span<const std::uint32_t> track = recording.tracks[t];
    for (std::size_t k = 0; k < track.size(); ++k) result[track[k]] = velocity(recording, track, k, n, window.ends);
  });
  return result;
}

std::vector<double> speeds(std::span<const Vec2> velocities, std::optional<Vec2> direction) {
  std::vector<double> result;
  result.reserve(velocities.size());
  for (const Vec2 v : velocities) result.push_back(direction ? dot(v, *direction) : length(v));
  return result;
}

}  // namespace inhabit::crowd
