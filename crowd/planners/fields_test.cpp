#include "crowd/planners/fields.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/planners/test_world.h"
#include "crowd/planners/ways.h"

using namespace inhabit::crowd;

namespace {

constexpr double kBody = 0.25;
constexpr float kInfinite = std::numeric_limits<float>::infinity();

Fields field_of(const World& world, const Place& place, double body = kBody) { return {world, {{&place}}, body, 1}; }

/// Two rooms, 4 m wide each, with a passage of this width through the wall between them.
Ring two_rooms(double width) {
  return {{-4, -3}, {-0.2, -3}, {-0.2, -width / 2}, {0.2, -width / 2}, {0.2, -3}, {4, -3},
          {4, 3},   {0.2, 3},   {0.2, width / 2},   {-0.2, width / 2}, {-0.2, 3}, {-4, 3}};
}

/// A hall with boxes standing about in it.
World hall(std::uint64_t seed) {
  inhabit::core::Rng rng(seed);
  std::vector<Ring> boxes;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      Ring ring = turned(box_ring(-1.2, -0.6, 1.2, 0.5), rng.uniform(0, 6));
      for (Vec2& p : ring) p += Vec2{2.5 + 5 * column + rng.uniform(-0.6, 0.6), 2.5 + 5 * row + rng.uniform(-0.6, 0.6)};
      boxes.push_back(ring);
    }
  return test_world({make_floor(box_ring(0, 0, 20, 20), boxes)});
}

double room_at(const World& world, Vec2 p) {
  double room = 1e300;
  for (const WallSegment& s : world.walls.segments())
    room = std::min(room, length(p - nearest_on_segment({s.ax, s.ay}, {s.bx, s.by}, p)));
  return room;
}

}  // namespace

TEST_CASE("passages are open for fields just when a body fits whatever their angle") {
  inhabit::core::Rng rng(3);
  for (int trial = 0; trial < 40; ++trial) {
    const double angle = trial == 0 ? 0 : rng.uniform(0, 2 * inhabit::core::kPi);
    const Place place(area_goal(turned(box_ring(2, -2, 3, 2), angle)), {});
    for (const double width : {0.45, 0.5, 0.55, 0.9}) {
      const World world = test_world({make_floor(turned(two_rooms(width), angle), {})});
      const Fields fields = field_of(world, place);
      const Vec2 start = rotate({-3, 0}, direction(angle));
      const double d = fields.distance(0, static_cast<float>(start.x), static_cast<float>(start.y));
      CAPTURE(angle);
      CAPTURE(width);
      if (width < 2 * kBody) {
        CHECK(d == kInfinite);
      } else {
        CHECK(d == doctest::Approx(5).epsilon(0.02));
      }
    }
  }
}

TEST_CASE("distances along a field are those of the shortest ways within the grid's error") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const World world = hall(seed);
    const Place place(area_goal(box_ring(18.5, 9, 19.7, 11)), {});
    const Fields fields = field_of(world, place);
    const Corners corners(world, (1 - kSqueeze) * kBody, kBody, 1);
    const Ways ways(corners, {&place});
    inhabit::core::Rng rng(seed);
    int asked = 0, longer = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec2 p{rng.uniform(0, 20), rng.uniform(0, 20)};
      if (!corners.on_floor(p) || room_at(world, p) < kBody) continue;
      const double exact = ways.choose(p).length;
      const double d = fields.distance(0, static_cast<float>(p.x), static_cast<float>(p.y));
      // Never shorter but for the cells' size; longer where the field keeps away from walls, and where it prefers a way
      // that keeps away from them more.
      CHECK(d > exact - 0.15);
      CHECK(d < 1.25 * exact + 0.3);
      ++asked, longer += d > 1.02 * exact + 0.25 ? 1 : 0;
    }
    CHECK(longer * 20 < asked);
  }
}

TEST_CASE("away from walls a field points along the shortest way") {
  const World world = test_world({make_floor(box_ring(-10, -10, 10, 10), {box_ring(-1, -1, 1, 1)})});
  const Place place(area_goal(box_ring(7, -0.2, 8, 0.2)), {});
  const Fields fields = field_of(world, place);
  inhabit::core::Rng rng(5);
  double worst = 1;
  int asked = 0;
  while (asked < 500) {
    const Vec2 p{rng.uniform(-2, 6.5), rng.uniform(1.5, 9)};  // in sight of the goal, above the pillar
    if (cross(Vec2{7, 0.2} - p, Vec2{1.6, 1.6} - p) > 0) continue;
    ++asked;
    const Region::Way way = fields.way(0, static_cast<float>(p.x), static_cast<float>(p.y));
    CHECK(std::hypot(way.x, way.y) == doctest::Approx(1).epsilon(1e-5));
    worst = std::min(worst, dot({way.x, way.y}, unit(Vec2{std::max(p.x, 7.0), 0.2} - p)));
  }
  CHECK(worst > std::cos(inhabit::core::radians(3)));
}

TEST_CASE("who was pushed against or into a wall is led out and on") {
  const World world = hall(4);
  const Place place(area_goal(box_ring(18.5, 9, 19.7, 11)), {});
  const Fields fields = field_of(world, place);
  const Walkable& w = fields.walkable();
  inhabit::core::Rng rng(6);
  int asked = 0;
  while (asked < 300) {
    Vec2 p{rng.uniform(0, 20), rng.uniform(0, 20)};
    const double room = room_at(world, p);
    const bool inside = !world.walls.on_floor(static_cast<float>(p.x), static_cast<float>(p.y));
    if (room > (inside ? 0.3 : kBody)) continue;
    ++asked;
    CAPTURE(p.x);
    CAPTURE(p.y);
    // Two steps of a body's radius are plenty to be where a body can be: the way out is a radius and a wall's 0.3 m.
    double walked = 0;
    const auto open = [&] {
      const auto c = static_cast<std::int32_t>((p.x - w.lattice.origin.x) / w.lattice.cell);
      const auto r = static_cast<std::int32_t>((p.y - w.lattice.origin.y) / w.lattice.cell);
      return w.cost[w.lattice.at(c, r)] < Walkable::kClosed;
    };
    while (!open() && walked < 2) {
      const Region::Way way = fields.way(0, static_cast<float>(p.x), static_cast<float>(p.y));
      CHECK(std::hypot(way.x, way.y) == doctest::Approx(1).epsilon(1e-4));
      p += 0.02 * Vec2{way.x, way.y}, walked += 0.02;
    }
    CHECK(walked < (inside ? 1.2 : 0.7));
  }
}

TEST_CASE("a field ends at what no way leads to and says so") {
  const Ring left = box_ring(-4, -3, -0.03, 3), right = box_ring(0.03, -3, 4, 3);  // a thin wall, no door
  const World world = test_world({make_floor(left, {}), make_floor(right, {})});
  const Place place(area_goal(box_ring(2, -2, 3, 2)), {});
  const Fields fields = field_of(world, place);
  for (const float x : {-3.9f, -2.0f, -0.3f, -0.1f}) {
    CHECK(fields.distance(0, x, 1.0f) == kInfinite);
    const Region::Way way = fields.way(0, x, 1.0f);
    CHECK(way.x == 0);
    CHECK(way.y == 0);
  }
  CHECK(fields.distance(0, 0.1f, 0.0f) == doctest::Approx(1.9).epsilon(0.05));
}

TEST_CASE("a goal along a wall where no middle of a body gets is headed for all the same") {
  const World world = test_world({make_floor(two_rooms(1.2), {})});
  const Place place(area_goal(box_ring(3.9, -3, 4, 3)), {});
  const Fields fields = field_of(world, place);
  CHECK(fields.distance(0, -3, 0) == doctest::Approx(6.9).epsilon(0.02));
  CHECK(fields.way(0, 3.7f, 0.5f).x > 0.9f);
}

TEST_CASE("looking up many at once is looking up each to the last bit") {
  const World world = hall(8);
  const Place a(area_goal(box_ring(18.5, 9, 19.7, 11)), {}), b(area_goal(box_ring(0.3, 0.3, 1, 1)), {});
  const Fields fields(world, {{&a}, {&b}, {&a, &b}}, kBody, 2);
  REQUIRE(fields.count() == 3);
  inhabit::core::Rng rng(9);
  std::vector<std::uint32_t> field;
  std::vector<float> x, y, speed;
  for (int k = 0; k < 1003; ++k) {
    field.push_back(k % 5 == 4 ? Fields::kNone : rng.index(3));
    x.push_back(static_cast<float>(rng.uniform(-2, 22))), y.push_back(static_cast<float>(rng.uniform(-2, 22)));
    speed.push_back(static_cast<float>(rng.uniform(0.5, 2)));
  }
  std::vector<float> wish_x(x.size(), 7), wish_y(x.size(), 7);
  fields.look_up(field, x, y, speed, wish_x, wish_y);
  std::vector<float> scalar_x(x.size(), 7), scalar_y(x.size(), 7);
  fields_kernel::Lookup l = fields.lookup();
  l.field = field.data(), l.x = x.data(), l.y = y.data(), l.speed = speed.data();
  l.wish_x = scalar_x.data(), l.wish_y = scalar_y.data();
  fields_kernel::look_up_scalar(l, 0, x.size());
  CHECK(wish_x == scalar_x);
  CHECK(wish_y == scalar_y);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (field[k] == Fields::kNone) {
      CHECK(wish_x[k] == 7);
      CHECK(wish_y[k] == 7);
      continue;
    }
    const Region::Way way = fields.way(field[k], x[k], y[k]);
    CHECK(std::hypot(wish_x[k] - speed[k] * way.x, wish_y[k] - speed[k] * way.y) < 1e-5);
  }
}
