#include "layout/constraints/traffic_lane.h"

#include <doctest/doctest.h>

#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// A lane 1 m to either side from (5, 5), ahead of an object that faces `angle`, and a member at `p`.
struct Lane {
  World w;
  Anchor from, member;
  TrafficLaneTerm c;

  explicit Lane(Vec2 p, double angle = 0, double heading = 0) : from(w.add({5, 5}, angle)), member(w.add(p)) {
    c.member = member, c.from = from, c.heading = direction(heading), c.clearance = 1;
  }
  Vec2 end() const { return projected(c, w.x).position(member); }
};

}  // namespace

TEST_CASE("traffic lane: a member inside leaves by the shortest way") {
  const Lane lane({7, 5.25});
  CHECK(std::abs(error(lane.c, lane.w.x) + 0.75) < 1e-15);
  CHECK(distance(lane.end(), {7, 6}) < 1e-15);
  CHECK(distance(Lane({7, 4.5}).end(), {7, 4}) < 1e-15);
}

TEST_CASE("traffic lane: a member beyond the clearance stays") {
  const Lane lane({7, 6.5});
  CHECK(error(lane.c, lane.w.x) == 0);
  CHECK(change(lane.w.x, projected(lane.c, lane.w.x)) == 0);
  CHECK(Lane({3.5, 5}).end() == Vec2{3.5, 5});
}

TEST_CASE("traffic lane: behind the start the nearest point is the start itself") {
  CHECK(distance(Lane({4.5, 5}).end(), {4, 5}) < 1e-15);
  CHECK(distance(Lane({4.7, 4.6}).end(), {4.4, 4.2}) < 1e-14);
}

TEST_CASE("traffic lane: a member exactly on the lane leaves to the left") {
  CHECK(distance(Lane({7, 5}).end(), {7, 6}) < 1e-15);
  CHECK(distance(Lane({5, 5}).end(), {5, 6}) < 1e-15);
}

TEST_CASE("traffic lane: it turns with its object and with its own angle") {
  CHECK(distance(Lane({5.5, 8}, kPi / 2).end(), {6, 8}) < 1e-14);
  CHECK(distance(Lane({5.5, 8}, 0, kPi / 2).end(), {6, 8}) < 1e-14);
  CHECK(distance(Lane({5.5, 2}, kPi, kPi / 2).end(), {6, 2}) < 1e-14);
}

TEST_CASE("traffic lane: it may give way by the ratio of the masses") {
  Lane lane({7, 5.25});
  lane.c.from_fixed = false;
  const State y = projected(lane.c, lane.w.x);
  CHECK(distance(y.position(lane.member), {7, 5.625}) < 1e-15);
  CHECK(distance(y.position(lane.from), {5, 4.625}) < 1e-15);
  lane.w.pin(lane.member);
  CHECK(distance(projected(lane.c, lane.w.x).position(lane.from), {5, 4.25}) < 1e-15);
  lane.c.from_fixed = true;
  CHECK(change(lane.w.x, projected(lane.c, lane.w.x)) == 0);
}
