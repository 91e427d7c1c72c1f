#pragma once
#include <vector>

#include "exemplar/cluster.h"

/// Agglomerative clustering, from which the mixtures of exemplar/cluster.h start.
namespace inhabit::exemplar {

/// What a unit of length and of angle is worth: a fixed 15 cm and 20 degrees, or the samples' own deviation.
enum class Spread { fixed, of_samples };

/// Ward's method on at most 160 of the samples, evenly chosen in order of length and angle; the others join the nearest
/// centre. Element k - 1 assigns every sample to one of k clusters. Requires: at least one sample, 1 <= most <=
/// samples.
std::vector<std::vector<int>> agglomerate(std::span<const Sample> samples, int angles, Spread spread, int most);

}  // namespace inhabit::exemplar
