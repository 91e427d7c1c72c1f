#include "session/study_statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace inhabit::session;

TEST_CASE("the quantiles of chi-square with one degree of freedom have their probabilities") {
  // Quantiles as printed tables have them, to three places: p is off by at most half a last place times the density.
  CHECK(std::abs(chi_square_p(3.841) - 0.05) < 2e-5);
  CHECK(std::abs(chi_square_p(6.635) - 0.01) < 4e-6);
  CHECK(std::abs(chi_square_p(10.828) - 0.001) < 4e-7);
  CHECK(std::abs(chi_square_p(0.45493642) - 0.5) < 1e-8);
  CHECK(chi_square_p(0) == 1);
}

TEST_CASE("both cells of chi-square add up and the paper has one of them with a correction") {
  for (const int n : {1, 7, 50})
    for (int k = 0; k <= n; ++k) {
      const double half = n / 2.0, cells = (k - half) * (k - half) / half + (n - k - half) * (n - k - half) / half;
      CHECK(std::abs(chi_square(k, n) - cells) < 1e-12 * (1 + cells));
      CHECK(chi_square(k, n) == chi_square(n - k, n));
      const double off = std::abs(k - half) - 0.5;
      CHECK(chi_square_of_paper(k, n) == off * off / half);
    }
  CHECK(chi_square(25, 50) == 0);
  CHECK(chi_square(35, 50) == 8);
  CHECK(std::abs(chi_square_of_paper(31, 50) - 1.21) < 1e-15);
}

TEST_CASE("a coin's probabilities are those of Pascal's triangle and sum to one") {
  CHECK(coin_probability(0, 0) == 1);
  CHECK(coin_probability(2, 4) == 6.0 / 16);
  CHECK(coin_probability(0, 1074) == std::ldexp(1.0, -1074));
  CHECK(coin_probability(0, 2000) == 0);
  for (const int n : {1, 2, 50, 3001}) {
    double sum = 0, odds = 0;
    for (int k = 0; k <= n; ++k) sum += coin_probability(k, n), odds += odds_for_chance(k, n);
    CHECK(std::abs(sum - 1) < 1e-15 * n);
    CHECK(std::abs(odds / (n + 1) - 1) < 1e-15 * n);
  }
  // Stirling: the middle of a million throws, next term of the series below 1e-13.
  const double n = 1e6, middle = std::sqrt(2 / (std::acos(-1.0) * n)) * (1 - 1 / (4 * n));
  CHECK(std::abs(coin_probability(500000, 1000000) / middle - 1) < 1e-9);
}

TEST_CASE("the exact probability counts both tails and chi-square approaches it") {
  CHECK(coin_p(25, 50) == 1);
  CHECK(coin_p(0, 10) == 2.0 / 1024);
  CHECK(coin_p(9, 10) == 22.0 / 1024);
  CHECK(coin_p(1, 3) == 1);
  for (const int k : {0, 3, 20, 24}) CHECK(coin_p(k, 50) == coin_p(50 - k, 50));
  // With n the jump of the distribution vanishes like 1/sqrt(n): half of the outermost term is what parts the two.
  CHECK(std::abs(coin_p(500800, 1000000) - coin_probability(500800, 1000000) -
                 chi_square_p(chi_square(500800, 1000000))) < 1e-6);
}

TEST_CASE("odds are the probability of a fair coin over that of any coin") {
  // Any coin gives every k with probability 1 / (n + 1): the integral of C(n, k) P^k (1 - P)^(n - k).
  const int n = 12, k = 4, steps = 100000;
  double integral = 0;
  for (int i = 0; i < steps; ++i) {
    const double p = (i + 0.5) / steps;
    integral += 495 * std::pow(p, k) * std::pow(1 - p, n - k) / steps;
  }
  CHECK(std::abs(odds_for_chance(k, n) - 495 / 4096.0 / integral) < 1e-8);
  CHECK(evidence_of(3.01) == Evidence::no_difference);
  CHECK(evidence_of(3) == Evidence::inconclusive);
  CHECK(evidence_of(0.34) == Evidence::inconclusive);
  CHECK(evidence_of(0.33) == Evidence::difference);
}
