#include "crowd/measures/crossings.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("people who follow each other every half second flow at two a second") {
  const auto t = walkers(11, 200, 16, [](int p, double s) { return Vec2{1.2 * (s - 0.5 * p) - 1.234, 0.3}; });
  const Recording r(t);
  const MeasureLine line{{0, 1}, {0, -1}};  // forward is +x
  CHECK(length(line.forward() - Vec2{1, 0}) < 1e-15);
  const std::vector<Crossing> c = crossings(r, line);
  REQUIRE(c.size() == 11);
  for (int p = 0; p < 11; ++p) {
    const Crossing& crossing = c[static_cast<std::size_t>(p)];
    CHECK(crossing.person == p);
    CHECK(crossing.direction == 1);
    CHECK(crossing.seconds == doctest::Approx(1.234 / 1.2 + 0.5 * p).epsilon(1e-12));
    CHECK(crossing.speed == doctest::Approx(1.2).epsilon(1e-9));
    CHECK(std::abs(crossing.at.y - 0.3) < 1e-12);
  }
  const Flow f = flow(c, line.length());
  CHECK(f.forward == 11);
  CHECK(f.backward == 0);
  CHECK(f.flow == doctest::Approx(2).epsilon(1e-12));
  CHECK(f.specific == doctest::Approx(1).epsilon(1e-12));
  CHECK(f.headways.size() == 10);
  for (const double h : f.headways) CHECK(h == doctest::Approx(0.5).epsilon(1e-9));
  const std::vector<Vec2> steps = flow_over_time(f, 1.25);
  double people = 0;
  for (const Vec2 step : steps) people += step.y * 1.25;
  CHECK(people == doctest::Approx(11).epsilon(1e-12));
}

TEST_CASE("touching a line is not crossing it and passing its end is not either") {
  const MeasureLine line{{0, -1}, {0, 1}};  // forward is -x, the left
  const auto touch = walkers(1, 5, 1, [](int, double s) { return Vec2{std::abs(s - 2) - 0.0 + 0.0 * s, 0}; });
  CHECK(crossings(Recording(touch), line).size() == 2);  // onto the line is left of it, and back again
  const auto near = walkers(1, 5, 1, [](int, double s) { return Vec2{std::abs(s - 2) + 1e-9, 0}; });
  CHECK(crossings(Recording(near), line).empty());
  const auto past = walkers(1, 5, 1, [](int, double s) { return Vec2{s - 2.5, 1.001}; });
  CHECK(crossings(Recording(past), line).empty());
  const auto left = walkers(1, 5, 1, [](int, double s) { return Vec2{-std::abs(s - 2), 0}; });
  CHECK(crossings(Recording(left), line).empty());
}

TEST_CASE("who comes back counts once in the flow and twice among the crossings") {
  const auto t = walkers(2, 41, 10, [](int p, double s) {
    return p == 0 ? Vec2{s < 2 ? s - 1.05 : 2.95 - s, 0} : Vec2{1.5 - s, 0.5};
  });
  const Recording r(t);
  const MeasureLine line{{0, 1}, {0, -1}};
  const std::vector<Crossing> c = crossings(r, line);
  CHECK(c.size() == 3);
  const Flow f = flow(c, 2);
  CHECK(f.forward == 1);
  CHECK(f.backward == 1);
}

TEST_CASE("a gap in a track is not bridged") {
  scene::Trajectories t;
  t.frame_rate = 10;
  t.fixes = {{0, 1, -1, 0}, {50, 1, 1, 0}};
  CHECK(crossings(Recording(t), {{0, 1}, {0, -1}}).empty());
  CHECK(crossings(Recording(t), {{0, 1}, {0, -1}}, 10).size() == 1);
}

TEST_CASE("a run is steady while the middle three fifths cross") {
  Flow f;
  for (int k = 0; k < 19; ++k) f.times.push_back(k);
  CHECK(!steady_span(f));
  f.times.push_back(19);
  CHECK(steady_span(f) == std::pair(4.0, 16.0));
}
