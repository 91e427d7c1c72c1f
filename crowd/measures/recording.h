#pragma once
#include <limits>

#include "core/core.h"
#include "core/parallel.h"
#include "scene/trajectories.h"

/// What can be said about people's ways, be they recorded or simulated. One measure = one header here: its definition,
/// units and source above it, its hand-computable cases beside it. Frames count from the recording's own zero;
/// `seconds` is frame / frame rate.
namespace inhabit::crowd {
using namespace core;
using namespace geometry;

/// "Not known": a speed at the end of a track, a mean over nobody.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline bool known(double value) { return value == value; }
inline bool known(Vec2 value) { return known(value.x); }

/// Trajectories by person and by frame. The trajectories must outlive it.
struct Recording {
  explicit Recording(const scene::Trajectories& t)
      : trajectories(t), tracks(scene::tracks_of(t)), frames(scene::frames_of(t)) {}

  const scene::Trajectories& trajectories;
  scene::Tracks tracks;
  scene::Frames frames;

  const scene::Fix& fix(std::size_t i) const { return trajectories.fixes[i]; }
  std::size_t fix_count() const { return trajectories.fixes.size(); }
  double seconds(std::int32_t frame) const { return frame / trajectories.frame_rate; }

  // Frames that have people, numbered 0 … frame_count() - 1.
  std::size_t frame_count() const { return frames.frames.size(); }
  std::size_t first(std::size_t k) const { return frames.first[k]; }
  std::size_t count(std::size_t k) const { return frames.first[k + 1] - frames.first[k]; }
  std::vector<Vec2> places(std::size_t k) const {
    std::vector<Vec2> places;
    places.reserve(count(k));
    for (std::size_t i = first(k); i < first(k) + count(k); ++i) places.push_back(fix(i).at());
    return places;
  }
};

/// Calls body(k) for every frame k, many frames per task.
template <class F>
void for_each_frame(const Recording& recording, int threads, F&& body) {
  constexpr std::size_t kBlock = 64;
  const std::size_t count = recording.frame_count();
  parallel_for((count + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    for (std::size_t k = block * kBlock; k < std::min((block + 1) * kBlock, count); ++k) body(k);
  });
}

}  // namespace inhabit::crowd
