#include "geometry/raster.h"

#include <doctest/doctest.h>

#include <set>

#include "core/rng.h"
#include "geometry/box_grid.h"
#include "geometry/containment.h"

using namespace inhabit::geometry;

TEST_CASE("filling a polygon sets the cells whose centres it contains") {
  Raster raster = make_raster({{0, 0}, {4, 4}}, 0.1, 1u << 20);
  CHECK(raster.columns == 40);
  const Ring l = {{0.03, 0.02}, {3.9, 0}, {4, 2.01}, {2, 2}, {1.97, 4}, {0, 4}};
  fill(raster, l, 1);
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column)
      CHECK((raster.values[raster.at(column, row)] == 1) == contains(l, raster.center(column, row)));
}

TEST_CASE("a raster never has more cells than asked for") {
  for (const double side : {0.001, 1.0, 17.3, 900.0}) {
    const Raster raster = make_raster({{0, 0}, {side, side / 3}}, 0.02, 10000);
    CHECK(raster.values.size() <= 10000);
    CHECK(raster.columns * raster.cell >= side * (1 - 1e-6));
  }
}

TEST_CASE("cells near a box are those nearer than the radius") {
  const Raster raster = make_raster({{0, 0}, {3, 3}}, 0.05, 1u << 20);
  const Box box{{1.2, 1.4}, direction(0.6), 0.7, 0.3};
  std::set<std::pair<int, int>> seen;
  for_each_near(raster, box, 0.25, [&](int column, int row) { CHECK(seen.insert({column, row}).second); });
  const auto corners = box.corners();
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      const Vec2 p = raster.center(column, row);
      const bool near = box.contains(p) || nearest_on_ring(corners, p).distance < 0.25;
      CHECK(seen.contains({column, row}) == near);
    }
}

TEST_CASE("components count separated rooms and join diagonal cells") {
  Raster raster = make_raster({{0, 0}, {10, 10}}, 1, 100);
  for (int row = 0; row < 10; ++row) raster.values[raster.at(4, row)] = 1;
  Components parts = components(raster, 0);
  REQUIRE(parts.size.size() == 2);
  CHECK(parts.size[0] == 40);
  CHECK(parts.size[1] == 50);
  raster.values.assign(raster.values.size(), 1);
  raster.values[raster.at(0, 0)] = raster.values[raster.at(1, 1)] = 0;
  CHECK(components(raster, 0).size.size() == 1);
}

TEST_CASE("a grid of boxes finds the pairs and neighbours that brute force finds") {
  inhabit::core::Rng rng(5);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 150; ++i) {
      const double size = i % 30 == 0 ? 8 : std::pow(10, rng.uniform(-3, 0.3));
      const Vec2 p{rng.uniform(-5, 5), rng.uniform(-5, trial % 2 ? 5 : -4.9)};
      boxes.push_back({p, p + Vec2{size, size * rng.uniform()}});
    }
    const BoxGrid grid(boxes);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) { CHECK(found.insert({i, j}).second); });
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
        if (meet(boxes[i], boxes[j])) expected.insert({i, j});
    CHECK(found == expected);
    const Bounds query{{-20, -1}, {1, 20}};
    std::set<std::uint32_t> near, expected_near;
    grid.for_each_near(query, [&](std::uint32_t i) { CHECK(near.insert(i).second); });
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (meet(boxes[i], query)) expected_near.insert(i);
    CHECK(near == expected_near);
  }
}
