#pragma once
#include "crowd/measures/area_density.h"

/// The fundamental diagram: how speed depends on density.
namespace inhabit::crowd {

struct FundamentalPoint {
  double density = 0;  ///< people per square metre; in single file per metre
  double speed = 0;    ///< metres per second
};

/// The rows that have people and a speed, between two times in seconds.
std::vector<FundamentalPoint> fundamental_points(std::span<const AreaRow> rows, double from = -1e300,
                                                 double until = 1e300);

/// Points with low <= density < low + width, for each such slice of the density that has any.
struct DensityBin {
  double low = 0, high = 0;
  std::size_t count = 0;
  double median = 0, lower = 0, upper = 0;  ///< speed: median and quartiles (core/statistics.h)
  double density = 0;                       ///< median density of the points
};
/// Slices begin at the multiples of `width` > 0.
std::vector<DensityBin> density_bins(std::span<const FundamentalPoint> points, double width);

/// Speed of unhindered walkers at a density [Weidmann93]: v(rho) = 1.34 (1 - exp(-1.913 (1/rho - 1/5.4))) m/s; 1.34 at
/// 0, 0 from 5.4 people per square metre on.
double weidmann_speed(double density);

/// Root of the mean square of speed - weidmann_speed(density), m/s; kUnknown for no points. Of bins each counts once,
/// so that a long spell at one density does not hide the others.
double weidmann_rmse(std::span<const FundamentalPoint> points);
double weidmann_rmse(std::span<const DensityBin> bins);

/// Two measurements of one curve, compared where both have at least `least` points in a bin.
struct CurveComparison {
  std::size_t bins = 0;
  double mean = kUnknown;   ///< of ours - theirs, median speeds of the bins, m/s
  double rmse = kUnknown;   ///< root of the mean square of the same
  double worst = kUnknown;  ///< largest absolute difference
};
CurveComparison compare_curves(std::span<const DensityBin> ours, std::span<const DensityBin> theirs,
                               std::size_t least = 1);

}  // namespace inhabit::crowd
