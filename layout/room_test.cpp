#include "scene/room.h"

#include <doctest/doctest.h>

#include "layout/test_world.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// The box after one round of the boundary constraint, pushed as the solver does.
Box pushed(const Room& room, Box box) {
  room.for_each_violation(box, [&](Vec2 n, double depth) { box.center += depth * n; });
  return box;
}
double deepest(const Room& room, const Box& box) {
  double depth = 0;
  room.for_each_violation(box, [&](Vec2, double d) { depth = std::max(depth, d); });
  return depth;
}
/// Some point of the box, a little less than its border, lies outside.
bool reaches_out(const Room& room, const Box& box) {
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      const Vec2 local{0.0999 * i * box.half_depth, 0.0999 * j * box.half_width};
      if (!room.contains(box.center + rotate(local, box.front))) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("boundary: in a convex room every wall pushes by how far the box reaches through it") {
  const Room room(rectangle(10, 8), {});
  CHECK(length(pushed(room, {{0.2, 4}, {1, 0}, 0.5, 0.5}).center - Vec2{0.5, 4}) < 1e-15);
  CHECK(length(pushed(room, {{12, -3}, {1, 0}, 0.5, 0.25}).center - Vec2{9.5, 0.25}) < 1e-14);
  CHECK(deepest(room, {{5, 4}, {1, 0}, 5, 4}) == 0);
  const Box turned{{0.5, 4}, direction(kPi / 4), 0.5, 0.5};
  CHECK(std::abs(deepest(room, turned) - (std::sqrt(0.5) - 0.5)) < 1e-14);
}

TEST_CASE("boundary: a reflex corner inside the box pushes it out through the nearest face") {
  const Room room(l_shape(), {});
  CHECK(length(pushed(room, {{1.7, 1.8}, {1, 0}, 0.5, 0.5}).center - Vec2{1.5, 1.8}) < 1e-14);
  CHECK(length(pushed(room, {{1.8, 1.7}, {1, 0}, 0.5, 0.5}).center - Vec2{1.8, 1.5}) < 1e-14);
  CHECK(deepest(room, {{1.5, 1.9}, {1, 0}, 0.5, 0.5}) < 1e-15);
}

TEST_CASE("boundary: a reflex corner on a face of the box is not free while a wall still crosses it") {
  const Room room({{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}}, {});
  const Box box{{3.481400271, 4.577263786}, direction(1.826903), 0.689805, 0.488948};
  CHECK_FALSE(room.contains(box.corners()[0]));
  CHECK(deepest(room, box) > 0.03);
  CHECK(deepest(room, pushed(room, box)) < 1e-12);
}

TEST_CASE("boundary: a box wholly outside comes in over the nearest wall") {
  const Room room(l_shape(), {});
  CHECK(length(pushed(room, {{3, -5}, {1, 0}, 0.5, 0.5}).center - Vec2{3, 0.5}) < 1e-14);
  CHECK(length(pushed(room, {{3.5, 3}, {1, 0}, 0.25, 0.25}).center - Vec2{3.5, 1.75}) < 1e-14);
}

TEST_CASE("boundary: a hole pushes by the shortest way whether it is convex or not") {
  const Room room(rectangle(10, 10), {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}});
  CHECK(length(pushed(room, {{3.6, 5}, {1, 0}, 0.5, 0.5}).center - Vec2{3.5, 5}) < 1e-14);
  CHECK(deepest(room, {{5, 5}, {1, 0}, 0.1, 0.1}) > 1);
  CHECK(deepest(room, {{2, 2}, {1, 0}, 1, 1}) == 0);
}

TEST_CASE("boundary: projected again and again a box ends inside every kind of room") {
  const std::vector<Room> rooms = {
      Room(rectangle(6, 5), {}),
      Room({{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}}, {}),
      Room({{0, 0}, {9, 0}, {9, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 6}, {0, 6}}, {}),
      Room({{0, 0}, {7, 0}, {9, 5}, {4, 3}, {2, 7}, {-1, 4}}, {}),
      Room(rectangle(10, 10), {{{4, 4}, {6, 4}, {6, 4.5}, {4.5, 4.5}, {4.5, 6}, {4, 6}}}),
  };
  int stuck = 0, cases = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    for (std::uint64_t n = 0; n < 1000; ++n) {
      CAPTURE(r);
      CAPTURE(n);
      Rng rng(11, n);
      const Bounds b = rooms[r].extent();
      Box box{{rng.uniform(b.min.x, b.max.x), rng.uniform(b.min.y, b.max.y)},
              direction(rng.uniform(-kPi, kPi)),
              rng.uniform(0.1, 0.7),
              rng.uniform(0.1, 0.7)};
      for (int i = 0; i < 100 && deepest(rooms[r], box) > 1e-6; ++i) box = pushed(rooms[r], box);
      ++cases;
      stuck += deepest(rooms[r], box) > 1e-6;
      CHECK(std::isfinite(box.center.x + box.center.y));
      // What the constraint calls satisfied is inside.
      const Box inner{box.center, box.front, box.half_depth * 0.999, box.half_width * 0.999};
      if (deepest(rooms[r], box) <= 1e-6) CHECK_FALSE(reaches_out(rooms[r], inner));
    }
  }
  // Pushes of opposite walls may trap one in a corner that is too narrow for it: rare.
  CHECK(stuck <= cases / 50);
}

TEST_CASE("boundary: the nearest wall is signed and ties go to the first") {
  const Room room(rectangle(10, 10), {});
  CHECK(room.nearest_wall({5, 5}).wall == 0);
  CHECK(room.nearest_wall({5, 1}).distance == 1);
  CHECK(room.nearest_wall({5, -1}).distance == -1);
  CHECK(room.nearest_wall({5, 1}, 2).distance == 9);
  CHECK(room.nearest_wall({5, 1}, 6).wall == 2);
}
