#include "exemplar/cluster.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/distributions.h"

using namespace inhabit::exemplar;

namespace {

struct Planted {
  std::vector<Sample> samples, means;
};

/// One to four clusters of 12 to 40 samples with deviations up to 2 cm and 2 degrees; any two differ by 0.25 m or by 40
/// degrees at least. The standard error of a mean is at most 2 / sqrt(12) = 0.6 cm or degrees: a third of the
/// tolerance.
Planted plant(std::uint64_t trial, int angles) {
  Rng rng(trial, 77);
  Planted out;
  const int count = 1 + static_cast<int>(rng.index(4));
  while (static_cast<int>(out.means.size()) < count) {
    const Sample mean{rng.uniform(0, 2), {rng.uniform(-kPi, kPi), rng.uniform(-kPi, kPi)}};
    const bool apart = std::ranges::all_of(out.means, [&](const Sample& other) {
      return std::abs(mean.length - other.length) > 0.25 ||
             std::abs(wrap_angle(mean.angles[0] - other.angles[0])) > radians(40);
    });
    if (apart) out.means.push_back(mean);
  }
  for (const Sample& mean : out.means) {
    const double length = rng.uniform(0.002, 0.02), turn = radians(rng.uniform(0.2, 2));
    for (int n = 12 + static_cast<int>(rng.index(29)); n > 0; --n) {
      Sample s = mean;
      s.length += length * standard_normal(rng);
      for (int a = 0; a < angles; ++a) s.angles[static_cast<std::size_t>(a)] += turn * standard_normal(rng);
      out.samples.push_back(s);
    }
  }
  return out;
}

bool found_again(const Planted& planted, const Clustering& found, int angles) {
  if (found.clusters.size() != planted.means.size()) return false;
  return std::ranges::all_of(planted.means, [&](const Sample& mean) {
    return std::ranges::any_of(found.clusters, [&](const Cluster& c) {
      bool near = std::abs(c.length - mean.length) < 0.02;
      for (std::size_t a = 0; a < static_cast<std::size_t>(angles); ++a)
        near = near && std::abs(wrap_angle(c.angles[a] - mean.angles[a])) < radians(2);
      return near;
    });
  });
}

}  // namespace

TEST_CASE("planted clusters come back by number and by mean in 95 of 100 trials") {
  for (const int angles : {0, 1, 2}) {
    int good = 0;
    constexpr int kTrials = 400;
    for (std::uint64_t trial = 1; trial <= kTrials; ++trial) {
      Planted planted = plant(trial, 2);
      if (angles == 0) {  // lengths alone must tell them apart
        planted = plant(trial, 0);
        bool apart = true;
        for (std::size_t i = 0; i < planted.means.size(); ++i)
          for (std::size_t k = 0; k < i; ++k)
            apart = apart && std::abs(planted.means[i].length - planted.means[k].length) > 0.25;
        if (!apart) {
          ++good;
          continue;
        }
      }
      good += found_again(planted, cluster(planted.samples, {.angles = angles}), angles);
    }
    MESSAGE(angles, " angles: ", good, " of ", kTrials);
    CHECK(good >= 0.95 * kTrials);
  }
}

TEST_CASE("angles are circular: a cluster about half a turn is one cluster") {
  std::vector<Sample> samples;
  for (int i = -10; i <= 10; ++i) samples.push_back({1, {kPi + radians(i), 0}});
  const Clustering found = cluster(samples);
  REQUIRE(found.clusters.size() == 1);
  CHECK(std::abs(wrap_angle(found.clusters[0].angles[0] - kPi)) < 1e-9);
  CHECK(std::abs(degrees(found.clusters[0].angle_deviations[0]) - 6.06) < 0.05);  // sqrt(mean of i^2) = 6.055
}

TEST_CASE("things that face anywhere are one cluster without a direction") {
  Rng rng(5);
  int single = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Sample> samples;
    for (int i = 0; i < 40; ++i) samples.push_back({0.5 + 0.02 * standard_normal(rng), {rng.uniform(-kPi, kPi), 0}});
    const Clustering found = cluster(samples);
    single += found.clusters.size() == 1 && found.clusters[0].angle_deviations[0] > radians(60);
  }
  CHECK(single >= 95);
}

TEST_CASE("clusters of nothing and of single samples") {
  CHECK(cluster({}).clusters.empty());
  const std::vector<Sample> one = {{0.3, {0.5, 0}}};
  const Clustering found = cluster(one);
  REQUIRE(found.clusters.size() == 1);
  CHECK(found.clusters[0].count == 1);
  CHECK(found.clusters[0].length == doctest::Approx(0.3).epsilon(1e-12));
  CHECK(found.clusters[0].angles[0] == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(found.clusters[0].length_deviation == 0);
  // Two that say different things are not averaged into a third that nobody has seen.
  const std::vector<Sample> two = {{0, {0, 0}}, {2, {kPi / 2, 0}}};
  CHECK(cluster(two).clusters.size() == 2);
  const std::vector<Sample> alike = {{0.02, {0, 0}}, {0.06, {radians(2), 0}}};
  CHECK(cluster(alike).clusters.size() == 1);
  const std::vector<Sample> equal(30, Sample{0.1, {1, 0}});
  CHECK(cluster(equal).clusters.size() == 1);
}

TEST_CASE("the order of the samples does not change the clusters") {
  const Planted planted = plant(3, 1);
  std::vector<Sample> turned(planted.samples.rbegin(), planted.samples.rend());
  const Clustering a = cluster(planted.samples), b = cluster(turned);
  REQUIRE(a.clusters.size() == b.clusters.size());
  for (std::size_t i = 0; i < a.clusters.size(); ++i) {
    CHECK(a.clusters[i].count == b.clusters[i].count);
    CHECK(std::abs(a.clusters[i].length - b.clusters[i].length) < 1e-9);
  }
}
