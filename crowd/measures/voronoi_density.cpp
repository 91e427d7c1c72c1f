#include "crowd/measures/voronoi_density.h"

#include <algorithm>
#include <numeric>

namespace inhabit::crowd {

VoronoiDensity voronoi_density(const Recording& recording, const VoronoiGround& ground, const MeasureArea& area,
                               std::span<const double> speed, int threads) {
  VoronoiDensity result;
  result.rows.resize(recording.frame_count());
  std::vector<std::size_t> off(recording.frame_count());
  const Bounds reach = bounds(area.ring);
  for_each_frame(recording, threads, [&](std::size_t k) {
    AreaRow row{recording.frames.frames[k], recording.seconds(recording.frames.frames[k])};
    const std::vector<Vec2> places = recording.places(k);
    const std::vector<Area> cells = ground.cells_meeting(places, reach);
    double people = 0, sum = 0, covered = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      row.people += area.contains(places[i]) ? 1 : 0;
      off[k] += ground.on_ground(places[i]) ? 0 : 1;
      if (cells[i].outline.empty() || !meet(bounds(cells[i].outline), reach)) continue;
      const double shared = area.overlap(cells[i]), whole = cells[i].size();
      if (!(shared > 0)) continue;
      people += shared / whole;
      const double v = speed[recording.first(k) + i];
      if (known(v)) sum += v * shared, covered += shared;
    }
    if (area.size > 0) row.density = people / area.size;
    if (covered > 0) row.speed = sum / covered;
    result.rows[k] = row;
  });
  result.off_ground = std::accumulate(off.begin(), off.end(), std::size_t{0});
  return result;
}

std::vector<double> individual_density(const Recording& recording, const VoronoiGround& ground, int threads) {
  std::vector<double> density(recording.fix_count(), kUnknown);
  for_each_frame(recording, threads, [&](std::size_t k) {
    const std::vector<Area> cells = ground.cells(recording.places(k));
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!cells[i].outline.empty()) density[recording.first(k) + i] = 1 / cells[i].size();
  });
  return density;
}

}  // namespace inhabit::crowd
