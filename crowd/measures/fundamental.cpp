#include "crowd/measures/fundamental.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/statistics.h"

namespace inhabit::crowd {

std::vector<FundamentalPoint> fundamental_points(std::span<const AreaRow> rows, double from, double until) {
  std::vector<FundamentalPoint> points;
  for (const AreaRow& row : rows)
    if (row.density > 0 && known(row.speed) && row.seconds >= from && row.seconds <= until)
      points.push_back({row.density, row.speed});
  return points;
}

std::vector<DensityBin> density_bins(std::span<const FundamentalPoint> points, double width) {
  std::map<double, std::pair<std::vector<double>, std::vector<double>>> slices;
  for (const FundamentalPoint& p : points) {
    auto& [densities, speeds] = slices[std::floor(p.density / width)];
    densities.push_back(p.density), speeds.push_back(p.speed);
  }
  std::vector<DensityBin> bins;
  for (const auto& [k, slice] : slices) {
    const auto& [densities, speeds] = slice;
    bins.push_back({k * width, (k + 1) * width, speeds.size(), median(speeds), quantile(speeds, 0.25),
                    quantile(speeds, 0.75), median(densities)});
  }
  return bins;
}

double weidmann_speed(double density) {
  if (density <= 0) return 1.34;
  return std::max(0.0, 1.34 * (1 - std::exp(-1.913 * (1 / density - 1 / 5.4))));
}

double weidmann_rmse(std::span<const FundamentalPoint> points) {
  if (points.empty()) return kUnknown;
  double sum = 0;
  for (const FundamentalPoint& p : points) {
    const double d = p.speed - weidmann_speed(p.density);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

double weidmann_rmse(std::span<const DensityBin> bins) {
  std::vector<FundamentalPoint> points;
  for (const DensityBin& bin : bins) points.push_back({bin.density, bin.median});
  return weidmann_rmse(points);
}

CurveComparison compare_curves(std::span<const DensityBin> ours, std::span<const DensityBin> theirs,
                               std::size_t least) {
  CurveComparison c;
  double sum = 0, squares = 0, worst = 0;
  for (const DensityBin& a : ours) {
    for (const DensityBin& b : theirs) {
      if (a.low != b.low || a.count < least || b.count < least) continue;
      const double d = a.median - b.median;
      sum += d, squares += d * d, worst = std::max(worst, std::abs(d));
      ++c.bins;
    }
  }
  if (c.bins == 0) return c;
  const auto n = static_cast<double>(c.bins);
  c.mean = sum / n, c.rmse = std::sqrt(squares / n), c.worst = worst;
  return c;
}

}  // namespace inhabit::crowd
