#include "crowd/measures/arches.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

/// An opening 2 m wide at x = 0, the crowd at x < 0.
const Opening kOpening{{0, -1}, {0, 1}};

/// `count` people of radius 0.25 side by side on a half circle from wall to wall, the first and last touching the wall.
std::vector<Standing> half_ring(double radius, int count, double speed = 0.1) {
  std::vector<Standing> people;
  const double first = std::asin(0.25 / radius);
  for (int k = 0; k < count; ++k) {
    const double angle = first + (kPi - 2 * first) * k / (count - 1);
    people.push_back({{-radius * std::sin(angle), -radius * std::cos(angle)}, 0.25, speed});
  }
  return people;
}

/// As many as touch each other: the chord of each step is a diameter or less.
int enough(double radius) {
  return 1 + static_cast<int>(std::ceil((kPi - 2 * std::asin(0.25 / radius)) / (2 * std::asin(0.25 / radius))));
}

}  // namespace

TEST_CASE("a half ring of people who stand and touch is an arch of all of them") {
  const std::vector<Standing> ring = half_ring(2, enough(2));
  const auto arch = innermost_arch(ring, kOpening);
  REQUIRE(arch.has_value());
  CHECK(arch->people.size() == ring.size());
  CHECK(arch->people.front() == 0);
  CHECK(arch->people.back() == ring.size() - 1);
  CHECK(arch->speed == doctest::Approx(0.1));
  // The first ring of 1 m thickness that holds people at 2 m: they must be nearer than its outer border.
  CHECK(arch->radius == doctest::Approx(1.25));
}

TEST_CASE("an arch with a gap or with a link that walks is none") {
  std::vector<Standing> ring = half_ring(2, enough(2));
  const std::size_t keystone = ring.size() / 2;
  ring[keystone].speed = 1;
  CHECK_FALSE(innermost_arch(ring, kOpening).has_value());
  ring[keystone].speed = 0.1;
  CHECK(innermost_arch(ring, kOpening).has_value());
  ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(keystone));
  CHECK_FALSE(innermost_arch(ring, kOpening).has_value());
}

TEST_CASE("an arch must stand on the wall at both of its ends") {
  std::vector<Standing> ring = half_ring(2, enough(2));
  ring.erase(ring.begin());
  CHECK_FALSE(innermost_arch(ring, kOpening).has_value());
}

TEST_CASE("a straight row across the opening is no arch and neither are people behind it") {
  std::vector<Standing> row;
  for (double y = -3; y <= 3; y += 0.5) row.push_back({{-0.25, y}, 0.25, 0});
  CHECK_FALSE(innermost_arch(row, kOpening).has_value());
  std::vector<Standing> behind = half_ring(2, enough(2));
  for (Standing& s : behind) s.at.x = -s.at.x;
  CHECK_FALSE(innermost_arch(behind, kOpening).has_value());
}

TEST_CASE("of two arches the inner one counts") {
  std::vector<Standing> rings = half_ring(4, enough(4)), inner = half_ring(2, enough(2), 0.3);
  CHECK(innermost_arch(rings, kOpening)->speed == doctest::Approx(0.1));
  rings.insert(rings.end(), inner.begin(), inner.end());
  CHECK(innermost_arch(rings, kOpening)->speed == doctest::Approx(0.3));
}
