#include "crowd/measures/area_density.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"
#include "crowd/measures/velocity.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("classic density is heads over square metres") {
  // Four people a metre apart walk at 1 m/s past an area 2 m long and 1.5 m wide: two of them are in it at any time.
  const auto t = walkers(10, 20, 10, [](int p, double s) { return Vec2{-p + s + 0.35, 0.75}; });
  const Recording r(t);
  const MeasureArea area = make_measure_area(rectangle(-4, 0, -2, 1.5), {});
  const std::vector<double> speed = speeds(velocities(r, {2, SpeedWindow::Ends::one_sided}));
  for (const AreaRow& row : classic_density(r, area, speed)) {
    CHECK(row.people == 2);
    CHECK(row.density == doctest::Approx(2 / 3.0).epsilon(1e-12));
    CHECK(row.speed == doctest::Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("an area that reaches into a wall has only its walkable part") {
  const std::vector<Area> room = {{rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2)}}};
  CHECK(make_measure_area(rectangle(-1, 0, 3, 2), room).size == doctest::Approx(5).epsilon(1e-12));
  CHECK(make_measure_area(rectangle(5, 5, 6, 6), room).size == 0);
  const Ring arrow = {{0, 0}, {2, 0}, {2, 2}, {1, 1}};  // not convex
  CHECK(make_measure_area(arrow, {}).size == doctest::Approx(2).epsilon(1e-12));
  CHECK(make_measure_area(arrow, {}).overlap({rectangle(-1, -1, 5, 5), {rectangle(1.5, 0.2, 2.5, 0.4)}}) ==
        doctest::Approx(1.9).epsilon(1e-12));
}

TEST_CASE("nobody there has no speed and no density") {
  const auto t = walkers(1, 3, 10, [](int, double s) { return Vec2{s, 0}; });
  const Recording r(t);
  const std::vector<double> speed(3, 1.0);
  const AreaRow row = classic_density(r, make_measure_area(rectangle(5, 5, 6, 6), {}), speed)[1];
  CHECK(row.people == 0);
  CHECK(row.density == 0);
  CHECK(!known(row.speed));
}
