#include "crowd/arrivals.h"

#include <doctest/doctest.h>

#include <cmath>

#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

scene::Source poisson(double rate) {
  scene::Source source = source_of("door", rectangle(0, 0, 2, 2), rate);
  source.arrivals = scene::Source::Arrivals::poisson;
  return source;
}

}  // namespace

TEST_CASE("even arrivals come at equal times from the first to the last") {
  scene::Source source = source_of("door", rectangle(0, 0, 2, 2), 4);
  source.from = 10, source.until = 12;
  Arrivals arrivals(source, 1, 0);
  CHECK(arrivals.due(9.99) == 0);
  CHECK(arrivals.due(10) == 1);
  CHECK(arrivals.due(10.2) == 0);
  CHECK(arrivals.due(11) == 4);
  CHECK_FALSE(arrivals.over());
  CHECK(arrivals.due(100) == 3);  // 11.25, 11.5, 11.75: nobody at 12
  CHECK(arrivals.over());
  source.count = 5, source.until.reset();
  CHECK(Arrivals(source, 1, 0).due(1e6) == 5);
  source.rate = 0;
  Arrivals never(source, 1, 0);
  CHECK(never.due(1e6) == 0);
  CHECK(never.over());
}

TEST_CASE("random arrivals are a Poisson process of the rate and differ by seed and source") {
  // Counts in 4,000 windows of 1 s: mean and variance are the rate. Standard errors: sqrt(3 / 4000) of the mean,
  // sqrt((3 + 2 * 9) / 4000) of the variance; four of them.
  Arrivals arrivals(poisson(3), 5, 2);
  double sum = 0, squares = 0;
  const int n = 4000;
  for (int k = 1; k <= n; ++k) {
    const auto count = static_cast<double>(arrivals.due(k));
    sum += count, squares += count * count;
  }
  const double mean = sum / n;
  CHECK(std::abs(mean - 3) < 4 * std::sqrt(3.0 / n));
  CHECK(std::abs(squares / n - mean * mean - 3) < 4 * std::sqrt(21.0 / n));
  const auto first_at = [](std::uint64_t seed, std::size_t number) {
    Arrivals a(poisson(1), seed, number);
    double t = 0;
    while (a.due(t) == 0) t += 1e-3;
    return t;
  };
  CHECK(first_at(1, 0) == first_at(1, 0));
  CHECK(first_at(1, 0) != first_at(2, 0));
  CHECK(first_at(1, 0) != first_at(1, 1));
}

TEST_CASE("people enter where there is room and wait outside where there is none") {
  scene::Scene scene = room_of(10, 10);
  scene.objects = {thing_of("table", {2, 1, 0.8}, {1.5, 1, 0})};
  const World world = *make_world(scene, 0.5);
  scene::Source source = source_of("door", rectangle(0, 0, 2, 2), 1000);
  source.count = 50;
  Gate gate(source, 0, world, 1, 0);
  Agents agents;
  std::uint32_t next_id = 7;
  gate.let_in(1, 0.25f, world, next_id, agents);
  const std::size_t inside = agents.size();
  CHECK(inside >= 2);  // centres lie in 0.5 m x 1.5 m beside the table, half a metre apart
  CHECK(inside <= 6);
  CHECK(gate.waiting() == 50 - inside);
  CHECK_FALSE(gate.finished());
  CHECK(next_id == 7 + inside);
  for (std::size_t i = 0; i < inside; ++i) {
    CHECK(agents.id[i] == 7 + i);
    CHECK(clear_of_walls(world.walls, agents.x[i], agents.y[i], 0.25f));
    CHECK(contains(source.area, world.to_scene(agents.x[i], agents.y[i])));
    for (std::size_t j = 0; j < i; ++j) CHECK(apart(agents.x[i] - agents.x[j], agents.y[i] - agents.y[j], 0.5f));
  }
  gate.let_in(2, 0.25f, world, next_id, agents);
  CHECK(agents.size() == inside);
  while (!gate.finished()) {
    agents = {};
    gate.let_in(3, 0.25f, world, next_id, agents);
    REQUIRE(agents.size() > 0);
  }
  CHECK(next_id == 57);
}
