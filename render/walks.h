#pragma once
#include "geometry/polygon.h"
#include "scene/trajectories.h"

namespace inhabit::render {
using namespace geometry;

/// Trajectories by person: where everybody was at any moment, between frames too.
struct Walks {
  const scene::Trajectories* trajectories = nullptr;
  scene::Tracks tracks;
  Bounds bounds;              ///< of all positions
  double begin = 0, end = 0;  ///< time of the first and of the last frame, seconds
  double gap = 1;             ///< who is missing longer is gone meanwhile, seconds

  std::size_t size() const { return tracks.size(); }
  double time(const scene::Fix& fix) const { return fix.frame / trajectories->frame_rate; }
  std::span<const std::uint32_t> track(std::size_t k) const { return tracks[k]; }
  const scene::Fix& fix(std::uint32_t index) const { return trajectories->fixes[index]; }
};
/// Requires: the trajectories outlive the result.
Walks walks_of(const scene::Trajectories& trajectories);

/// The moment with most people; of several, the one in their middle. Seconds.
double fullest_moment(const scene::Trajectories& trajectories);

struct Walker {
  std::size_t person = 0;  ///< row of Walks::tracks
  Vec2 at;
  double speed = 0;  ///< m/s over the second round the moment, as far as the person is there
};
/// Everybody who is there at a moment, in order of person; positions between two fixes lie on the line between them.
std::vector<Walker> walkers_at(const Walks& walks, double time);

/// Where person `k` is at a time; nothing before, after, and in gaps.
std::optional<Vec2> position_at(const Walks& walks, std::size_t k, double time);
/// Speed of the n-th fix of person `k`, m/s, from fixes up to half a second away.
double speed_at(const Walks& walks, std::size_t k, std::size_t n);
/// Direction from the first to the last position of person `k`, degrees in (-180, 180]; 0 for who ends where he began.
double way_of(const Walks& walks, std::size_t k);

}  // namespace inhabit::render
