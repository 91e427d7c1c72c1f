#pragma once
#include <cstdint>

#include "geometry/overlay.h"
#include "scene/field.h"

/// Where people were at which time, recorded or simulated.
namespace inhabit::scene {

/// One person at one moment, metres.
struct Fix {
  std::int32_t frame = 0, person = 0;
  double x = 0, y = 0;
  Vec2 at() const { return {x, y}; }
  friend bool operator==(const Fix&, const Fix&) = default;
};

/// Sorted by frame, then person; one fix for each pair of them. Frames may be missing, people come and go.
struct Trajectories {
  std::vector<Fix> fixes;
  double frame_rate = 24;            ///< frames per second; frame f is at the time f / frame_rate
  std::vector<Area> walkable;        ///< where they could walk; empty: unknown
  std::string name;                  ///< title or file
  std::vector<std::string> remarks;  ///< what reading them found odd, for people
};

/// For each person in order of number, the indices of the fixes in order of time.
struct Tracks {
  std::vector<std::int32_t> people;
  std::vector<std::uint32_t> first;  ///< people.size() + 1
  std::vector<std::uint32_t> fixes;
  std::size_t size() const { return people.size(); }
  std::span<const std::uint32_t> operator[](std::size_t k) const {
    return {fixes.data() + first[k], fixes.data() + first[k + 1]};
  }
};
Tracks tracks_of(const Trajectories& trajectories);

/// For each frame that has fixes, the range of them.
struct Frames {
  std::vector<std::int32_t> frames;
  std::vector<std::uint32_t> first;  ///< frames.size() + 1
};
Frames frames_of(const Trajectories& trajectories);

}  // namespace inhabit::scene
