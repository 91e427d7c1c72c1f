#include "crowd/measures/wall_contacts.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("walls are touched from inside and left behind outside") {
  // From the middle of a room 4 m wide through its wall at x = 4: with r = 0.25, at 1 m/s.
  auto t = walkers(1, 31, 10, [](int, double s) { return Vec2{2 + s, 1}; });
  t.walkable = {{rectangle(0, 0, 4, 2), {}}};
  const WallContacts w = wall_contacts(Recording(t), {0.25});
  CHECK(w.people == 1);
  CHECK(w.outside == 10);   // x = 4.1 … 5
  CHECK(w.touching == 13);  // from x = 3.8 on
  CHECK(w.worst == doctest::Approx(1.25).epsilon(1e-6));
  CHECK(w.worst_seconds == doctest::Approx(3));
}

TEST_CASE("a hole is a wall and a border between two floors is none") {
  auto t = walkers(1, 1, 10, [](int, double) { return Vec2{1, 1}; });
  t.walkable = {{rectangle(0, 0, 2, 2), {rectangle(0.8, 0.8, 1.2, 1.2)}}};
  CHECK(wall_contacts(Recording(t), {0.1}).worst == doctest::Approx(0.3).epsilon(1e-6));
  t.walkable = {{rectangle(0, 0, 1, 2), {}}, {rectangle(1, 0, 2, 2), {}}};
  CHECK(wall_contacts(Recording(t), {0.5}).touching == 0);
}

TEST_CASE("nothing is touched where no walls are known") {
  const auto t = walkers(1, 2, 10, [](int, double) { return Vec2{1, 1}; });
  CHECK(wall_contacts(Recording(t), {0.5}).touching == 0);
}
