#include "exemplar/ward.h"

#include <algorithm>
#include <numeric>

#include "geometry/vec2.h"

namespace inhabit::exemplar {
namespace {

/// Length and the directions of two angles, in units of their spread.
using Point = std::array<double, 5>;
constexpr std::size_t kMost = 160;

double squared(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

std::vector<Point> embedded(std::span<const Sample> samples, int angles, Spread spread) {
  std::vector<Point> points;
  for (const Sample& s : samples) {
    Point p{s.length / 0.15};
    for (std::size_t a = 0; a < static_cast<std::size_t>(angles); ++a) {
      const geometry::Vec2 d = geometry::direction(wrap_angle(s.angles[a]));
      p[1 + 2 * a] = d.x / 0.35, p[2 + 2 * a] = d.y / 0.35;
    }
    points.push_back(p);
  }
  if (spread == Spread::fixed) return points;
  const double n = static_cast<double>(points.size());
  // The two coordinates of one angle share their spread.
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 3}, {3, 5}}) {
    double variance = 0;
    for (std::size_t i = from; i < to; ++i) {
      double mean = 0;
      for (const Point& p : points) mean += p[i] / n;
      for (const Point& p : points) variance += (p[i] - mean) * (p[i] - mean) / n;
    }
    const double scale = 1 / std::sqrt(std::max(variance, 1e-12));
    for (Point& p : points)
      for (std::size_t i = from; i < to; ++i) p[i] *= scale;
  }
  return points;
}

struct Heap {
  Point center;
  double count = 0;
};

/// What joining two costs: the growth of the sum of squares.
double cost(const Heap& a, const Heap& b) {
  return a.count * b.count / (a.count + b.count) * squared(a.center, b.center);
}

void join_nearest(std::vector<Heap>& heaps) {
  std::size_t first = 0, second = 1;
  double least = 1e300;
  for (std::size_t i = 0; i < heaps.size(); ++i)
    for (std::size_t k = i + 1; k < heaps.size(); ++k)
      if (const double c = cost(heaps[i], heaps[k]); c < least) least = c, first = i, second = k;
  Heap& into = heaps[first];
  const Heap& from = heaps[second];
  const double all = into.count + from.count;
  for (std::size_t i = 0; i < into.center.size(); ++i)
    into.center[i] = (into.count * into.center[i] + from.count * from.center[i]) / all;
  into.count = all;
  heaps.erase(heaps.begin() + static_cast<std::ptrdiff_t>(second));
}

std::vector<int> nearest_heaps(const std::vector<Point>& points, const std::vector<Heap>& heaps) {
  std::vector<int> of;
  for (const Point& p : points) {
    std::size_t best = 0;
    for (std::size_t h = 1; h < heaps.size(); ++h)
      if (squared(p, heaps[h].center) < squared(p, heaps[best].center)) best = h;
    of.push_back(static_cast<int>(best));
  }
  return of;
}

}  // namespace

std::vector<std::vector<int>> agglomerate(std::span<const Sample> samples, int angles, Spread spread, int most) {
  const std::vector<Point> points = embedded(samples, angles, spread);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<Heap> heaps;
  const std::size_t used = std::min(order.size(), kMost);
  for (std::size_t i = 0; i < used; ++i) heaps.push_back({points[order[i * order.size() / used]], 1});
  std::vector<std::vector<int>> levels(static_cast<std::size_t>(most));
  for (;;) {
    if (heaps.size() <= levels.size()) levels[heaps.size() - 1] = nearest_heaps(points, heaps);
    if (heaps.size() == 1) return levels;
    join_nearest(heaps);
  }
}

}  // namespace inhabit::exemplar
