#include "layout/constraints/wall.h"

#include <doctest/doctest.h>

#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// An object 1 m deep at `p` in a room of 10 x 10 m (walls 0 front, 1 right, 2 back, 3 left).
struct AtWall {
  World w;
  WallDistanceTerm d;
  WallOrientationTerm o;
  AtWall(Vec2 p, double angle, double half_depth = 0.5) {
    d.a = o.a = w.add(p, angle);
    d.half_depth = o.half_depth = half_depth;
  }
  Vec2 end() const { return projected(d, w.x).position(d.a); }
  double heading() const { return projected(o, w.x).angle(o.a); }
};

}  // namespace

TEST_CASE("wall distance: the back face's centre goes to the nearest wall") {
  AtWall s({5, 2}, kPi / 2);
  CHECK(std::abs(error(s.d, s.w.x) - 1.5) < 1e-14);
  CHECK(distance(s.end(), {5, 0.5}) < 1e-14);
  s.d.distance = 0.2;
  CHECK(distance(s.end(), {5, 0.7}) < 1e-14);
  CHECK(distance(projected(s.d, s.w.x, 0.5).position(s.d.a), {5, 1.35}) < 1e-14);
  s.d.distance = 2;
  CHECK(distance(s.end(), {5, 2.5}) < 1e-14);
}

TEST_CASE("wall distance: a named wall wins over a nearer one") {
  AtWall s({5, 2}, kPi / 2);
  s.d.wall = 1;
  CHECK(std::abs(error(s.d, s.w.x) - 5) < 1e-14);
  CHECK(distance(s.end(), {10, 2}) < 1e-14);
}

TEST_CASE("wall distance: of walls that are equally near the first one counts") {
  CHECK(distance(AtWall({5, 5}, 0, 0).end(), {5, 0}) < 1e-14);
  CHECK(distance(AtWall({9, 9}, 0, 0).end(), {10, 9}) < 1e-14);
}

TEST_CASE("wall distance: outside the room it counts as negative and draws the object in") {
  AtWall s({5, -1}, kPi / 2);
  CHECK(std::abs(error(s.d, s.w.x) + 1.5) < 1e-14);
  CHECK(distance(s.end(), {5, 0.5}) < 1e-14);
  s.d.distance = 0.25;
  CHECK(distance(s.end(), {5, 0.75}) < 1e-14);
}

TEST_CASE("wall distance: exactly on the wall the normal shows the way in") {
  AtWall s({5, 0}, 0, 0);
  CHECK(s.end() == Vec2{5, 0});
  s.d.distance = 1;
  CHECK(distance(s.end(), {5, 1}) < 1e-14);
}

TEST_CASE("wall distance: in a room that is not convex the nearest wall is the nearest piece of it") {
  World w(l_shape());
  WallDistanceTerm c;
  c.a = w.add({3, 1.75});
  CHECK(distance(projected(c, w.x).position(c.a), {3, 2}) < 1e-14);
}

TEST_CASE("wall orientation: the back turns to the nearest wall") {
  CHECK(std::abs(AtWall({5, 1}, 0, 0).heading() - kPi / 2) < 1e-15);
  CHECK(std::abs(AtWall({9, 5}, 0.5, 0).heading() - kPi) < 1e-15);
  CHECK(std::abs(AtWall({1, 5}, 0.5, 0).heading()) < 1e-15);
  AtWall s({5, 1}, 0, 0);
  s.o.angle = -kPi / 2;
  CHECK(std::abs(s.heading()) < 1e-15);
  CHECK(error(s.o, s.w.x) == 0);
}

TEST_CASE("wall orientation: it is the wall behind the back face that counts") {
  // The centre is nearer to the wall at the right, the back to the one in front.
  AtWall s({8.5, 3}, kPi / 2, 2);
  CHECK(error(s.o, s.w.x) == 0);
  s.o.wall = 1;
  CHECK(std::abs(s.heading() - kPi) < 1e-15);
}

TEST_CASE("wall orientation: it turns by the shortest way and only what may turn") {
  AtWall s({9, 5}, -3, 0);
  CHECK(std::abs(error(s.o, s.w.x) - (kPi - 3)) < 1e-14);
  CHECK(std::abs(projected(s.o, s.w.x, 0.5).angle(s.o.a) + 3 + (kPi - 3) / 2) < 1e-14);
  s.w.pin(s.o.a);
  CHECK(change(s.w.x, projected(s.o, s.w.x)) == 0);
  CHECK(change(s.w.x, projected(s.d, s.w.x)) == 0);
}
