#include "core/distributions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace inhabit::core;

TEST_CASE("our logarithm is the logarithm") {
  // Against the C library's, which is right to one unit in the last place; ours may add a few more.
  CHECK(natural_log(1) == 0);
  Rng rng(3);
  double worst = 0;
  for (int k = 0; k < 100000; ++k) {
    const double x = std::exp(rng.uniform(-600, 600));
    worst = std::max(worst, std::abs(natural_log(x) - std::log(x)) / std::abs(std::log(x)));
    const double near = 1 + rng.uniform(-1e-3, 1e-3);
    worst = std::max(worst, std::abs(natural_log(near) - std::log(near)));
  }
  CHECK(worst < 1e-15);
  CHECK(std::abs(natural_log(0x1p-53) + 53 * std::log(2.0)) < 1e-14);
}

TEST_CASE("normal numbers have the moments and tails of the normal distribution") {
  Rng rng(7);
  const int n = 200000;
  double sum = 0, squares = 0;
  int within_one = 0, beyond_three = 0;
  for (int k = 0; k < n; ++k) {
    const double z = standard_normal(rng);
    sum += z, squares += z * z;
    within_one += std::abs(z)<1, beyond_three += std::abs(z)> 3;
  }
  // Four standard errors each: 1 / sqrt(n), sqrt(2 / n), sqrt(p (1 - p) / n).
  CHECK(std::abs(sum / n) < 4 / std::sqrt(n));
  CHECK(std::abs(squares / n - 1) < 4 * std::sqrt(2.0 / n));
  CHECK(std::abs(within_one / double(n) - 0.682689) < 4 * std::sqrt(0.68 * 0.32 / n));
  CHECK(std::abs(beyond_three / double(n) - 0.0026998) < 4 * std::sqrt(0.0027 / n));
}

TEST_CASE("exponential numbers have mean one and no memory") {
  Rng rng(9);
  const int n = 200000;
  double sum = 0;
  int beyond_one = 0, beyond_two = 0;
  for (int k = 0; k < n; ++k) {
    const double t = exponential(rng);
    REQUIRE(t >= 0);
    sum += t, beyond_one += t > 1, beyond_two += t > 2;
  }
  CHECK(std::abs(sum / n - 1) < 4 / std::sqrt(n));
  CHECK(std::abs(beyond_one / double(n) - std::exp(-1.0)) < 4 * std::sqrt(0.24 / n));
  CHECK(std::abs(beyond_two / double(beyond_one) - std::exp(-1.0)) < 4 * std::sqrt(0.24 / beyond_one));
}
