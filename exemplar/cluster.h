#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/angle.h"
#include "core/core.h"

/// Clusters of a length and up to two angles: mixtures by expectation-maximisation, their number by minimum description
/// length (Yu et al. 2011, section 3.2, which cites Grunwald 2007; here its usual form, BIC).
namespace inhabit::exemplar {
using namespace core;

struct Sample {
  double length = 0;               ///< metres
  std::array<double, 2> angles{};  ///< radians, any turn
};

struct Cluster {
  double length = 0, length_deviation = 0;             ///< mean and standard deviation
  std::array<double, 2> angles{}, angle_deviations{};  ///< circular: in (-pi, pi]; sqrt(-2 ln R), at most pi
  int count = 0;                                       ///< samples that are likeliest in it
};

struct ClusterOptions {
  int angles = 1;  ///< how many of a sample's angles count: 0 to 2
  int most = 8;    ///< clusters; with n samples also at most n / 3, rounded up (two of two or three)
};

struct Clustering {
  std::vector<Cluster> clusters;  ///< most frequent first, then by length
  std::vector<int> of;            ///< the cluster of every sample
  double bic = 0;                 ///< -2 ln L + p ln n of what was chosen
};

/// A mixture of normal lengths and von Mises angles, independent within a component. For every number of components the
/// search starts from two agglomerations (Ward) of at most 160 samples, so that nothing is random; the least BIC wins,
/// the smaller number when equal. Deviations are held up by a prior worth three samples of 5 cm and 5 degrees (Fraley
/// and Raftery 2007), without which two equal samples would be a cluster of infinite likelihood. No samples: no
/// clusters. Cost O(samples · clusters · iterations).
Clustering cluster(std::span<const Sample> samples, const ClusterOptions& options = {});

}  // namespace inhabit::exemplar
