#include "layout/constraints/orientation.h"

#include <doctest/doctest.h>

#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

struct Pair {
  World w;
  OrientationTerm c;
  Pair(double angle, Vec2 to, double to_angle = 0) { c.a = w.add({5, 5}, angle), c.to = w.add(to, to_angle); }
  double heading() const { return projected(c, w.x).angle(c.a); }
};

}  // namespace

TEST_CASE("orientation: it looks straight at the other object") {
  CHECK(std::abs(Pair(0, {5, 7}).heading() - kPi / 2) < 1e-15);
  CHECK(std::abs(Pair(0, {4, 4}).heading() + 3 * kPi / 4) < 1e-15);
  Pair back(0, {5, 7});
  back.c.angle = kPi;
  CHECK(std::abs(back.heading() + kPi / 2) < 1e-15);
  CHECK(back.w.x.position(back.c.a) == projected(back.c, back.w.x).position(back.c.a));
}

TEST_CASE("orientation: parallel takes the other's heading and not its bearing") {
  Pair p(0, {5, 7}, 1);
  p.c.parallel = true, p.c.angle = 0.25;
  CHECK(std::abs(error(p.c, p.w.x) + 1.25) < 1e-15);
  CHECK(std::abs(p.heading() - 1.25) < 1e-15);
}

TEST_CASE("orientation: it turns by the shortest way across half a turn") {
  Pair p(radians(170), {5, 5}, radians(-170));
  p.c.parallel = true;
  CHECK(std::abs(error(p.c, p.w.x) + radians(20)) < 1e-14);
  CHECK(std::abs(projected(p.c, p.w.x, 0.25).angle(p.c.a) - radians(175)) < 1e-14);
}

TEST_CASE("orientation: coincident objects ask for nothing and who may not turn stays") {
  Pair p(1, {5, 5});
  CHECK(error(p.c, p.w.x) == 0);
  CHECK(change(p.w.x, projected(p.c, p.w.x)) == 0);
  Pair q(1, {6, 5});
  q.w.pin(q.c.a);
  CHECK(change(q.w.x, projected(q.c, q.w.x)) == 0);
}

TEST_CASE("orientation: a group turns as a whole about its centre of mass") {
  World w;
  const Anchor a = w.add({4, 5}), b = w.add({6, 5}), to = w.add({5, 9});
  OrientationTerm c;
  c.a = w.group({a, b}), c.to = to;
  const State y = projected(c, w.x);
  CHECK(error(c, y) < 1e-15);
  CHECK(distance(y.position(a), {5, 4}) < 1e-14);
  CHECK(distance(y.position(b), {5, 6}) < 1e-14);
  CHECK(std::abs(y.angle(a) - kPi / 2) < 1e-15);
}
