#include "crowd/models/velocity_obstacle.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"

using namespace inhabit::crowd;

namespace {

/// By the definition alone: does somebody with relative velocity v come within r of the segment before tau?
double clearance(const VelocityObstacle& o, Vec2 v) {
  // The distance of a moving point to a segment is a convex function of time.
  double low = 0, high = o.tau;
  const auto gap = [&](double t) { return length(t * v - nearest_on_segment(o.a, o.b, t * v)) - o.r; };
  for (int k = 0; k < 200; ++k) {
    const double p = low + (high - low) / 3, q = high - (high - low) / 3;
    (gap(p) < gap(q) ? high : low) = gap(p) < gap(q) ? q : p;
  }
  return gap(0.5 * (low + high));
}

VelocityObstacle random_obstacle(Rng& rng, bool disc) {
  for (;;) {
    VelocityObstacle o;
    o.a = {rng.uniform(-5, 5), rng.uniform(-5, 5)};
    o.b = disc ? o.a : Vec2{rng.uniform(-5, 5), rng.uniform(-5, 5)};
    o.r = rng.uniform(0.1, 2), o.tau = rng.uniform(0.5, 5);
    if (length(nearest_on_segment(o.a, o.b, {})) > 1.01 * o.r && cross(o.b - o.a, -o.a) >= 0) return o;
  }
}

}  // namespace

TEST_CASE("the nearest point of a velocity obstacle's border is on the border and none is nearer") {
  for (std::uint64_t n = 0; n < 3000; ++n) {
    INFO("case ", n);
    Rng rng(31, n);
    const VelocityObstacle o = random_obstacle(rng, n % 2 == 0);
    const Vec2 v{rng.uniform(-4, 4), rng.uniform(-4, 4)};
    const auto at = nearest_border(o, v);
    REQUIRE(at);
    CHECK(std::abs(length(at->normal) - 1) < 1e-12);
    // On the border: a touch, and one side of it collides, the other does not.
    CHECK(std::abs(clearance(o, at->point)) < 1e-6 * o.tau);
    CHECK(clearance(o, at->point - 1e-3 * at->normal) < 0);
    CHECK(clearance(o, at->point + 1e-3 * at->normal) > 0);
    // Nearest: along the normal, and every velocity on a smaller circle about v is on the same side as v.
    const Vec2 u = at->point - v;
    CHECK(std::abs(cross(u, at->normal)) < 1e-9);
    const bool inside = clearance(o, v) < 0;
    CHECK(inside == (dot(u, at->normal) > 0));
    for (int k = 0; k < 64; ++k) {
      const double c = clearance(o, v + 0.999 * length(u) * direction(2 * kPi * k / 64));
      CHECK((inside ? c < 1e-9 : c > -1e-9));
    }
  }
}

TEST_CASE("for a disc the short way finds the same point of the border") {
  for (std::uint64_t n = 0; n < 10000; ++n) {
    INFO("case ", n);
    Rng rng(32, n);
    const VelocityObstacle o = random_obstacle(rng, true);
    const Vec2 v{rng.uniform(-4, 4), rng.uniform(-4, 4)};
    const auto expected = nearest_border(o, v);
    const BorderPoint at = nearest_border(o.a, o.r, o.tau, v);
    CHECK(length(at.point - expected->point) < 1e-9);
    CHECK(length(at.normal - expected->normal) < 1e-9);
  }
}

TEST_CASE("the legs touch the disc at the angle that the radii ask for") {
  // sin(half the opening) = r / distance: 30 degrees.
  const VelocityObstacle o{{4, 0}, {4, 0}, 2, 1};
  const auto at = nearest_border(o, {8, 0.1});
  REQUIRE(at);
  CHECK(length(at->normal - Vec2{-0.5, std::sqrt(0.75)}) < 1e-12);
  // The cut-off circle has radius r / tau about the centre / tau.
  const auto front = nearest_border(o, {1, 0});
  REQUIRE(front);
  CHECK(length(front->point - Vec2{2, 0}) < 1e-12);
  CHECK(length(front->normal - Vec2{-1, 0}) < 1e-12);
}

TEST_CASE("a wall that goes on has no way out at its end") {
  // A wall 2 m ahead from (-1, 2) to (1, 2); the floor is below it, so it runs from right to left.
  VelocityObstacle o{{1, 2}, {-1, 2}, 0.5, 1};
  const Vec2 v{0.9, 4};
  CHECK(nearest_border(o, v)->normal.x > 0.5);  // out past the right end
  o.right = VelocityObstacle::End::closed, o.left = VelocityObstacle::End::closed;
  CHECK(length(nearest_border(o, v)->normal - Vec2{0, -1}) < 1e-12);
  CHECK(length(nearest_border(o, v)->point - Vec2{0.9, 1.5}) < 1e-12);
  CHECK(!nearest_border(o, {3, 4}));
  o.right = VelocityObstacle::End::corner;
  CHECK(length(nearest_border(o, {3, 4})->point - Vec2{3, 1.5}) < 1e-12);
}
