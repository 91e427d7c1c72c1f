#include "geometry/eikonal.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/rng.h"

using namespace inhabit::geometry;

namespace {

constexpr float kClosed = std::numeric_limits<float>::infinity();

/// Seeds with exact distances to `source` in a small disc round it.
std::vector<MarchSeed> point_seeds(const Lattice& lattice, Vec2 source, double radius) {
  std::vector<MarchSeed> seeds;
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const double d = length(lattice.center(k) - source);
    if (d <= radius) seeds.push_back({static_cast<std::uint32_t>(k), static_cast<float>(d)});
  }
  return seeds;
}

}  // namespace

TEST_CASE("a march over the open plane finds the distance to a point to second order") {
  double before = 0;
  for (const double h : {0.2, 0.1, 0.05}) {
    const auto n = static_cast<std::int32_t>(std::lround(20 / h));
    const Lattice lattice{{-10, -10}, h, n, n};
    const Vec2 source{1.03, -2.01};
    const auto t = march(lattice, std::vector<float>(lattice.size(), 1), point_seeds(lattice, source, 1));
    double worst = 0, slant = 0;
    for (std::size_t k = 0; k < lattice.size(); ++k) {
      const Vec2 away = lattice.center(k) - source;
      worst = std::max(worst, std::abs(t[k] - length(away)));
      if (length(away) > 1 + 2 * h) slant = std::max(slant, length(descent(lattice, t, k) + unit(away)));
    }
    // The differences' error is h^2 / r^2 per metre, r the distance from the point; it sums up to about h^2.
    CHECK(worst < h * h);
    CHECK(slant < 0.8 * h);
    if (before > 0) CHECK(worst < before / 2.5);
    before = worst;
  }
}

TEST_CASE("a march bends round a wall and never enters closed cells") {
  // A wall at x = 0 from y = 0 upwards; from (-4, 2) to (4, 2) the way leads round its end.
  const double h = 0.05;
  const Lattice lattice{{-5, -5}, h, 200, 200};
  std::vector<float> cost(lattice.size(), 1);
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const Vec2 p = lattice.center(k);
    if (std::abs(p.x) < h && p.y > 0) cost[k] = kClosed;
  }
  const Vec2 source{-4, 2};
  const auto t = march(lattice, cost, point_seeds(lattice, source, 0.5));
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const Vec2 p = lattice.center(k);
    if (cost[k] == kClosed) {
      CHECK(t[k] == kClosed);
      continue;
    }
    // The wall is two cells thick: the way round it is bounded by those round its middle line and round its corners.
    const bool hidden = p.x > 0 && cross(Vec2{h, 0} - source, p - source) > 0;
    const double low = hidden ? length(source) + length(p) : length(p - source);
    const double high = hidden ? length(source - Vec2{-h, 0}) + 2 * h + length(p - Vec2{h, 0}) : length(p - source);
    CHECK(t[k] > low - 2.5 * h);
    CHECK(t[k] < high + 2.5 * h);
  }
}

TEST_CASE("a march takes the nearest seed and leaves what no way leads to infinite") {
  const Lattice lattice{{0, 0}, 0.1, 200, 50};
  std::vector<float> cost(lattice.size(), 1);
  for (std::int32_t row = 0; row < 50; ++row) cost[lattice.at(150, row)] = kClosed;
  const std::vector<MarchSeed> seeds = {{static_cast<std::uint32_t>(lattice.at(0, 25)), 0},
                                        {static_cast<std::uint32_t>(lattice.at(100, 25)), 2}};
  const auto t = march(lattice, cost, seeds);
  CHECK(t[lattice.at(0, 25)] == 0);
  CHECK(t[lattice.at(100, 25)] == 2);
  // Along the line between the two the seeds meet where 0.1 c = 2 + 0.1 (100 - c), at c = 60.
  CHECK(t[lattice.at(40, 25)] == doctest::Approx(4).epsilon(1e-4));
  CHECK(t[lattice.at(80, 25)] == doctest::Approx(4).epsilon(1e-4));
  CHECK(descent(lattice, t, lattice.at(59, 25)).x < 0);
  CHECK(descent(lattice, t, lattice.at(62, 25)).x > 0);
  for (std::int32_t column = 150; column < 200; ++column) {
    CHECK(t[lattice.at(column, 10)] == kClosed);
    CHECK(descent(lattice, t, lattice.at(column, 10)) == Vec2{});
  }
}

TEST_CASE("marched distances solve the equation wherever costs are smooth") {
  // |grad T| = cost, by central differences that the solver does not use; kinks are left out.
  const double h = 0.05;
  const Lattice lattice{{0, 0}, h, 240, 160};
  std::vector<float> cost(lattice.size());
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const Vec2 p = lattice.center(k);
    cost[k] = static_cast<float>(1.5 + 0.5 * std::sin(p.x) * std::cos(p.y));
  }
  const auto t = march(lattice, cost, point_seeds(lattice, {0.5, 0.5}, 0.05));
  std::size_t wrong = 0, asked = 0;
  for (std::int32_t row = 30; row + 1 < lattice.rows; ++row)
    for (std::int32_t column = 30; column + 1 < lattice.columns; ++column) {
      const std::size_t k = lattice.at(column, row);
      const auto up = static_cast<std::size_t>(lattice.columns);
      const double slope = std::hypot(t[k + 1] - t[k - 1], t[k + up] - t[k - up]) / (2 * h);
      ++asked;
      if (std::abs(slope - cost[k]) > 0.02 * cost[k]) ++wrong;
    }
  CHECK(wrong < asked / 100);  // the kink where ways round the slow hill meet
}
