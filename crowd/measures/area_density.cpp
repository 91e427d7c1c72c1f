#include "crowd/measures/area_density.h"

#include "geometry/convex.h"

namespace inhabit::crowd {

double MeasureArea::overlap(const Area& shape) const {
  double sum = 0;
  for (const Ring& part : parts) {
    sum += overlap_area(shape.outline, part);
    for (const Ring& hole : shape.holes) sum -= overlap_area(hole, part);
  }
  return sum;
}

MeasureArea make_measure_area(Ring ring, const std::vector<Area>& walkable) {
  MeasureArea area;
  area.ring = counter_clockwise(std::move(ring));
  area.parts = convex_parts(area.ring);
  if (walkable.empty()) area.size = signed_area(area.ring);
  for (const Area& part : walkable.empty() ? walkable : intersection(walkable, area.ring, 0)) area.size += part.size();
  return area;
}

std::vector<AreaRow> classic_density(const Recording& recording, const MeasureArea& area, std::span<const double> speed,
                                     int threads) {
  std::vector<AreaRow> rows(recording.frame_count());
  for_each_frame(recording, threads, [&](std::size_t k) {
    AreaRow row{recording.frames.frames[k], recording.seconds(recording.frames.frames[k])};
    double sum = 0;
    int measured = 0;
    for (std::size_t i = recording.first(k); i < recording.first(k) + recording.count(k); ++i) {
      if (!area.contains(recording.fix(i).at())) continue;
      ++row.people;
      if (known(speed[i])) sum += speed[i], ++measured;
    }
    if (area.size > 0) row.density = row.people / area.size;
    if (measured > 0) row.speed = sum / measured;
    rows[k] = row;
  });
  return rows;
}

}  // namespace inhabit::crowd
