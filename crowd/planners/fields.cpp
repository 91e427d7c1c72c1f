#include "crowd/planners/fields.h"

#include <cmath>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

using fields_kernel::kUnit;
/// Bounds on memory: cells of all fields together, and of one lattice.
constexpr double kAllCells = 12e6, kCells = 3e6;
std::uint32_t pack(Vec2 d) {
  const auto x = static_cast<std::int16_t>(std::lround(d.x * static_cast<double>(kUnit)));
  const auto y = static_cast<std::int16_t>(std::lround(d.y * static_cast<double>(kUnit)));
  return static_cast<std::uint32_t>(static_cast<std::uint16_t>(x)) |
         static_cast<std::uint32_t>(static_cast<std::uint16_t>(y)) << 16;
}
/// What the aims of a field look like from a cell: the nearest point in sight.
struct Sight {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 way;  ///< to the point
};

Sight look(const Walkable& w, std::size_t cell, const std::vector<const Place*>& places, bool areas, double reach) {
  Sight best;
  const Vec2 at = w.lattice.center(cell);
  const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
  for (const Place* place : places) {
    const Region& region = areas ? place->area : place->aim;
    const Region::Way way = region.way_from(x, y);
    const double d = std::hypot(way.x, way.y);
    // A hair short of the border, which may run along a wall.
    if (d > reach || d >= best.distance || !w.walls.sees(x, y, x + 0.999f * way.x, y + 0.999f * way.y)) continue;
    best = {d, {way.x, way.y}};
  }
  return best;
}

/// The cells where a field starts, with what they know. Exact distances in a rim of some cells round an aim spare the
/// marching its largest error, that of a point's neighbourhood.
std::vector<std::pair<std::uint32_t, Sight>> starts(const Walkable& w, const std::vector<const Place*>& places) {
  const Lattice& lattice = w.lattice;
  std::vector<std::pair<std::uint32_t, Sight>> found;
  // An aim that no body's middle can enter, say a strip along a wall, is headed for from as near as bodies come. An aim
  // that lies off the floor altogether leaves the area.
  for (const auto& [areas, reach] : {std::pair{false, 2.5 * lattice.cell},
                                     {false, w.body + 2.5 * lattice.cell},
                                     {true, 2.5 * lattice.cell},
                                     {true, w.body + 2.5 * lattice.cell}}) {
    std::vector<std::uint8_t> seen(lattice.size(), 0);
    for (const Place* place : places) {
      const Region& region = areas ? place->area : place->aim;
      const auto index = [&](double at, double origin, std::int32_t count) {
        return static_cast<std::int32_t>(std::clamp(std::floor((at - origin) / lattice.cell), 0.0, count - 1.0));
      };
      const std::int32_t c1 = index(region.max_x + reach, lattice.origin.x, lattice.columns);
      const std::int32_t r1 = index(region.max_y + reach, lattice.origin.y, lattice.rows);
      for (std::int32_t r = index(region.min_y - reach, lattice.origin.y, lattice.rows); r <= r1; ++r)
        for (std::int32_t c = index(region.min_x - reach, lattice.origin.x, lattice.columns); c <= c1; ++c) {
          const std::size_t k = lattice.at(c, r);
          if (seen[k] || w.cost[k] == Walkable::kClosed) continue;
          seen[k] = 1;
          const Sight sight = look(w, k, places, areas, reach);
          if (sight.distance <= reach) found.emplace_back(static_cast<std::uint32_t>(k), sight);
        }
    }
    if (!found.empty()) break;
  }
  return found;
}

/// Where to go on an aim: to the area when that is elsewhere; from the border a little farther in, so that nobody stops
/// on the line; nowhere in its middle.
Vec2 within(Vec2 at, double cell, const std::vector<const Place*>& places) {
  const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
  for (const Place* place : places) {
    if (!place->area.contains(x, y)) continue;
    const Vec2 middle = centroid(place->area.ring) - at;
    const bool rim = nearest_on_ring(place->area.ring, at).distance < 1.5 * cell;
    return rim && length(middle) > cell ? unit(middle) : Vec2{};
  }
  Vec2 best;
  for (const Place* place : places) {
    const Region::Way way = place->way_from(x, y);
    const Vec2 v{way.x, way.y};
    if (v != Vec2{} && (best == Vec2{} || length(v) < length(best))) best = v;
  }
  return best == Vec2{} ? best : unit(best);
}

}  // namespace

Fields::Fields(const World& world, const std::vector<std::vector<const Place*>>& targets, double body, int threads) {
  if (targets.empty() || world.floors.empty()) return;
  const double most = std::min(kCells, kAllCells / static_cast<double>(targets.size()));
  walkable_ = make_walkable(world, body, std::clamp(0.4 * body, 0.1, 0.25), static_cast<std::size_t>(most));
  const std::size_t cells = walkable_.lattice.size();
  distance_.resize(targets.size() * cells), direction_.resize(targets.size() * cells);
  parallel_for(targets.size(), threads, [&](std::size_t f) { solve(f, targets[f]); });
}

void Fields::solve(std::size_t field, const std::vector<const Place*>& places) {
  const Lattice& lattice = walkable_.lattice;
  const auto first = starts(walkable_, places);
  std::vector<MarchSeed> seeds;
  for (const auto& [cell, sight] : first) seeds.push_back({cell, static_cast<float>(sight.distance)});
  const std::vector<float> t = march(lattice, walkable_.cost, seeds);

  float* const distance = distance_.data() + field * lattice.size();
  std::uint32_t* const direction = direction_.data() + field * lattice.size();
  std::vector<Vec2> down(lattice.size());
  for (std::size_t k = 0; k < lattice.size(); ++k) down[k] = descent(lattice, t, k);
  for (const auto& [cell, sight] : first) {
    down[cell] = sight.distance > 0 ? unit(sight.way) : Vec2{};
    if (sight.distance > 0) continue;
    down[cell] = within(lattice.center(cell), lattice.cell, places);
  }
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const std::uint32_t exit = walkable_.exit[k];
    distance[k] = exit == Walkable::kNone ? Walkable::kClosed : t[exit];
    if (distance[k] == Walkable::kClosed) {
      direction[k] = pack({});
    } else if (exit == k) {
      direction[k] = pack(down[k]);
    } else {
      // Out of the wall first, and on the way: the deeper the more straight out.
      const Vec2 out = lattice.center(exit) - lattice.center(k);
      distance[k] += 3 * static_cast<float>(length(out));
      direction[k] = pack(unit((1 / lattice.cell) * out + down[exit]));
    }
  }
}

Region::Way Fields::way(std::size_t field, float x, float y) const {
  const std::uint32_t f = static_cast<std::uint32_t>(field);
  const float speed = 1;
  Region::Way way;
  look_up({&f, 1}, {&x, 1}, {&y, 1}, {&speed, 1}, {&way.x, 1}, {&way.y, 1});
  return way;
}

fields_kernel::Lookup Fields::lookup() const {
  const Lattice& lattice = walkable_.lattice;
  fields_kernel::Lookup l;
  l.direction = direction_.data();
  l.origin_x = static_cast<float>(lattice.origin.x), l.origin_y = static_cast<float>(lattice.origin.y);
  l.inverse_cell = static_cast<float>(1 / lattice.cell);
  l.last_column = static_cast<float>(lattice.columns) - 1.001f, l.last_row = static_cast<float>(lattice.rows) - 1.001f;
  l.columns = lattice.columns, l.cells = static_cast<std::int32_t>(lattice.size());
  return l;
}

void Fields::look_up(std::span<const std::uint32_t> field, std::span<const float> x, std::span<const float> y,
                     std::span<const float> speed, std::span<float> wish_x, std::span<float> wish_y) const {
  fields_kernel::Lookup l = lookup();
  l.field = field.data(), l.x = x.data(), l.y = y.data(), l.speed = speed.data();
  l.wish_x = wish_x.data(), l.wish_y = wish_y.data();
  fields_kernel::look_up(l, 0, field.size());
}

double Fields::distance(std::size_t field, float x, float y) const {
  const Lattice& lattice = walkable_.lattice;
  const std::span<const float> t = weighted_distance(field);
  const auto at = [&](Vec2 p) {
    const double c = std::clamp(std::floor((p.x - lattice.origin.x) / lattice.cell), 0.0, lattice.columns - 1.0);
    const double r = std::clamp(std::floor((p.y - lattice.origin.y) / lattice.cell), 0.0, lattice.rows - 1.0);
    return t[lattice.at(static_cast<std::int32_t>(c), static_cast<std::int32_t>(r))];
  };
  Vec2 p{x, y};
  const float start = at(p);
  if (start == Walkable::kClosed) return start;
  // Along the field until the rim, where distances are exact. No way on foot is longer than its weighted length.
  const double step = lattice.cell / 2, rim = 1.5 * lattice.cell;
  double walked = 0;
  while (walked < start) {
    const float left = at(p);
    if (left <= rim) return walked + left;
    const Region::Way d = way(field, static_cast<float>(p.x), static_cast<float>(p.y));
    p += step * Vec2{d.x, d.y}, walked += step;
  }
  return start;
}

}  // namespace inhabit::crowd
