#include "crowd/measures/path_length.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("a straight way is its own shortest and a corner costs the root of two") {
  const auto t = walkers(2, 81, 20, [](int p, double s) {
    if (p == 0) return Vec2{1.5 * s, 0};
    return s < 2 ? Vec2{s, 0} : Vec2{2, s - 2};
  });
  const std::vector<PathRow> rows = path_lengths(Recording(t));
  CHECK(rows[0].length == doctest::Approx(6).epsilon(1e-12));
  CHECK(rows[0].detour() == doctest::Approx(1).epsilon(1e-12));
  CHECK(rows[1].length == doctest::Approx(4).epsilon(1e-12));
  CHECK(rows[1].detour() == doctest::Approx(std::sqrt(2.0)).epsilon(1e-12));
  const auto round_corner = [](Vec2 a, Vec2 b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); };
  CHECK(path_lengths(Recording(t), round_corner)[1].detour() == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("effort is that of the formula and least at the best speed") {
  const auto at_speed = [](double v) {
    const auto t = walkers(1, 101, 10, [v](int, double s) { return Vec2{v * s, 0}; });
    return path_lengths(Recording(t))[0];
  };
  // 10 s at 1 m/s: 10 (2.23 + 1.26) J/kg.
  CHECK(at_speed(1).effort == doctest::Approx(34.9).epsilon(1e-12));
  CHECK(at_speed(std::sqrt(2.23 / 1.26)).effort_ratio() == doctest::Approx(1).epsilon(1e-12));
  CHECK(at_speed(1).effort_ratio() > 1.03);
  CHECK(at_speed(2).effort_ratio() > 1.03);
  // Standing: 22.3 J/kg for nothing.
  CHECK(at_speed(0).effort == doctest::Approx(22.3).epsilon(1e-12));
  CHECK(!known(at_speed(0).effort_ratio()));
}

TEST_CASE("one fix is no way") {
  const auto t = walkers(1, 1, 10, [](int, double) { return Vec2{}; });
  CHECK(path_lengths(Recording(t)).empty());
}
