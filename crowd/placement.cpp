#include "crowd/placement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "crowd/people.h"

namespace inhabit::crowd {
namespace {

/// Nobody is moved farther than this from his point: so many radii, or so many metres.
constexpr double kFarthestRadii = 20, kFarthest = 5;
/// Places that may be looked at for those who must be moved, for a whole population: about a second.
constexpr std::size_t kBudget = 20'000'000;
/// A dart that hits somebody so often in a row says that the area is full.
constexpr int kThrows = 500;
/// Grids have at most so many points; a spacing of a millimetre in a hall is a mistake.
constexpr double kMostPoints = 2e7;

/// One population's way into the agents.
struct Taker {
  const scene::Population& population;
  std::uint16_t route;
  const World& world;
  std::uint64_t seed;
  std::uint32_t& next_id;
  Spots& spots;
  Agents& agents;

  void place(const Person& person, float x, float y) {
    spots.add(x, y, person.radius);
    add_person(agents, person, next_id++, route, x, y);
  }
  Vec2 relative(Vec2 p) const { return p - world.origin; }
};

void place_on_grid(Taker& taker, Intake& intake) {
  std::vector<Vec2> points = grid_points(taker.population, taker.seed, taker.next_id);
  intake.asked = taker.population.count ? static_cast<std::size_t>(*taker.population.count) : points.size();
  if (points.size() > intake.asked) points.resize(intake.asked);
  taker.agents.reserve(taker.agents.size() + points.size());  // no more than needed: they stay as long as the run
  std::size_t budget = kBudget;
  // Whoever is in nobody's way stays where he is; the others must not take those places.
  std::vector<Vec2> homeless;
  for (const Vec2 point : points) {
    const Vec2 p = taker.relative(point);
    const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
    const Person person = make_person(taker.population, taker.seed, taker.next_id);
    if (taker.spots.free(x, y, person.radius)) {
      taker.place(person, x, y);
    } else {
      homeless.push_back(p);
    }
  }
  for (const Vec2 p : homeless) {
    const Person person = make_person(taker.population, taker.seed, taker.next_id);
    const double farthest = std::max(kFarthest, kFarthestRadii * person.radius);
    const std::optional<Vec2> spot =
        taker.spots.nearest_free(static_cast<float>(p.x), static_cast<float>(p.y), person.radius, farthest, budget);
    if (!spot) continue;
    taker.place(person, static_cast<float>(spot->x), static_cast<float>(spot->y));
    ++intake.moved;
  }
}

/// Throws discs into the area until all are in or one hits somebody too often.
void throw_darts(Taker& taker, const Bounds& box, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const Person person = make_person(taker.population, taker.seed, taker.next_id);
    Rng rng = draw(taker.seed, Draw::place, taker.next_id);
    bool placed = false;
    for (int t = 0; t < kThrows && !placed; ++t) {
      const double px = rng.uniform(box.min.x, box.max.x), py = rng.uniform(box.min.y, box.max.y);
      if (!contains(taker.population.area, Vec2{px, py})) continue;
      const Vec2 p = taker.relative({px, py});
      const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
      placed = taker.spots.free(x, y, person.radius);
      if (placed) taker.place(person, x, y);
    }
    if (!placed) return;
  }
}

/// The free points of a lattice of hexagons, `pitch` from one to the next, row by row.
std::vector<Vec2> hexagon_points(const Taker& taker, const Bounds& box, double radius, double pitch) {
  std::vector<Vec2> points;
  const double high = pitch * 0.8660254037844386;
  const Vec2 size = box.size();
  if (!(size.x / pitch * (size.y / high) < kMostPoints)) return points;
  // The area may end at a wall, so the first discs stand a radius inside its box.
  for (int row = 0; box.min.y + radius + row * high <= box.max.y; ++row)
    for (double x = box.min.x + radius + (row % 2 == 0 ? 0 : pitch / 2); x <= box.max.x; x += pitch) {
      const Vec2 point{x, box.min.y + radius + row * high};
      if (!contains(taker.population.area, point)) continue;
      const Vec2 p = taker.relative(point);
      if (taker.spots.free(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(radius)))
        points.push_back(p);
    }
  return points;
}

struct Lattice {
  std::vector<Vec2> points;
  double play = 0;  ///< how far everybody may be moved so that half of each gap is left, metres
};
/// The widest lattice that holds so many, to a hundredth of a diameter; the densest there is when none does.
Lattice widest_lattice(const Taker& taker, const Bounds& box, double radius, std::size_t count) {
  const auto lattice = [&](int hundredths) {
    const double pitch = 2 * radius * (1 + 0.01 * hundredths);
    return Lattice{hexagon_points(taker, box, radius, pitch), (pitch / 2 - radius) / 2};
  };
  Lattice best = lattice(0);
  // Whoever needs more room than half a diameter has it: darts could place everybody.
  int holds = 0, fails = 51;
  while (best.points.size() >= count && fails - holds > 1) {
    const int middle = (holds + fails) / 2;
    Lattice wider = lattice(middle);
    if (wider.points.size() >= count)
      best = std::move(wider), holds = middle;
    else
      fails = middle;
  }
  return best;
}

void place_at_random(Taker& taker, Intake& intake) {
  intake.asked = static_cast<std::size_t>(std::max(0, taker.population.count.value_or(0)));
  if (intake.asked == 0) return;
  const Bounds box = bounds(taker.population.area);
  const std::size_t others = taker.agents.size(), spots = taker.spots.size();
  const std::uint32_t first_id = taker.next_id;
  throw_darts(taker, box, intake.asked);
  const std::size_t thrown = taker.agents.size() - others;
  if (thrown == intake.asked) return;

  const Spots with_darts = taker.spots;
  taker.spots.shrink(spots);
  Lattice lattice = widest_lattice(taker, box, taker.population.radius.high, intake.asked);
  std::vector<Vec2>& points = lattice.points;
  if (points.size() <= thrown) {
    taker.spots = with_darts;
    return;
  }
  // All who fit, on points that are drawn without putting back.
  std::vector<std::uint8_t> gone(taker.agents.size(), 0);
  std::fill(gone.begin() + static_cast<std::ptrdiff_t>(others), gone.end(), std::uint8_t{1});
  taker.agents.remove(gone), taker.next_id = first_id;
  Rng rng = draw(taker.seed, Draw::place, first_id);
  const std::size_t count = std::min(points.size(), intake.asked);
  for (std::size_t k = 0; k < count; ++k) {
    std::swap(points[k], points[k + rng.index(static_cast<std::uint32_t>(points.size() - k))]);
    const Person person = make_person(taker.population, taker.seed, taker.next_id);
    // Out of the lattice's rows, unless a wall or another population is there.
    const Vec2 moved = points[k] + rng.uniform(0, lattice.play) * direction(rng.uniform(0, 2 * kPi));
    const auto x = static_cast<float>(moved.x), y = static_cast<float>(moved.y);
    if (taker.spots.free(x, y, person.radius) && contains(taker.population.area, moved + taker.world.origin))
      taker.place(person, x, y);
    else
      taker.place(person, static_cast<float>(points[k].x), static_cast<float>(points[k].y));
  }
}

}  // namespace

std::vector<Vec2> grid_points(const scene::Population& population, std::uint64_t seed, std::uint32_t first_id) {
  std::vector<Vec2> points;
  if (population.area.size() < 3 || !population.spacing || !(*population.spacing > 0)) return points;
  const double spacing = *population.spacing;
  const Bounds box = bounds(population.area);
  // A box of 0.3 holds three cells of 0.1, whatever rounding says.
  const auto cells = [&](double length) { return std::max(1.0, std::floor(length / spacing + 1e-6)); };
  const double columns = cells(box.size().x), rows = cells(box.size().y);
  if (!(columns * rows < kMostPoints)) return points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 centre = box.min + Vec2{(column + 0.5) * spacing, (row + 0.5) * spacing};
      if (!contains(population.area, centre)) continue;
      Rng rng = draw(seed, Draw::place, first_id + points.size());
      const double dx = rng.uniform(-1, 1), dy = rng.uniform(-1, 1);
      points.push_back(centre + population.jitter * Vec2{dx, dy});
    }
  return points;
}

Intake place_population(const scene::Population& population, std::uint16_t route, const World& world,
                        std::uint64_t seed, std::uint32_t& next_id, Spots& spots, Agents& agents) {
  Intake intake{population.id};
  Taker taker{population, route, world, seed, next_id, spots, agents};
  const std::size_t before = agents.size();
  if (population.area.size() < 3) {
    intake.asked = static_cast<std::size_t>(std::max(0, population.count.value_or(0)));
  } else if (population.spacing) {
    place_on_grid(taker, intake);
  } else {
    place_at_random(taker, intake);
  }
  intake.placed = agents.size() - before;
  return intake;
}

void start_walking(std::span<const scene::Population> populations, std::span<const Intake> intakes, Agents& agents) {
  INHABIT_ASSERT(populations.size() == intakes.size());
  std::size_t i = 0;
  for (std::size_t k = 0; k < populations.size(); ++k)
    for (const std::size_t end = i + intakes[k].placed; i < end; ++i)
      if (populations[k].walking) agents.vx[i] = agents.wish_x[i], agents.vy[i] = agents.wish_y[i];
}

std::optional<Vec2> point_inside(const World& world, const Ring& area) {
  if (area.size() < 3) return std::nullopt;
  const Bounds box = bounds(area);
  const Vec2 centre = box.center();
  std::optional<Vec2> best;
  double nearest = 0;
  // Odd, so that the centre is one of the points.
  constexpr int kSide = 33;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const Vec2 p = box.min + Vec2{box.size().x * (column + 0.5) / kSide, box.size().y * (row + 0.5) / kSide};
      const Vec2 r = p - world.origin;
      if (!contains(area, p) || !world.walls.on_floor(static_cast<float>(r.x), static_cast<float>(r.y))) continue;
      const double distance = length(p - centre);
      if (!best || distance < nearest) best = r, nearest = distance;
    }
  return best;
}

}  // namespace inhabit::crowd
