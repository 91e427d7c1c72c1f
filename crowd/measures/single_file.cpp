#include "crowd/measures/single_file.h"

#include <algorithm>

namespace inhabit::crowd {

std::vector<FundamentalPoint> single_file_points(const Recording& recording, std::span<const Vec2> velocities,
                                                 const SingleFile& file, int every) {
  struct Walker {
    double s = 0;
    std::size_t fix = 0;
  };
  std::vector<FundamentalPoint> points;
  std::vector<Walker> line;
  for (std::size_t k = 0; k < recording.frame_count(); ++k) {
    if (recording.frames.frames[k] % std::max(every, 1) != 0) continue;
    line.clear();
    double way = 0;
    for (std::size_t i = recording.first(k); i < recording.first(k) + recording.count(k); ++i) {
      line.push_back({dot(recording.fix(i).at() - file.origin, file.axis), i});
      if (known(velocities[i])) way += dot(velocities[i], file.axis);
    }
    if (way == 0) continue;
    const double sign = way > 0 ? 1 : -1;
    std::ranges::sort(line, {}, [&](const Walker& w) { return std::pair(sign * w.s, w.fix); });
    for (std::size_t j = 0; j + 1 < line.size(); ++j) {
      const Walker& w = line[j];
      if (w.s < file.from || w.s > file.until || !known(velocities[w.fix])) continue;
      const bool voronoi = file.density == SingleFile::Density::voronoi;
      if (voronoi && j == 0) continue;
      const double room = voronoi ? std::abs(line[j + 1].s - line[j - 1].s) / 2 : std::abs(line[j + 1].s - w.s);
      if (room > 0) points.push_back({1 / room, length(velocities[w.fix])});
    }
  }
  return points;
}

}  // namespace inhabit::crowd
