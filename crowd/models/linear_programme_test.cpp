#include "crowd/models/linear_programme.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace inhabit::crowd;

namespace {

std::vector<HalfPlane> random_planes(Rng& rng, double farthest) {
  std::vector<HalfPlane> planes(1 + rng.index(12));
  for (HalfPlane& h : planes) h = {direction(rng.uniform(-kPi, kPi)), rng.uniform(-farthest, 0.5 * farthest)};
  if (rng.index(4) == 0) planes.push_back({-planes[0].n, rng.uniform(-1, 1)});  // parallel
  if (rng.index(4) == 0) planes.push_back(planes[0]);                           // twice
  return planes;
}

double worst(std::span<const HalfPlane> planes, Vec2 v) {
  double most = 0;
  for (const HalfPlane& h : planes) most = std::max(most, violation(h, v));
  return most;
}

/// Calls f(v) for a raster over the disc, its border included.
constexpr int kRaster = 48;
template <class F>
void for_each_velocity(double longest, F&& f) {
  for (int i = -kRaster; i <= kRaster; ++i)
    for (int j = -kRaster; j <= kRaster; ++j) {
      const Vec2 v{longest * i / kRaster, longest * j / kRaster};
      if (length(v) <= longest) f(v);
    }
  for (int k = 0; k < 8 * kRaster; ++k) f(longest * direction(2 * kPi * k / (8 * kRaster)));
}

}  // namespace

TEST_CASE("no velocity of a raster in all half planes is nearer to the wish than the optimum") {
  int feasible = 0;
  for (std::uint64_t n = 0; n < 4000; ++n) {
    INFO("case ", n);
    Rng rng(21, n);
    const double longest = 2;
    const auto planes = random_planes(rng, n % 2 == 0 ? 2 : 1);
    const Vec2 wish{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const PlaneOptimum best = optimum(planes, wish, longest, false);
    bool any = false;
    double nearest = 1e9;
    for_each_velocity(longest, [&](Vec2 v) {
      if (worst(planes, v) <= 0) any = true, nearest = std::min(nearest, length(v - wish));
    });
    if (any) CHECK(best.feasible);
    if (!best.feasible) continue;
    ++feasible;
    // Exact up to rounding: feasible itself, and not farther than any point of the raster.
    CHECK(worst(planes, best.v) <= 2e-9);
    CHECK(length(best.v) <= longest + 1e-12);
    CHECK(length(best.v - wish) <= nearest + 2e-9);
    // And the nearest: a step towards the wish leaves the half planes or the disc.
    if (length(wish - best.v) > 1e-3) {
      const Vec2 nearer = best.v + 1e-4 * unit(wish - best.v);
      CHECK((worst(planes, nearer) > 0 || length(nearer) > longest));
    }
  }
  CHECK(feasible > 1000);
  CHECK(feasible < 3900);
}

TEST_CASE("when nothing is left the worst violation is the least that a raster finds") {
  int infeasible = 0;
  for (std::uint64_t n = 0; n < 4000; ++n) {
    INFO("case ", n);
    Rng rng(22, n);
    const double longest = 2;
    const auto planes = random_planes(rng, 1 + 2 * rng.uniform());
    const Vec2 wish{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    if (optimum(planes, wish, longest, false).feasible) continue;
    ++infeasible;
    LinearProgramme programme;
    const Vec2 v = programme.solve(planes, 0, wish, longest);
    CHECK(length(v) <= longest + 1e-9);
    double least = 1e9;
    for_each_velocity(longest, [&](Vec2 at) { least = std::min(least, worst(planes, at)); });
    const double found = worst(planes, v);
    // The raster's own error is its diagonal at most: violations change as fast as v.
    CHECK(found <= least + 1e-8);
    CHECK(found >= least - 2 * std::sqrt(0.5) * longest / kRaster);
  }
  CHECK(infeasible > 500);
}

TEST_CASE("hard half planes hold when the others cannot") {
  int infeasible = 0;
  for (std::uint64_t n = 0; n < 4000; ++n) {
    INFO("case ", n);
    Rng rng(23, n);
    auto planes = random_planes(rng, 1.5);
    const std::size_t hard = std::min<std::size_t>(1 + rng.index(3), planes.size());
    for (std::size_t k = 0; k < hard; ++k) planes[k].c = -rng.uniform();  // walls: standing still is allowed
    const Vec2 wish{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    if (optimum(planes, wish, 2, false).feasible) continue;
    ++infeasible;
    LinearProgramme programme;
    const Vec2 v = programme.solve(planes, hard, wish, 2);
    CHECK(worst(std::span(planes).first(hard), v) <= 2e-9);
    double least = 1e9;
    for_each_velocity(2, [&](Vec2 at) {
      if (worst(std::span(planes).first(hard), at) <= 0)
        least = std::min(least, worst(std::span(planes).subspan(hard), at));
    });
    CHECK(worst(std::span(planes).subspan(hard), v) <= least + 1e-8);
  }
  CHECK(infeasible > 500);
}

TEST_CASE("two walls face to face leave the middle") {
  const std::vector<HalfPlane> planes = {{{1, 0}, 0.5}, {{-1, 0}, 0.5}};
  LinearProgramme programme;
  const Vec2 v = programme.solve(planes, 0, {3, 0}, 2);
  CHECK(std::abs(v.x) < 1e-12);
}

TEST_CASE("without half planes the wish is cut at the longest") {
  LinearProgramme programme;
  CHECK(programme.solve({}, 0, {0.5, 0.25}, 2) == Vec2{0.5, 0.25});
  CHECK(length(programme.solve({}, 0, {3, 4}, 2) - Vec2{1.2, 1.6}) < 1e-15);
  CHECK(programme.solve({}, 0, {3, 4}, 0) == Vec2{});
}
