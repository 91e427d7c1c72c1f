#include "crowd/measures/path_length.h"

#include <cmath>

namespace inhabit::crowd {

double least_effort_per_metre() { return 2 * std::sqrt(kStandingEffort * kWalkingEffort); }

double PathRow::effort_ratio() const {
  return shortest > 0 ? effort / (least_effort_per_metre() * shortest) : kUnknown;
}

std::vector<PathRow> path_lengths(const Recording& recording, const std::function<double(Vec2 a, Vec2 b)>& shortest) {
  std::vector<PathRow> rows;
  for (std::size_t t = 0; t < recording.tracks.size(); ++t) {
    const std::span<const std::uint32_t> track = recording.tracks[t];
    if (track.size() < 2) continue;
    PathRow row{recording.tracks.people[t]};
    for (std::size_t k = 1; k < track.size(); ++k) {
      const scene::Fix& p = recording.fix(track[k - 1]);
      const scene::Fix& q = recording.fix(track[k]);
      const double dt = (q.frame - p.frame) / recording.trajectories.frame_rate, way = length(q.at() - p.at());
      row.length += way;
      row.effort += kStandingEffort * dt + kWalkingEffort * way * way / dt;
    }
    const scene::Fix& from = recording.fix(track.front());
    const scene::Fix& to = recording.fix(track.back());
    row.seconds = (to.frame - from.frame) / recording.trajectories.frame_rate;
    row.shortest = shortest ? shortest(from.at(), to.at()) : length(to.at() - from.at());
    rows.push_back(row);
  }
  return rows;
}

}  // namespace inhabit::crowd
