#include "crowd/planners/ways.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/planners/test_world.h"

using namespace inhabit::crowd;

namespace {

struct Map {
  World world;
  Corners corners;
  Place place;
  Ways ways;

  Map(std::vector<Floor> floors, const Ring& goal, double body, double clearance, Vec2 origin = {})
      : world(test_world(std::move(floors), origin)),
        corners(world, body, clearance, 1),
        place(area_goal(goal), origin),
        ways(corners, {&place}) {}
  double distance(Vec2 p) const { return ways.choose(p).length; }
};

constexpr double kEps = 1e-9;

}  // namespace

TEST_CASE("the shortest way round one corner is a tangent and an arc and the perpendicular to the goal") {
  for (const double r : {0.2, 0.5, 0.9}) {
    // The corner at the origin sticks into the floor from the lower right.
    const Ring outline = {{-10, -10}, {0, -10}, {0, 0}, {10, 0}, {10, 10}, {-10, 10}};
    const Map map({make_floor(outline, {})}, box_ring(8, 0, 9, 10), 0.1, r);
    REQUIRE(map.corners.all().size() == 1);
    CHECK(map.corners.all()[0].radius == r);
    for (const Vec2 p : {Vec2{-2, -8}, Vec2{-1, -1}, Vec2{-6, -3}}) {
      const double d = length(p), heading = angle_of(-p) + std::asin(r / d);
      CHECK(map.distance(p) == doctest::Approx(std::sqrt(d * d - r * r) + r * heading + 8).epsilon(kEps));
    }
    // From above the corner the goal is in sight.
    CHECK(map.distance({-3, 4}) == doctest::Approx(11).epsilon(kEps));
    CHECK(map.distance({2, r + 0.001}) == doctest::Approx(6).epsilon(kEps));
  }
}

TEST_CASE("the shortest way round a square pillar has two arcs and the nearer side wins") {
  const double r = 0.3;
  const Vec2 origin{1000, -2000};  // far from the scene's zero
  const auto at = [&](Ring ring) {
    for (Vec2& p : ring) p += origin;
    return ring;
  };
  const Map map({make_floor(at(box_ring(-10, -10, 10, 10)), {at(box_ring(-1, -1, 1, 1))})},
                at(box_ring(5, -0.2, 6, 0.2)), 0.2, r, origin);
  REQUIRE(map.corners.all().size() == 4);
  const auto length_over = [&](Vec2 p) {  // over the top: past (-1, 1) and (1, 1), down to the corner (5, 0.2)
    const Vec2 to = Vec2{-1, 1} - p, from = Vec2{5, 0.2} - Vec2{1, 1};
    const double d = length(to), e = length(from);
    const double up = angle_of(to) + std::asin(r / d), down = -angle_of(from) + std::asin(r / e);
    return std::sqrt(d * d - r * r) + r * up + 2 + r * down + std::sqrt(e * e - r * r);
  };
  CHECK(map.distance({-5, 0.1}) == doctest::Approx(length_over({-5, 0.1})).epsilon(kEps));
  CHECK(map.distance({-3, 0.8}) == doctest::Approx(length_over({-3, 0.8})).epsilon(kEps));
  // The mirror image is as long, and the middle as long both ways.
  CHECK(map.distance({-5, -0.1}) == doctest::Approx(map.distance({-5, 0.1})).epsilon(kEps));
  CHECK(map.distance({-5, 0.1}) < map.distance({-5, 0}));
  // Past the pillar the way is straight.
  CHECK(map.distance({-5, 4}) == doctest::Approx(length(Vec2{10, 3.8})).epsilon(kEps));
}

TEST_CASE("a disc rolls round a pillar of many corners as round a circle") {
  Ring pillar;
  const int n = 64;
  for (int k = 0; k < n; ++k) pillar.push_back(2.0 * direction(2 * inhabit::core::kPi * (k + 0.5) / n));
  const double r = 0.3;
  const Map map({make_floor(box_ring(-10, -10, 10, 10), {pillar})}, box_ring(8, -0.001, 8.5, 0.001), 0.2, r);
  const double R = 2 + r;
  const double exact = 2 * std::sqrt(64 - R * R) + R * (inhabit::core::kPi - 2 * std::acos(R / 8));
  // The polygon lies within 2 (1 - cos(pi / 64)) = 2.4 mm of the circle.
  CHECK(map.distance({-8, 0}) == doctest::Approx(exact).epsilon(0.002));
}

TEST_CASE("passages are open for bodies that fit and their corners give way to the middle") {
  const double body = 0.25;
  for (const double width : {0.4, 0.49, 0.51, 0.7, 3.0}) {
    const Ring wall_low = box_ring(-0.1, -5, 0.1, -width / 2), wall_high = box_ring(-0.1, width / 2, 0.1, 5);
    const Ring outline = {{-5, -5}, {-0.1, -5}, {-0.1, -width / 2}, {0.1, -width / 2}, {0.1, -5}, {5, -5},
                          {5, 5},   {0.1, 5},   {0.1, width / 2},   {-0.1, width / 2}, {-0.1, 5}, {-5, 5}};
    const Map map({make_floor(outline, {})}, box_ring(4, -5, 5, 5), body, 0.4);
    REQUIRE(map.corners.all().size() == 4);
    const double d = map.distance({-4, 0});
    if (width < 2 * body) {
      CHECK(d == std::numeric_limits<double>::infinity());
    } else {
      CHECK(d == doctest::Approx(8).epsilon(kEps));
      for (const Corner& c : map.corners.all()) CHECK(c.radius <= std::max(body, width / 2));
      CHECK(map.distance({-4, -4}) < length(Vec2{4, 4}) + 4.5);
    }
  }
}

TEST_CASE("what is walked along shortest ways is as long as they say") {
  inhabit::core::Rng rng(7);
  std::vector<Ring> boxes;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const Vec2 middle{2.5 + 5 * column + rng.uniform(-0.8, 0.8), 2.5 + 5 * row + rng.uniform(-0.8, 0.8)};
      Ring ring = turned(box_ring(-1.2, -rng.uniform(0.3, 1), 1.2, 0.5), rng.uniform(0, 6));
      for (Vec2& p : ring) p += middle;
      boxes.push_back(ring);
    }
  const Map map({make_floor(box_ring(0, 0, 20, 20), boxes)}, box_ring(18, 9, 19.5, 11), 0.2, 0.25);
  int walks = 0;
  while (walks < 60) {
    Vec2 p{rng.uniform(0.3, 19.7), rng.uniform(0.3, 19.7)};
    double room = 1e300;
    for (const Ring& ring : boxes) room = std::min(room, nearest_on_ring(ring, p).distance);
    if (!map.corners.on_floor(p) || room < 0.26) continue;
    ++walks;
    const double expected = map.distance(p);
    CHECK(expected >= length(Vec2{std::clamp(p.x, 18.0, 19.5), std::clamp(p.y, 9.0, 11.0)} - p) - 1e-9);
    if (p.x >= 18 && p.x <= 19.5 && p.y >= 9 && p.y <= 11) continue;
    std::uint32_t target = map.ways.choose(p).target;
    double walked = 0, closest = 1e300;
    while (walked < 1.1 * expected) {
      Ways::Step step = map.ways.step(p, target, false);
      if (step.target == Ways::kNone || (step.target != target && !map.ways.in_sight(p, step.target, step.towards)))
        step = map.ways.step(p, map.ways.choose(p).target, true);
      target = step.target;
      if (length(step.towards - p) < 0.01 && target >= map.corners.nodes()) break;
      p += 0.01 * step.direction, walked += 0.01;
      for (const Ring& ring : boxes) closest = std::min(closest, nearest_on_ring(ring, p).distance);
    }
    // A centimetre is left, and each step off an arc of 0.25 m is longer by its square over twice the radius.
    CHECK(walked == doctest::Approx(expected).epsilon(0.01));
    CHECK(walked > expected - 0.03);
    CHECK(closest > 0.2 - 1e-6);  // a body's; corners that are near each other have no room for more
  }
}

TEST_CASE("a goal behind walls without a door is infinitely far") {
  const Map map({make_floor(box_ring(0, 0, 5, 5), {}), make_floor(box_ring(6, 0, 10, 5), {})}, box_ring(8, 1, 9, 2),
                0.2, 0.3);
  CHECK(map.distance({1, 1}) == std::numeric_limits<double>::infinity());
  CHECK(map.distance({7, 1.5}) == doctest::Approx(1));
}
