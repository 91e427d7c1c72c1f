#include "crowd/measures/spread.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("the axes of a cross are its arms whichever way it is turned") {
  for (const double turn : {0.0, 0.4, 1.2, -0.7}) {
    const Vec2 u{std::cos(turn), std::sin(turn)}, v = perp(u), c{5, -3};
    const std::vector<Vec2> cross = {c + 4.0 * u, c - 4.0 * u, c + 2.0 * v, c - 2.0 * v};
    const Spread spread = spread_of(cross);
    CHECK(length(spread.middle - c) < 1e-12);
    // Variances 2 * 16 / 4 and 2 * 4 / 4.
    CHECK(spread.longer == doctest::Approx(std::sqrt(8.0)));
    CHECK(spread.shorter == doctest::Approx(std::sqrt(2.0)));
    CHECK(spread.ratio() == doctest::Approx(2));
    CHECK(spread.angle == doctest::Approx(turn));
  }
}

TEST_CASE("an even ellipse has the ratio of its axes") {
  std::vector<Vec2> places;
  for (double x = -6; x <= 6; x += 0.1)
    for (double y = -6; y <= 6; y += 0.1)
      if (x * x / 36 + y * y / 16 <= 1) places.push_back({x, y});
  CHECK(spread_of(places).ratio() == doctest::Approx(1.5).epsilon(0.01));
}

TEST_CASE("a group that only moves is not distorted and one that swaps places is") {
  const std::vector<Vec2> before = {{0, 0}, {2, 0}, {0, 2}, {2, 2}};
  std::vector<Vec2> after;
  for (const Vec2 p : before) after.push_back(p + Vec2{7, -1});
  CHECK(distortion(before, after) < 1e-12);
  std::swap(after[0], after[1]);
  // Two people are 2 m off, two are not.
  CHECK(distortion(before, after) == doctest::Approx(std::sqrt(2.0)));
  CHECK(distortion({}, {}) == 0);
  CHECK(spread_of({}).longer == 0);
}
