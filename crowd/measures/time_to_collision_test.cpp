#include "crowd/measures/time_to_collision.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"
#include "crowd/measures/velocity.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("a head-on pair meets when the gap is closed") {
  // 10 m apart, radii 0.25 each, 1.3 + 1.1 m/s: (10 - 0.5) / 2.4 s.
  CHECK(std::abs(*time_to_collision({10, 0}, {-2.4, 0}, 0.5) - 9.5 / 2.4) < 1e-12);
  // Side by side by 0.3 m: the discs touch when the distance along is 0.4 m.
  CHECK(std::abs(*time_to_collision({5, 0.3}, {-1, 0}, 0.5) - 4.6) < 1e-12);
  CHECK(!time_to_collision({5, 0.51}, {-1, 0}, 0.5));
  CHECK(!time_to_collision({5, 0}, {1, 0}, 0.5));
  CHECK(!time_to_collision({5, 0}, {0, 0}, 0.5));
  CHECK(*time_to_collision({0.4, 0}, {1, 0}, 0.5) == 0);
  // Slow pairs keep their digits: 1 m at a micrometre per second.
  CHECK(std::abs(*time_to_collision({1.5, 0}, {-1e-6, 0}, 0.5) / 1e6 - 1) < 1e-9);
}

TEST_CASE("people in a recording have the time to collision of their discs") {
  const auto t = walkers(3, 21, 10, [](int p, double s) {
    return p == 0 ? Vec2{s, 0} : p == 1 ? Vec2{8 - s, 0} : Vec2{4, 3.0};
  });
  const Recording r(t);
  const auto v = velocities(r, {2, SpeedWindow::Ends::one_sided});
  const TimesToCollision ttc = times_to_collision(r, v, {0.2}, 10, 10);
  for (std::size_t i = 0; i < r.fix_count(); ++i) {
    if (r.fix(i).person == 2) {
      CHECK(ttc.soonest[i] == std::numeric_limits<float>::infinity());
    } else {
      CHECK(std::abs(ttc.soonest[i] - (7.6 - 2 * r.seconds(r.fix(i).frame)) / 2) < 1e-6);  // floats
    }
  }
  CHECK(ttc.pairs == 21);
  // 3.8 s in the first frame, 1.8 s in the last.
  std::size_t inside = 0;
  for (std::size_t k = 17; k <= 38; ++k) inside += ttc.histogram[k];
  CHECK(inside == 21);
}
