#include "crowd/measures/wall_contacts.h"

#include <algorithm>

#include "geometry/containment.h"

namespace inhabit::crowd {
namespace {

/// Metres from p to the nearest border, negative outside.
double clearance(const std::vector<Floor>& floors, Vec2 p) {
  double outside = 1e300;
  for (const Floor& floor : floors) {
    if (!contains(floor, p)) {
      outside = std::min(outside, outside_distance(floor, p));
      continue;
    }
    double nearest = nearest_on_ring(floor.outline, p).distance;
    for (const Ring& hole : floor.holes) nearest = std::min(nearest, nearest_on_ring(hole, p).distance);
    return nearest;
  }
  return -outside;
}

}  // namespace

WallContacts wall_contacts(const Recording& recording, const Radii& radii, int threads, double tolerance) {
  WallContacts result;
  std::vector<Area> walkable = recording.trajectories.walkable;
  if (walkable.empty()) return result;
  if (walkable.size() > 1) walkable = difference(walkable, {}, 0);  // neighbours share no wall
  std::vector<Floor> floors;
  for (const Area& area : walkable) floors.push_back(make_floor(area.outline, area.holes));
  std::vector<float> free(recording.fix_count());
  for_each_frame(recording, threads, [&](std::size_t k) {
    for (std::size_t i = recording.first(k); i < recording.first(k) + recording.count(k); ++i)
      free[i] = static_cast<float>(clearance(floors, recording.fix(i).at()));
  });
  for (std::size_t t = 0; t < recording.tracks.size(); ++t) {
    bool touched = false;
    for (const std::uint32_t i : recording.tracks[t]) {
      const double depth = radii(i) - static_cast<double>(free[i]);
      if (free[i] < -tolerance) ++result.outside;
      // Who stands on the very border with no radius touches nothing.
      if (depth <= tolerance) continue;
      ++result.touching, touched = true;
      if (depth <= result.worst) continue;
      result.worst = depth, result.worst_seconds = recording.seconds(recording.fix(i).frame);
      result.who = recording.fix(i).person;
    }
    result.people += touched ? 1 : 0;
  }
  return result;
}

}  // namespace inhabit::crowd
