#include "crowd/measures/presence.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("people who leave one after the other make a staircase") {
  // Person p is there until p + 1 seconds.
  const auto t = walkers(4, 60, 10, [](int p, double s) {
    return s <= p + 1 + 1e-9 ? Vec2{1.0 * p, s} : Vec2{kUnknown, 0};
  });
  const Presence n = presence(Recording(t));
  CHECK(n.most == 4);
  CHECK(n.people == 4);
  CHECK(n.remaining == 1);  // the file ends with the last one's last fix
  CHECK(n.evacuation == doctest::Approx(4).epsilon(1e-12));
  for (const Presence::Row& row : n.rows) {
    const int gone = row.seconds > 3.05 ? 3 : row.seconds > 2.05 ? 2 : row.seconds > 1.05 ? 1 : 0;
    CHECK(row.people == 4 - gone);
  }
}

TEST_CASE("an area is evacuated when the last one has left it") {
  const auto t = walkers(3, 101, 10, [](int p, double s) { return Vec2{s - p, 0.5}; });
  const MeasureArea area = make_measure_area(rectangle(-5, 0, 4.05, 1), {});
  const Presence n = presence(Recording(t), &area);
  CHECK(n.remaining == 0);
  CHECK(n.evacuation == doctest::Approx(6).epsilon(1e-12));
}
