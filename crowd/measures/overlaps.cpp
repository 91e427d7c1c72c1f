#include "crowd/measures/overlaps.h"

#include <algorithm>

#include "geometry/point_grid.h"

namespace inhabit::crowd {

double Radii::largest() const { return of_fix.empty() ? everybody : *std::ranges::max_element(of_fix); }

Overlaps overlaps(const Recording& recording, const Radii& radii, int threads, double tolerance) {
  struct Deepest {
    double share = 0;
    std::size_t i = 0, j = 0;
  };
  Overlaps result;
  result.rows.resize(recording.frame_count());
  std::vector<Deepest> deepest(recording.frame_count());
  const double reach = 2 * radii.largest();
  if (!(reach > 0)) return result;
  for_each_frame(recording, threads, [&](std::size_t k) {
    const std::vector<Vec2> places = recording.places(k);
    Overlaps::Row& row = result.rows[k];
    row.seconds = recording.seconds(recording.frames.frames[k]);
    for_each_close_pair(places, reach, [&](std::size_t a, std::size_t b) {
      const std::size_t i = recording.first(k) + a, j = recording.first(k) + b;
      const double sum = radii(i) + radii(j), depth = sum - length(places[a] - places[b]);
      if (depth <= tolerance) return;
      ++row.pairs;
      deepest[k].share = std::max(deepest[k].share, depth / sum);
      if (depth > row.worst) row.worst = depth, deepest[k].i = i, deepest[k].j = j;
    });
  });
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const Overlaps::Row& row = result.rows[k];
    result.pairs += static_cast<std::size_t>(row.pairs);
    result.worst_share = std::max(result.worst_share, deepest[k].share);
    if (row.worst <= result.worst) continue;
    result.worst = row.worst, result.worst_seconds = row.seconds;
    result.first = recording.fix(deepest[k].i).person, result.second = recording.fix(deepest[k].j).person;
  }
  return result;
}

}  // namespace inhabit::crowd
