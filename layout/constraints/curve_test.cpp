#include "layout/constraints/curve.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"
#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

Curve segment(Vec2 start, Vec2 end) { return {Curve::Kind::segment, start, end, {}, false}; }
Curve arc(Vec2 start, Vec2 end, Vec2 center = {}) { return {Curve::Kind::arc, start, end, center, false}; }
Vec2 nearest(const Curve& c, Vec2 p) { return detail::nearest_on_curve(detail::PlacedCurve(c), p).point; }

/// Members at the given places on a curve.
struct OnOne {
  World w;
  CurveTerm c;
  Anchor group;
  OnOne(const Curve& curve, const std::vector<Vec2>& places) {
    for (const Vec2 p : places) c.members.push_back(w.add(p));
    group = w.group(c.members);
    c.group = group.index(), c.curve = curve;
  }
  std::vector<Vec2> end() const {
    const State y = projected(c, w.x);
    std::vector<Vec2> list;
    for (const Anchor& m : c.members) list.push_back(y.position(m));
    return list;
  }
};

}  // namespace

TEST_CASE("curve: members drop onto a segment and stop at its ends") {
  const OnOne s(segment({1, 0}, {10, 0}), {{3, 2}, {12, 1}, {0, -1}});
  const auto end = s.end();
  CHECK(distance(end[0], {3, 0}) < 1e-15);
  CHECK(distance(end[1], {10, 0}) < 1e-15);
  CHECK(distance(end[2], {1, 0}) < 1e-15);
  CHECK(std::abs(error(s.c, s.w.x) - std::sqrt(4.0 + 5 + 2)) < 1e-14);
}

TEST_CASE("curve: an arc runs counter-clockwise and ends at its ends") {
  const Curve c = arc({2, 0}, {0, 2});
  CHECK(distance(nearest(c, {3, 3}), {std::sqrt(2), std::sqrt(2)}) < 1e-15);
  CHECK(distance(nearest(c, {0.1, 0.1}), {std::sqrt(2), std::sqrt(2)}) < 1e-14);
  CHECK(nearest(c, {3, -1}) == Vec2{2, 0});
  CHECK(nearest(c, {-3, -0.1}) == Vec2{0, 2});
  CHECK(nearest(c, {0, 0}) == Vec2{2, 0});
}

TEST_CASE("curve: an arc of more than half a turn leaves out only what it leaves out") {
  const Curve c = arc({2, 0}, {0, -2});
  CHECK(std::abs(detail::arc_sweep(c) - 1.5 * kPi) < 1e-14);
  CHECK(distance(nearest(c, {3, 3}), {std::sqrt(2), std::sqrt(2)}) < 1e-15);
  CHECK(distance(nearest(c, {-5, 0}), {-2, 0}) < 1e-15);
  CHECK(distance(nearest(c, {-1, -1}), {-std::sqrt(2), -std::sqrt(2)}) < 1e-14);
  CHECK(nearest(c, {3, -1}) == Vec2{2, 0});
  CHECK(nearest(c, {1, -3}) == Vec2{0, -2});
}

TEST_CASE("curve: half a turn and a whole one") {
  const Curve half = arc({2, 0}, {-2, 0});
  CHECK(distance(nearest(half, {0, 5}), {0, 2}) < 1e-15);
  CHECK(nearest(half, {1, -1}) == Vec2{2, 0});
  const Curve whole = arc({2, 0}, {2, 0});
  CHECK(std::abs(detail::arc_sweep(whole) - 2 * kPi) < 1e-14);
  for (const Vec2 p : {Vec2{0, 5}, Vec2{-5, 0}, Vec2{0, -5}, Vec2{3, -0.1}})
    CHECK(distance(nearest(whole, p), 2 * unit(p)) < 1e-14);
}

TEST_CASE("curve: the point at a length along it lies on it") {
  const Curve a = arc({2, 0}, {0, -2});
  CHECK(std::abs(detail::curve_length(a) - 3 * kPi) < 1e-14);
  CHECK(distance(detail::curve_point(a, kPi), {0, 2}) < 1e-14);
  CHECK(distance(detail::curve_point(a, 2 * kPi), {-2, 0}) < 1e-14);
  const Curve s = segment({1, 1}, {1, 5});
  CHECK(detail::curve_length(s) == 4);
  CHECK(distance(detail::curve_point(s, 1.5), {1, 2.5}) < 1e-15);
}

TEST_CASE("curve: the parameter of an arc grows from its start whichever way that points") {
  for (const double turn : {0.0, 1.0, 2.5, 4.0, 6.0}) {
    double last = 0;
    for (double a = 0.1; a < 6.28; a += 0.1) {
      const double t = detail::turn_order(3 * direction(wrap_angle(turn + a)), direction(wrap_angle(turn)));
      CHECK(t > last);
      last = t;
    }
  }
}

TEST_CASE("curve: what lies on the ray through an arc's start comes first and never last") {
  inhabit::core::Rng rng(5);
  for (int n = 0; n < 1000; ++n) {
    const Vec2 r = rng.uniform(0.1, 9) * direction(rng.uniform(-kPi, kPi));
    const detail::PlacedCurve c(arc(r, rotate(r, direction(rng.uniform(0.1, 3)))));
    CHECK(detail::nearest_on_curve(c, rng.uniform(0.1, 3) * r).parameter < 1e-12);
  }
}

TEST_CASE("curve: a medial axis runs through the middle of the members' box along its longer side") {
  const auto end = OnOne({.medial_axis = true}, {{0, 0}, {4, 1}, {2, 0.25}}).end();
  CHECK(distance(end[0], {0, 0.5}) < 1e-15);
  CHECK(distance(end[1], {4, 0.5}) < 1e-15);
  CHECK(distance(end[2], {2, 0.5}) < 1e-15);
  const auto tall = OnOne({.medial_axis = true}, {{0, 0}, {1, 4}}).end();
  CHECK(distance(tall[0], {0.5, 0}) < 1e-15);
}

TEST_CASE("curve: neighbours along it keep their spacing - odd pairs first and then even ones") {
  OnOne s(segment({0, 0}, {20, 0}), {{9, 1}, {1, -1}, {2, 0}});
  s.c.spacing = 2;
  const auto end = s.end();
  // On the line at 1, 2 and 9: the first pair to 0.5 and 2.5, then the second to 4.75 and 6.75.
  CHECK(distance(end[1], {0.5, 0}) < 1e-14);
  CHECK(distance(end[2], {4.75, 0}) < 1e-14);
  CHECK(distance(end[0], {6.75, 0}) < 1e-14);
  State x = s.w.x;
  for (int i = 0; i < 200; ++i) x = projected(s.c, x);
  CHECK(error(s.c, x) < 1e-9);
}

TEST_CASE("curve: coincident neighbours part and a pinned one stays") {
  OnOne s(segment({0, 0}, {10, 0}), {{5, 0}, {5, 0}});
  s.c.spacing = 1;
  s.w.pin(s.c.members[0]);
  const auto end = s.end();
  CHECK(end[0] == Vec2{5, 0});
  CHECK(std::abs(distance(end[0], end[1]) - 1) < 1e-14);
}

TEST_CASE("curve: a group that is moved or turned carries its curve along") {
  OnOne s(segment({0, 0}, {10, 0}), {{3, 1}, {7, 0}});
  const double before = error(s.c, s.w.x);
  s.w.x.shift(s.group, {2, 3});
  CHECK(std::abs(error(s.c, s.w.x) - before) < 1e-14);
  CHECK(distance(s.end()[0], {5, 3}) < 1e-14);
  s.w.x.turn(s.group, kPi / 2);
  CHECK(std::abs(error(s.c, s.w.x) - before) < 1e-14);
}

TEST_CASE("curve: a segment and an arc without length are points") {
  const auto segment_end = OnOne(segment({1, 1}, {1, 1}), {{3, 2}, {1, 1}}).end();
  CHECK(distance(segment_end[0], {1, 1}) < 1e-15);
  const auto arc_end = OnOne(arc({1, 1}, {1, 1}, {1, 1}), {{3, 2}, {1, 1}}).end();
  CHECK(distance(arc_end[0], {1, 1}) < 1e-15);
  CHECK(distance(arc_end[1], {1, 1}) < 1e-15);
}

TEST_CASE("curve: a group of the document becomes one term in the order of its members") {
  Scene scene = empty_room(9, 9);
  const Ref a = add(scene, "a", {1, 1, 1}, {1, 1}), b = add(scene, "b", {1, 1, 1}, {4, 2});
  add_group(scene, "row", {b, a});
  scene.groups[0].curve = segment({0, 1}, {9, 1});
  scene.groups[0].spacing = 2;
  const Ready ready(scene);
  const auto& terms = ready.problem.of<CurveTerm>();
  REQUIRE(terms.size() == 1);
  REQUIRE(terms[0].members.size() == 2);
  CHECK(ready.x.position(terms[0].members[0]) == Vec2{4, 2});
  CHECK(std::abs(error(terms[0], ready.x) - std::hypot(1, std::sqrt(10) - 2)) < 1e-14);
}
