#include "crowd/measures/voronoi_density.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("the Voronoi density of a square lattice is one over its spacing squared") {
  constexpr double a = 0.45;
  const auto t = walkers(100, 3, 10, [](int p, double s) { return Vec2{a * (p % 10) + s, a * (p / 10)}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(-20, -20, 20, 20), {}}});
  const std::vector<double> speed(t.fixes.size(), 1.0);
  // Anywhere well inside, whatever the area's place and shape.
  for (const Ring& ring : {rectangle(1.07, 1.11, 2.9, 3.03), Ring{{1.2, 1.2}, {3, 1.4}, {2.2, 2.9}}}) {
    const VoronoiDensity v = voronoi_density(r, ground, make_measure_area(ring, ground.walkable()), speed);
    for (const AreaRow& row : v.rows) {
      CHECK(row.density == doctest::Approx(1 / (a * a)).epsilon(1e-10));
      CHECK(row.speed == doctest::Approx(1).epsilon(1e-12));
    }
  }
  CHECK(individual_density(r, ground)[45] == doctest::Approx(1 / (a * a)).epsilon(1e-10));
}

TEST_CASE("a whole room has as many people as stand in it") {
  Rng rng(3);
  std::vector<Vec2> at;
  for (int i = 0; i < 50; ++i) at.push_back({rng.uniform(0, 6), rng.uniform(0, 4)});
  const auto t = walkers(50, 1, 10, [&](int p, double) { return at[static_cast<std::size_t>(p)]; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 6, 4), {}}});
  const std::vector<double> speed(50, 0.5);
  const auto v = voronoi_density(r, ground, make_measure_area(rectangle(-1, -1, 7, 5), ground.walkable()), speed);
  CHECK(v.rows[0].density == doctest::Approx(50 / 24.0).epsilon(1e-10));
  CHECK(v.rows[0].people == 50);
  CHECK(v.off_ground == 0);
}

TEST_CASE("speeds are weighed by the ground that people hold") {
  // Two people in a strip, the first cell is 1 m long, the second 3 m; the area is all of it.
  const auto t = walkers(2, 1, 10, [](int p, double) { return Vec2{p == 0 ? 0.5 : 1.5, 0.5}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 4, 1), {}}});
  const MeasureArea area = make_measure_area(rectangle(0, 0, 4, 1), ground.walkable());
  const std::vector<double> speed = {2.0, 1.0};
  const AreaRow row = voronoi_density(r, ground, area, speed).rows[0];
  CHECK(row.speed == doctest::Approx(1.25).epsilon(1e-12));
  CHECK(row.density == doctest::Approx(0.5).epsilon(1e-12));
  const std::vector<double> half_known = {kUnknown, 1.0};
  CHECK(voronoi_density(r, ground, area, half_known).rows[0].speed == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("with a cut-off empty ground holds nobody") {
  const auto t = walkers(1, 1, 10, [](int, double) { return Vec2{5, 5}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 10, 10), {}}}, 1);
  const std::vector<double> speed = {1.2};
  const AreaRow row =
      voronoi_density(r, ground, make_measure_area(rectangle(0, 0, 10, 10), ground.walkable()), speed).rows[0];
  CHECK(row.density == doctest::Approx(0.01).epsilon(1e-12));
  CHECK(row.speed == doctest::Approx(1.2).epsilon(1e-12));
  CHECK(individual_density(r, ground)[0] == doctest::Approx(1 / 3.14159265358979).epsilon(1e-9));
}

TEST_CASE("threads change no byte of a Voronoi density") {
  Rng rng(5);
  const auto t = walkers(40, 300, 10, [&](int, double) { return Vec2{rng.uniform(0, 6), rng.uniform(0, 4)}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 6, 4), {rectangle(2, 1, 3, 2)}}});
  const std::vector<double> speed(t.fixes.size(), 1.0);
  const MeasureArea area = make_measure_area(rectangle(1, 0, 3, 4), ground.walkable());
  const auto one = voronoi_density(r, ground, area, speed, 1), four = voronoi_density(r, ground, area, speed, 4);
  CHECK(one.off_ground > 0);
  for (std::size_t k = 0; k < one.rows.size(); ++k) {
    CHECK(one.rows[k].density == four.rows[k].density);
    CHECK((one.rows[k].speed == four.rows[k].speed || !known(one.rows[k].speed)));
  }
}
