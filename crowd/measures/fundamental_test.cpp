#include "crowd/measures/fundamental.h"

#include <doctest/doctest.h>

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("the curve of Weidmann has its ends and its published middle") {
  CHECK(weidmann_speed(0) == 1.34);
  CHECK(weidmann_speed(5.4) == doctest::Approx(0).epsilon(1e-12));
  CHECK(weidmann_speed(7) == 0);
  // 1.34 (1 - exp(-1.913 (1 - 0.185185…))) at one person per square metre, by hand.
  CHECK(weidmann_speed(1) == doctest::Approx(1.0581).epsilon(1e-4));
}

TEST_CASE("points on the curve are no distance from it and points beside it are") {
  std::vector<FundamentalPoint> points;
  for (double d = 0.3; d < 5; d += 0.1) points.push_back({d, weidmann_speed(d)});
  CHECK(weidmann_rmse(points) == 0);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].speed += i % 2 ? 0.2 : -0.2;
  CHECK(weidmann_rmse(points) == doctest::Approx(0.2).epsilon(1e-12));
  CHECK(!known(weidmann_rmse(std::span<const FundamentalPoint>{})));
}

TEST_CASE("bins have medians and quartiles") {
  const std::vector<FundamentalPoint> points = {{0.1, 1}, {0.2, 3}, {0.3, 2}, {0.4, 9}, {1.0, 5}, {1.2, 7}};
  const std::vector<DensityBin> bins = density_bins(points, 0.5);
  REQUIRE(bins.size() == 2);
  CHECK(bins[0].count == 4);
  CHECK(bins[0].median == 2.5);
  CHECK(bins[0].lower == 1);
  CHECK(bins[0].upper == 3);
  CHECK(bins[1].low == 1);
  CHECK(bins[1].median == 6);
}

TEST_CASE("curves are compared where both are known") {
  const std::vector<DensityBin> a = {{0, 1, 5, 1.2}, {1, 2, 5, 1.0}, {2, 3, 5, 0.7}};
  const std::vector<DensityBin> b = {{1, 2, 5, 0.9}, {2, 3, 5, 0.9}, {3, 4, 5, 0.2}};
  const CurveComparison c = compare_curves(a, b);
  CHECK(c.bins == 2);
  CHECK(c.mean == doctest::Approx(-0.05));
  CHECK(c.rmse == doctest::Approx(std::sqrt(0.025)));
  CHECK(c.worst == doctest::Approx(0.2));
  CHECK(compare_curves(a, b, 6).bins == 0);
}

TEST_CASE("frames without people give no point") {
  const std::vector<AreaRow> rows = {{0, 0, 0, 0, kUnknown}, {5, 0.5, 2, 1.0, 0.8}, {6, 0.6, 2, 1.0, 0.9}};
  CHECK(fundamental_points(rows).size() == 2);
  CHECK(fundamental_points(rows, 0.55).size() == 1);
  CHECK(fundamental_points(rows, 0, 0.45).empty());
}
