#include "core/statistics.h"

#include <algorithm>
#include <cmath>

namespace inhabit::core {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  if (share == 0.5) return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(n)));
  return values[std::clamp<std::size_t>(rank, 1, n) - 1];
}

}  // namespace inhabit::core
