#include "crowd/measures/velocity.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("a steady walker has one velocity wherever there is a window") {
  const auto t = walkers(1, 21, 16, [](int, double s) { return Vec2{1.5 * s, -0.5 * s}; });
  const Recording r(t);
  for (const auto ends : {SpeedWindow::Ends::shrink, SpeedWindow::Ends::one_sided, SpeedWindow::Ends::exclude}) {
    const std::vector<Vec2> v = velocities(r, {5, ends});
    int unknown = 0;
    for (const Vec2 u : v) {
      if (!known(u)) {
        ++unknown;
        continue;
      }
      CHECK(length(u - Vec2{1.5, -0.5}) < 1e-12);
    }
    CHECK(unknown == (ends == SpeedWindow::Ends::exclude ? 10 : ends == SpeedWindow::Ends::shrink ? 2 : 0));
  }
}

TEST_CASE("the window is what the speed is averaged over") {
  // x = t²: (x(t + h) - x(t - h)) / 2h = 2t at any h.
  const auto t = walkers(1, 17, 16, [](int, double s) { return Vec2{s * s, 0}; });
  const Recording r(t);
  for (const int n : {1, 3, 8}) CHECK(velocities(r, {n})[8].x == doctest::Approx(1.0).epsilon(1e-12));
  // One-sided over n frames at the start: x(n/f) / (n/f) = n/f.
  CHECK(velocities(r, {4, SpeedWindow::Ends::one_sided})[0].x == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(window_frames({}, 16) == 5);
  CHECK(window_frames({}, 25) == 8);
  CHECK(window_frames({}, 1) == 1);
}

TEST_CASE("missing frames do not make anybody faster") {
  scene::Trajectories t;
  t.frame_rate = 10;
  for (const int frame : {0, 1, 2, 4, 5, 50, 51, 52}) t.fixes.push_back({frame, 7, 0.1 * frame, 0});
  const Recording r(t);
  const std::vector<Vec2> v = velocities(r, {2, SpeedWindow::Ends::one_sided});
  for (const Vec2 u : v) CHECK(u.x == doctest::Approx(1.0).epsilon(1e-9));
}

TEST_CASE("speed along a direction has a sign") {
  const std::vector<Vec2> v = {{3, 4}, {-1, 0}, {kUnknown, kUnknown}};
  CHECK(speeds(v)[0] == 5);
  CHECK(speeds(v, Vec2{1, 0})[1] == -1);
  CHECK(!known(speeds(v)[2]));
}
