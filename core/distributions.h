#pragma once
#include "core/rng.h"

/// Random numbers that are not uniform. Ours and not the standard library's, whose last bits differ between machines:
/// same seed, same bytes.
namespace inhabit::core {

/// Natural logarithm, relative error below 1e-15 (absolute below 1e-16 near 1). Requires: 0 < x < infinity, x normal.
double natural_log(double x);

/// Normally distributed, mean 0, deviation 1: sqrt(-2 ln(1 - u)) cos(2 pi v) (Box and Muller 1958). Draws u, then v.
double standard_normal(Rng& rng);

/// Waiting time for the next of events that come at random, one per unit of time: -ln(1 - u).
double exponential(Rng& rng);

}  // namespace inhabit::core
