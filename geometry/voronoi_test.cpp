#include "geometry/voronoi.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "geometry/convex.h"
#include "geometry/point_grid.h"

using namespace inhabit::geometry;

namespace {

Ring rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// The cell of point i by its definition: all bisectors, then GEOS.
Area brute_cell(std::span<const Vec2> points, std::size_t i, const std::vector<Area>& walkable) {
  std::vector<Vec2> all;
  for (const Area& area : walkable) all.insert(all.end(), area.outline.begin(), area.outline.end());
  Bounds b = bounds(all);
  const Vec2 p = points[i];
  Ring cell = rectangle(b.min.x - 5, b.min.y - 5, b.max.x + 5, b.max.y + 5);
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j] == p) continue;
    const Vec2 middle = 0.5 * (p + points[j]), n = unit(points[j] - p), along = perp(n);
    // The half plane on p's side, as a big rectangle.
    const Ring half = {middle - 1000 * along, middle + 1000 * along, middle + 1000 * along - 2000 * n,
                       middle - 1000 * along - 2000 * n};
    cell = clipped(cell, half);
  }
  for (const Area& piece : intersection(walkable, cell, 0))
    if (contains(make_floor(piece.outline, piece.holes), p)) return piece;
  return {};
}

}  // namespace

TEST_CASE("the cells of a square lattice are its squares") {
  std::vector<Vec2> points;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 5; ++j) points.push_back({0.4 * (i + 0.5), 0.4 * (j + 0.5)});
  const VoronoiGround ground({{rectangle(0, 0, 2.8, 2.0), {}}});
  const std::vector<Area> cells = ground.cells(points);
  for (const Area& cell : cells) CHECK(std::abs(cell.size() - 0.16) < 1e-12);
}

TEST_CASE("a lone person has the whole floor or the disc of the cut-off") {
  const std::vector<Vec2> one = {{1, 1}};
  const std::vector<Area> room = {{rectangle(0, 0, 4, 3), {rectangle(2, 2, 3, 2.5)}}};
  CHECK(VoronoiGround(room).cells(one)[0].size() == doctest::Approx(11.5).epsilon(1e-12));
  CHECK(VoronoiGround({}, 0.8).cells(one)[0].size() == doctest::Approx(3.14159265358979 * 0.64).epsilon(1e-12));
  const double corner = VoronoiGround(room, 0.5).cells(std::vector<Vec2>{{0, 0}})[0].size();
  CHECK(corner == doctest::Approx(3.14159265358979 * 0.25 / 4).epsilon(1e-12));
}

TEST_CASE("a cell does not reach through a wall") {
  // Two rooms side by side, 0.1 m apart, joined by a corridor far below: one person in each of the upper ends.
  const Ring outline = {{0, 0}, {4.1, 0}, {4.1, 10}, {2.1, 10}, {2.1, 1}, {2, 1}, {2, 10}, {0, 10}};
  const std::vector<Area> rooms = {{outline, {}}};
  const std::vector<Vec2> left_only = {{1.9, 9}, {1, 0.5}};
  const std::vector<Area> cells = VoronoiGround(rooms).cells(left_only);
  for (const Vec2 p : cells[0].outline) CHECK(p.x <= 2 + 1e-9);
  const std::vector<Vec2> out = {{2.05, 5}, {1, 5}};
  const std::vector<Area> with_stranger = VoronoiGround(rooms).cells(out);
  CHECK(with_stranger[0].outline.empty());
  CHECK(with_stranger[1].size() > 20);
}

TEST_CASE("cells agree with the definition by all bisectors") {
  const std::vector<std::vector<Area>> grounds = {{{rectangle(0, 0, 1.8, 8), {}}},
                                                  {{Ring{{-3, 5}, {-3, -3}, {5, -3}, {5, 0}, {0, 0}, {0, 5}}, {}}},
                                                  {{rectangle(-3.5, -2, 3.5, 8),
                                                    {Ring{{-0.7, -1.1},
                                                          {-0.25, -1.1},
                                                          {-0.25, -0.15},
                                                          {-0.4, 0},
                                                          {-2.8, 0},
                                                          {-2.8, 6.7},
                                                          {-3.05, 6.7},
                                                          {-3.05, -0.3},
                                                          {-0.7, -0.3}},
                                                     rectangle(1, -0.3, 3, 0)}}},
                                                  {{rectangle(0, 0, 2, 2), {}}, {rectangle(2, 0, 4, 1), {}}}};
  inhabit::core::Rng random(7);
  for (std::size_t g = 0; g < grounds.size(); ++g) {
    const VoronoiGround ground(grounds[g]);
    std::vector<Vec2> all;
    for (const Area& area : grounds[g]) all.insert(all.end(), area.outline.begin(), area.outline.end());
    const Bounds b = bounds(all);
    for (int run = 0; run < 40; ++run) {
      std::vector<Vec2> points;
      const int count = 1 + static_cast<int>(random.uniform(0, 60));
      while (static_cast<int>(points.size()) < count) {
        const Vec2 p{random.uniform(b.min.x, b.max.x), random.uniform(b.min.y, b.max.y)};
        if (ground.on_ground(p)) points.push_back(p);
      }
      const std::vector<Area> cells = ground.cells(points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        CAPTURE(g);
        CAPTURE(run);
        CAPTURE(i);
        CHECK(std::abs(cells[i].size() - brute_cell(points, i, ground.walkable()).size()) < 1e-7);
      }
    }
  }
}

TEST_CASE("cells that meet a place are those of all cells") {
  inhabit::core::Rng random(17);
  const VoronoiGround ground({{rectangle(0, 0, 20, 10), {rectangle(8, 0, 8.2, 7)}}});
  for (int run = 0; run < 200; ++run) {
    std::vector<Vec2> points;
    const int count = 1 + static_cast<int>(random.index(run < 100 ? 5 : 200));
    // Often all in one corner, far from the place.
    const double wide = run % 2 ? 20 : 3;
    for (int i = 0; i < count; ++i) points.push_back({random.uniform(0, wide), random.uniform(0, 10)});
    const Vec2 low{random.uniform(0, 18), random.uniform(0, 8)};
    const Bounds where{low, low + Vec2{random.uniform(0.1, 2), random.uniform(0.1, 2)}};
    const Ring box = rectangle(where.min.x, where.min.y, where.max.x, where.max.y);
    const std::vector<Area> all = ground.cells(points), some = ground.cells_meeting(points, where);
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      left_out += some[i].outline.empty() && !all[i].outline.empty() ? 1 : 0;
      CHECK(overlap_area(all[i].outline, box) == overlap_area(some[i].outline, box));
    }
    if (run >= 100 && run % 2 == 1 && count > 100) CHECK(left_out > 0);
  }
}

TEST_CASE("points at one place share a cell") {
  const VoronoiGround ground({{rectangle(0, 0, 2, 1), {}}});
  const std::vector<Vec2> points = {{0.5, 0.5}, {0.5, 0.5}, {1.5, 0.5}};
  const std::vector<Area> cells = ground.cells(points);
  for (const Area& cell : cells) CHECK(std::abs(cell.size() - 1) < 1e-12);
}

TEST_CASE("close pairs are those of all pairs") {
  inhabit::core::Rng random(11);
  for (const double scale : {0.01, 1.0, 300.0}) {
    std::vector<Vec2> points;
    for (int i = 0; i < 200; ++i) points.push_back({random.uniform(-scale, scale), random.uniform(0, 3 * scale)});
    const double reach = 0.2;
    int brute = 0, found = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        const Vec2 d = points[i] - points[j];
        brute += dot(d, d) < reach * reach ? 1 : 0;
      }
    for_each_close_pair(points, reach, [&](std::size_t i, std::size_t j) {
      CHECK(i < j);
      ++found;
    });
    CHECK(found == brute);
  }
}

TEST_CASE("a hull holds all its points and turns at each corner") {
  inhabit::core::Rng random(13);
  std::vector<Vec2> points;
  for (int i = 0; i < 300; ++i) points.push_back({random.uniform(-1, 1), random.uniform(0, 5)});
  const Ring ring = convex_hull(points);
  CHECK(is_convex(ring));
  CHECK(signed_area(ring) > 9);
  for (const Vec2 p : points) CHECK(contains(ring, p));
  CHECK(convex_hull({{0, 0}, {1, 1}, {2, 2}, {1, 1}}).size() == 2);
  CHECK(convex_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}}).size() == 4);
}
