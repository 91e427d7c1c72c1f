#include "crowd/neighbours.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"

using namespace inhabit::crowd;

namespace {

/// People at random, in clumps of a random scale; coordinates on a coarse raster now and then, so that ties happen.
Agents scattered(Rng& rng, std::size_t count) {
  Agents agents;
  const double size = std::pow(10.0, rng.uniform(-1, 2.5)), raster = rng.index(3) == 0 ? size / 8 : 0;
  const double stretch = std::pow(10.0, rng.uniform(-2, 0));
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = agents.add();
    double x = rng.uniform(-size, size), y = rng.uniform(-size, size) * stretch;
    if (raster > 0) x = std::round(x / raster) * raster, y = std::round(y / raster) * raster;
    agents.x[i] = static_cast<float>(x), agents.y[i] = static_cast<float>(y);
    agents.id[i] = static_cast<std::uint32_t>((k * 7919) % count);
  }
  return agents;
}

float distance2(const Agents& a, std::size_t i, std::size_t j) {
  const float dx = a.x[j] - a.x[i], dy = a.y[j] - a.y[i];
  return dx * dx + dy * dy;
}

}  // namespace

TEST_CASE("the nearest neighbours are those that brute force finds") {
  for (std::uint64_t n = 0; n < 300; ++n) {
    INFO("case ", n);
    Rng rng(4, n);
    Agents agents = scattered(rng, 1 + rng.index(200));
    Grid grid;
    sort_by_cell(agents, grid, static_cast<float>(std::pow(10.0, rng.uniform(-1, 1))), 1);
    const auto reach = static_cast<float>(std::pow(10.0, rng.uniform(-1, 2)));
    const int count = static_cast<int>(rng.index(NearestNeighbours::kMost + 1));
    NearestNeighbours nearest;
    for (std::size_t i = 0; i < agents.size(); ++i) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t j = 0; j < agents.size(); ++j)
        if (j != i && distance2(agents, i, j) <= reach * reach) expected.push_back(j);
      std::ranges::sort(expected, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(distance2(agents, i, a), agents.id[a]) < std::pair(distance2(agents, i, b), agents.id[b]);
      });
      expected.resize(std::min(expected.size(), static_cast<std::size_t>(count)));
      std::vector<std::uint32_t> found;
      for (const Neighbour& neighbour : nearest.find(grid, agents, i, reach, count)) found.push_back(neighbour.index);
      REQUIRE(found == expected);
    }
  }
}

TEST_CASE("everybody within reach is visited once and in order") {
  for (std::uint64_t n = 0; n < 300; ++n) {
    INFO("case ", n);
    Rng rng(5, n);
    Agents agents = scattered(rng, 1 + rng.index(200));
    Grid grid;
    sort_by_cell(agents, grid, static_cast<float>(std::pow(10.0, rng.uniform(-1, 1))), 1);
    const auto reach = static_cast<float>(std::pow(10.0, rng.uniform(-1, 2)));
    for (std::size_t i = 0; i < agents.size(); ++i) {
      std::vector<std::uint32_t> expected, found;
      for (std::uint32_t j = 0; j < agents.size(); ++j)
        if (j != i && distance2(agents, i, j) <= reach * reach) expected.push_back(j);
      for_each_within(grid, agents, i, reach, [&](std::uint32_t j, float dx, float dy, float d2) {
        found.push_back(j);
        CHECK(dx == agents.x[i] - agents.x[j]);
        CHECK(dy == agents.y[i] - agents.y[j]);
        CHECK(d2 == distance2(agents, i, j));
      });
      REQUIRE(found == expected);
    }
  }
}

TEST_CASE("blocks cover everybody once at any number of threads") {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kAgentBlock, kAgentBlock + 1, 5 * kAgentBlock}) {
    for (const int threads : {1, 2, 8}) {
      std::vector<int> visits(count);
      for_each_block(count, threads, [&](std::size_t block, std::size_t begin, std::size_t end) {
        CHECK(block < block_count(count));
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      CHECK(std::ranges::all_of(visits, [](int v) { return v == 1; }));
    }
  }
}
