#pragma once
#include <utility>
#include <vector>

namespace inhabit::core {

/// Value below which `share` of the values lie (the smallest one that so many do not exceed); the mean of the two
/// middle ones for the median of an even count; 0 for no values.
double quantile(std::vector<double> values, double share);
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace inhabit::core
