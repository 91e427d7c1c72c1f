#include "crowd/measures/main_flow.h"

#include <doctest/doctest.h>

#include "crowd/measures/area_density.h"
#include "crowd/measures/test_recording.h"
#include "crowd/measures/velocity.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("the line lies across a corridor in the middle of the ways") {
  auto t = walkers(20, 120, 10, [](int p, double s) {
    const double y = 4 - 1.2 * (s - 0.3 * p);
    return y < -4 || y > 4 ? Vec2{kUnknown, 0} : Vec2{0.2 + 0.07 * p, y};
  });
  t.walkable = {{rectangle(0, -4, 1.8, 4), {}}};
  const Recording r(t);
  const auto v = velocities(r, {});
  const MainFlow flow = main_flow(r, v);
  CHECK(length(flow.axis - Vec2{0, -1}) < 1e-9);
  CHECK(flow.two_way == 0);
  CHECK(std::abs(flow.center.y) < 0.3);
  const MeasureLine line = cross_line(r, flow);
  CHECK(line.length() == doctest::Approx(1.8).epsilon(1e-9));
  CHECK(length(line.forward() - flow.axis) < 1e-9);
  CHECK(make_measure_area(box_around(line, 2), t.walkable).size == doctest::Approx(3.6).epsilon(1e-9));
  for (const Crossing& c : crossings(r, line)) CHECK(c.direction == 1);
}

TEST_CASE("without walls the line is as wide as people pass") {
  const auto t = walkers(5, 50, 10, [](int p, double s) { return Vec2{s, 1.0 * p}; });
  const Recording r(t);
  const MainFlow flow = main_flow(r, velocities(r, {}));
  CHECK(cross_line(r, flow).length() == doctest::Approx(4.4).epsilon(1e-9));
}

TEST_CASE("the minority of a two-way flow has its share") {
  const auto t = walkers(10, 100, 10, [](int p, double s) { return Vec2{p < 4 ? 5 - s : -5 + s, 0.05 * p}; });
  const Recording r(t);
  const MainFlow flow = main_flow(r, velocities(r, {}));
  CHECK(std::abs(flow.two_way - 0.4) < 0.05);
  CHECK(flow.axis.x > 0.99);
}
