#include "crowd/measures/lanes.h"

#include <algorithm>
#include <cmath>

namespace inhabit::crowd {
namespace {

struct Walker {
  double across = 0;
  int way = 1;
};

double order(std::vector<Walker>& walkers, double band) {
  std::ranges::sort(walkers, {}, [](const Walker& w) { return std::pair(w.across, w.way); });
  double sum = 0;
  std::size_t low = 0, high = 0;  // the band is [low, high)
  int balance = 0;                // of the ways in it
  for (const Walker& w : walkers) {
    while (high < walkers.size() && walkers[high].across - w.across < band) balance += walkers[high++].way;
    while (w.across - walkers[low].across >= band) balance -= walkers[low++].way;
    const double share = balance / static_cast<double>(high - low);
    sum += share * share;
  }
  return sum / static_cast<double>(walkers.size());
}

}  // namespace

std::vector<LaneRow> lanes(const Recording& recording, std::span<const Vec2> velocities, const LaneOptions& options,
                           int threads) {
  std::vector<LaneRow> rows(recording.frame_count());
  for_each_frame(recording, threads, [&](std::size_t k) {
    LaneRow row{recording.seconds(recording.frames.frames[k])};
    std::vector<Walker> walkers;
    for (std::size_t i = recording.first(k); i < recording.first(k) + recording.count(k); ++i) {
      if (!known(velocities[i]) || std::abs(dot(velocities[i], options.axis)) < options.slowest) continue;
      const int way = dot(velocities[i], options.axis) < 0 ? -1 : 1;
      (way > 0 ? row.forward : row.backward) += 1;
      walkers.push_back({dot(recording.fix(i).at(), perp(options.axis)), way});
    }
    if (std::min(row.forward, row.backward) >= std::max(options.least, 1)) row.order = order(walkers, options.band);
    rows[k] = row;
  });
  return rows;
}

double mean_order(std::span<const LaneRow> rows) {
  double sum = 0;
  std::size_t count = 0;
  for (const LaneRow& row : rows)
    if (known(row.order)) sum += row.order, ++count;
  return count > 0 ? sum / static_cast<double>(count) : kUnknown;
}

}  // namespace inhabit::crowd
