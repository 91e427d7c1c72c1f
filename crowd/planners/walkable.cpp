#include "crowd/planners/walkable.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "geometry/raster.h"

namespace inhabit::crowd {
namespace {

/// 1 for the cells whose centres are on a floor.
std::vector<std::uint8_t> floor_cells(const World& world, const Lattice& lattice) {
  Raster raster;
  raster.origin = lattice.origin + world.origin;
  raster.cell = lattice.cell, raster.columns = lattice.columns, raster.rows = lattice.rows;
  raster.values.assign(lattice.size(), 0);
  for (const Floor& floor : world.floors) {  // largest first: what stands in a hole comes after the hole
    fill(raster, floor.outline, 1);
    for (const Ring& hole : floor.holes) fill(raster, hole, 0);
  }
  return std::move(raster.values);
}

/// Distance of every centre to the nearest wall, exact up to `reach` and infinite beyond.
std::vector<float> wall_distances(const Walls& walls, const Lattice& lattice, double reach) {
  std::vector<float> distance(lattice.size(), Walkable::kClosed);
  const auto range = [&](double low, double high, double origin, std::int32_t count) {
    const double first = std::floor((low - reach - origin) / lattice.cell);
    const double last = std::floor((high + reach - origin) / lattice.cell);
    return std::pair{static_cast<std::int32_t>(std::clamp(first, 0.0, count - 1.0)),
                     static_cast<std::int32_t>(std::clamp(last, 0.0, count - 1.0))};
  };
  for (const WallSegment& s : walls.segments()) {
    // In pieces, because the bounds of a long slanted wall are mostly empty.
    const Vec2 a{s.ax, s.ay}, b{s.bx, s.by};
    const int pieces = std::max(1, static_cast<int>(std::ceil(length(b - a) / (4 * reach))));
    for (int i = 0; i < pieces; ++i) {
      const Vec2 p = a + (static_cast<double>(i) / pieces) * (b - a);
      const Vec2 q = a + (static_cast<double>(i + 1) / pieces) * (b - a);
      const auto [c0, c1] = range(std::min(p.x, q.x), std::max(p.x, q.x), lattice.origin.x, lattice.columns);
      const auto [r0, r1] = range(std::min(p.y, q.y), std::max(p.y, q.y), lattice.origin.y, lattice.rows);
      for (std::int32_t r = r0; r <= r1; ++r)
        for (std::int32_t c = c0; c <= c1; ++c) {
          const Vec2 at = lattice.center(c, r);
          const auto d = static_cast<float>(length(at - nearest_on_segment(p, q, at)));
          float& least = distance[lattice.at(c, r)];
          if (d < least && d <= reach) least = d;
        }
    }
  }
  return distance;
}

/// The largest distance to walls in a cell, found by stepping away from the nearest one with shorter and shorter
/// steps.
double widest_spot(const Walls& walls, const Lattice& lattice, std::size_t cell) {
  const Vec2 middle = lattice.center(cell);
  const double half = lattice.cell / 2;
  Vec2 at = middle;
  double best = 0;
  for (double step = half / 2; step > half / 64; step *= 0.75) {
    double nearest = 1e300;
    Vec2 wall;
    const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
    walls.for_each_near(x, y, [&](const WallSegment& s, std::uint32_t) {
      const Vec2 q = nearest_on_segment({s.ax, s.ay}, {s.bx, s.by}, at);
      const double d = length(at - q);
      if (d < nearest) nearest = d, wall = q;
    });
    if (nearest == 1e300) return best;
    const bool on_floor = walls.on_floor(x, y);
    if (on_floor) best = std::max(best, nearest);
    if (nearest == 0) return best;
    Vec2 move = (on_floor ? step : -step) / nearest * (at - wall);
    // Along the cell's border at full pace: the spot of a slanted passage that only clips a corner lies there.
    if (std::abs(at.y + move.y - middle.y) > half) move.x = std::copysign(step, move.x);
    if (std::abs(at.x + move.x - middle.x) > half) move.y = std::copysign(step, move.y);
    at.x = std::clamp(at.x + move.x, middle.x - half, middle.x + half);
    at.y = std::clamp(at.y + move.y, middle.y - half, middle.y + half);
  }
  return best;
}

/// Fills `exit`: from the open cells over the floor, then from all of those into the walls.
void find_exits(Walkable& w, const std::vector<std::uint8_t>& floor) {
  const Lattice& lattice = w.lattice;
  w.exit.assign(lattice.size(), Walkable::kNone);
  std::vector<float> far(lattice.size(), Walkable::kClosed);
  struct Entry {
    float distance;
    std::uint32_t cell, source;
    bool operator>(const Entry& b) const { return distance != b.distance ? distance > b.distance : cell > b.cell; }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto grow = [&](std::size_t from, bool into_walls) {
    const std::int32_t column = lattice.column_of(from), row = lattice.row_of(from);
    const std::uint32_t source = w.exit[from];
    for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, lattice.rows - 1); ++r)
      for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, lattice.columns - 1); ++c) {
        const std::size_t k = lattice.at(c, r);
        if (w.cost[k] != Walkable::kClosed || (floor[k] == 0) != into_walls) continue;
        const auto d = static_cast<float>(length(lattice.center(k) - lattice.center(source)));
        if (!(d < far[k]) || (into_walls && d > 3 * w.body + 3 * lattice.cell)) continue;
        far[k] = d, w.exit[k] = source;
        open.push({d, static_cast<std::uint32_t>(k), source});
      }
  };
  const auto spread = [&](bool into_walls) {
    for (std::size_t k = 0; k < lattice.size(); ++k)
      if (w.exit[k] != Walkable::kNone && (into_walls || w.cost[k] != Walkable::kClosed)) grow(k, into_walls);
    while (!open.empty()) {
      const Entry e = open.top();
      open.pop();
      if (w.exit[e.cell] == e.source) grow(e.cell, into_walls);
    }
  };
  for (std::size_t k = 0; k < lattice.size(); ++k)
    if (w.cost[k] != Walkable::kClosed) w.exit[k] = static_cast<std::uint32_t>(k), far[k] = 0;
  spread(false);
  spread(true);
}

}  // namespace

Walkable make_walkable(const World& world, double body, double cell, std::size_t most) {
  Walkable w;
  w.body = body;
  Bounds box;
  for (const Floor& floor : world.floors)
    for (const Vec2 p : floor.outline) box.add(p - world.origin);
  const Vec2 rim{body + 2 * cell, body + 2 * cell};
  const Raster raster = make_raster({box.min - rim, box.max + rim}, cell, most);
  w.lattice = {raster.origin, raster.cell, raster.columns, raster.rows};
  const double h = w.lattice.cell;

  const double soft = std::max(0.6 * body, 1.5 * h);  // how far walls slow people down beyond their bodies
  w.walls = Walls(world.floors, world.origin, body + 2 * h);
  const std::vector<std::uint8_t> floor = floor_cells(world, w.lattice);
  const std::vector<float> distance = wall_distances(w.walls, w.lattice, body + soft + h);
  const double least = (1 - kSqueeze) * body;
  w.cost.assign(w.lattice.size(), Walkable::kClosed);
  for (std::size_t k = 0; k < w.lattice.size(); ++k) {
    double room = floor[k] ? distance[k] : -distance[k];
    if (room < least) {
      if (room < least - 0.72 * h) continue;
      room = widest_spot(w.walls, w.lattice, k);
      if (room < least) continue;
    }
    const double near = std::clamp(1 - (room - body) / soft, 0.0, 1.0);
    w.cost[k] = static_cast<float>(1 + 2 * near * near);
  }
  find_exits(w, floor);
  return w;
}

}  // namespace inhabit::crowd
