#include "crowd/measures/single_file.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"
#include "crowd/measures/velocity.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("people at equal distances have one density by both definitions") {
  for (const double sign : {1.0, -1.0}) {
    const auto t = walkers(8, 11, 10, [&](int p, double s) { return Vec2{3.0, 0.8 * p + sign * 0.6 * s}; });
    const Recording r(t);
    const auto v = velocities(r, {1, SpeedWindow::Ends::one_sided});
    for (const auto density : {SingleFile::Density::headway, SingleFile::Density::voronoi}) {
      const auto points = single_file_points(r, v, {{0, 0}, {0, 1}, -1e300, 1e300, density});
      CHECK(points.size() == (density == SingleFile::Density::headway ? 77 : 66));
      for (const FundamentalPoint& p : points) {
        CHECK(p.density == doctest::Approx(1.25).epsilon(1e-12));
        CHECK(p.speed == doctest::Approx(0.6).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("ahead is where people go") {
  // At s = 0, 1, 3, all walk backward: the one at 1 has 1 m of headway, the one at 3 has 2 m.
  const auto t = walkers(3, 3, 10, [](int p, double s) { return Vec2{(p == 2 ? 3.0 : p) - s, 0}; });
  const Recording r(t);
  const auto v = velocities(r, {1, SpeedWindow::Ends::one_sided});
  SingleFile file;
  file.density = SingleFile::Density::headway;
  const auto points = single_file_points(r, v, file);
  REQUIRE(points.size() == 6);
  CHECK(points[0].density == doctest::Approx(0.5));
  CHECK(points[1].density == doctest::Approx(1));
  file.density = SingleFile::Density::voronoi;
  CHECK(single_file_points(r, v, file)[0].density == doctest::Approx(2 / 3.0));
  file.from = 5;
  CHECK(single_file_points(r, v, file).empty());
}
