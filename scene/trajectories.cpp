#include "scene/trajectories.h"

#include <algorithm>
#include <numeric>

namespace inhabit::scene {

Tracks tracks_of(const Trajectories& trajectories) {
  const std::vector<Fix>& fixes = trajectories.fixes;
  Tracks tracks;
  tracks.fixes.resize(fixes.size());
  std::iota(tracks.fixes.begin(), tracks.fixes.end(), 0u);
  std::ranges::stable_sort(tracks.fixes, {}, [&](std::uint32_t i) { return fixes[i].person; });
  for (std::uint32_t k = 0; k < tracks.fixes.size(); ++k) {
    const std::int32_t person = fixes[tracks.fixes[k]].person;
    if (!tracks.people.empty() && tracks.people.back() == person) continue;
    tracks.people.push_back(person);
    tracks.first.push_back(k);
  }
  tracks.first.push_back(static_cast<std::uint32_t>(fixes.size()));
  return tracks;
}

Frames frames_of(const Trajectories& trajectories) {
  Frames frames;
  for (std::uint32_t k = 0; k < trajectories.fixes.size(); ++k) {
    const std::int32_t frame = trajectories.fixes[k].frame;
    if (!frames.frames.empty() && frames.frames.back() == frame) continue;
    frames.frames.push_back(frame);
    frames.first.push_back(k);
  }
  frames.first.push_back(static_cast<std::uint32_t>(trajectories.fixes.size()));
  return frames;
}

}  // namespace inhabit::scene
