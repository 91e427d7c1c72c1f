#include "layout/constraints/region.h"

#include <doctest/doctest.h>

#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

RegionTerm in_square(const Anchor& a, Vec3 size = {1, 1, 1}) {
  RegionTerm c;
  c.a = a, c.size = size;
  c.zone = std::make_shared<const Room>(Ring{{2, 2}, {4, 2}, {4, 4}, {2, 4}}, std::vector<Ring>{});
  return c;
}

}  // namespace

TEST_CASE("region: a box that reaches out goes back by as much") {
  World w;
  const Anchor a = w.add({2, 3});
  const RegionTerm c = in_square(a);
  CHECK(std::abs(error(c, w.x) - 0.5) < 1e-15);
  CHECK(distance(projected(c, w.x).position(a), {2.5, 3}) < 1e-15);
  CHECK(distance(projected(c, w.x, 0.5).position(a), {2.25, 3}) < 1e-15);
}

TEST_CASE("region: at a corner both sides push") {
  World w;
  const Anchor a = w.add({1, 6});
  const RegionTerm c = in_square(a);
  CHECK(error(c, w.x) == 2.5);
  CHECK(distance(projected(c, w.x).position(a), {2.5, 3.5}) < 1e-15);
}

TEST_CASE("region: a turned box needs room for its corners") {
  World w;
  const Anchor a = w.add({2.5, 3}, kPi / 4);
  const RegionTerm c = in_square(a);
  CHECK(std::abs(error(c, w.x) - (std::sqrt(0.5) - 0.5)) < 1e-15);
  CHECK(distance(projected(c, w.x).position(a), {2 + std::sqrt(0.5), 3}) < 1e-15);
}

TEST_CASE("region: inside and pinned ask for nothing and too large a box stays finite") {
  World w;
  const Anchor inside = w.add({3, 3}), pinned = w.add({9, 9}), large = w.add({2, 2});
  CHECK(error(in_square(inside), w.x) == 0);
  CHECK(change(w.x, projected(in_square(inside), w.x)) == 0);
  w.pin(pinned);
  CHECK(change(w.x, projected(in_square(pinned), w.x)) == 0);
  const State y = projected(in_square(large, {6, 6, 1}), w.x);
  CHECK(distance(y.position(large), {3, 3}) < 4);
}

TEST_CASE("region: what rides on a particle takes the particle along") {
  World w;
  const Anchor body = w.add({1, 3}), rider = w.ride(body, {0.5, 0}, 0);
  const State y = projected(in_square(rider), w.x);
  CHECK(distance(y.position(rider), {2.5, 3}) < 1e-15);
  CHECK(distance(y.position(body), {2, 3}) < 1e-15);
}
