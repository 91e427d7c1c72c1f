#pragma once

/// Did people prefer one of two? `k` of `n` choices fell on the human design; by chance each has probability 1/2.
namespace inhabit::session {

/// χ² of both cells against n/2 each: 2 (k − n/2)² / (n/2), one degree of freedom. Requires: n > 0.
double chi_square(int k, int n);
/// As Yu11's table 2 has it: (|k − n/2| − 1/2)² / (n/2), which is the first of the two cells alone, with Yates'
/// correction. Half of what the corrected statistic of both cells is. Requires: n > 0.
double chi_square_of_paper(int k, int n);
/// Probability of a χ² of one degree of freedom that is at least this large: erfc(√(χ²/2)).
double chi_square_p(double chi_square);

/// C(n, k) / 2ⁿ, to about n ulp; 0 below the smallest double. Requires: 0 <= k <= n. Cost: n.
double coin_probability(int k, int n);
/// Probability that a fair coin is at least as far from n/2 as k, on either side: what χ² approaches for large n.
double coin_p(int k, int n);

/// Odds of H0: P = 1/2 against H1: P uniform in [0, 1], when both were equally likely before [Yu11 §6.4, table 3]:
///   O = C(n, k) / 2ⁿ · (n + 1)
double odds_for_chance(int k, int n);

/// What odds say [Yu11 §6.4, after Rouder et al. 2009]: above 3 no difference, below 1/3 a difference.
enum class Evidence { no_difference, inconclusive, difference };
Evidence evidence_of(double odds);

}  // namespace inhabit::session
