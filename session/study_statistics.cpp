#include "session/study_statistics.h"

#include <algorithm>
#include <cmath>

namespace inhabit::session {

double chi_square(int k, int n) {
  const double off = 2.0 * k - n;
  return off * off / n;
}

double chi_square_of_paper(int k, int n) {
  const double off = std::abs(k - n / 2.0) - 0.5;
  return off * off / (n / 2.0);
}

double chi_square_p(double chi_square) { return std::erfc(std::sqrt(chi_square / 2)); }

double coin_probability(int k, int n) {
  // Fraction and power of two apart, so that neither C(n, k) nor 2ⁿ can overflow.
  double fraction = 1;
  int power = -n;
  const int m = std::min(k, n - k);
  for (int i = 1; i <= m; ++i) {
    int more = 0;
    fraction = std::frexp(fraction * (n - m + i) / i, &more);
    power += more;
  }
  return std::ldexp(fraction, power);
}

double coin_p(int k, int n) {
  const int m = std::min(k, n - k);
  if (2 * m == n) return 1;
  // From the nearest term outwards: C(n, j − 1) = C(n, j) j / (n − j + 1).
  double term = coin_probability(m, n), sum = 0;
  for (int j = m; j >= 0 && term > 0; --j) {
    sum += term;
    term = term * j / (n - j + 1);
  }
  return std::min(1.0, 2 * sum);
}

double odds_for_chance(int k, int n) { return coin_probability(k, n) * (n + 1.0); }

Evidence evidence_of(double odds) {
  return odds > 3 ? Evidence::no_difference : odds < 1.0 / 3 ? Evidence::difference : Evidence::inconclusive;
}

}  // namespace inhabit::session
