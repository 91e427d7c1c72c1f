#include "crowd/simulation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/test_data.h"
#include "crowd/test_rooms.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

/// A corridor with people walking east and others that come in from the east and walk west.
scene::Scene corridor() {
  scene::Scene scene = room_of(30, 6);
  scene.space.holes.push_back({"pillar", rectangle(14, 2.5, 15, 3.5), {}});
  scene.crowd.goals = {goal_of("east", rectangle(29, 0, 30, 6)), goal_of("west", rectangle(0, 0, 1, 6))};
  scene.crowd.populations = {grid_of("walkers", rectangle(2, 0.5, 8, 5.5), 1, "east")};
  scene.crowd.sources = {source_of("entrance", rectangle(26, 1, 28, 5), 1.5, "west")};
  scene.crowd.sources[0].count = 6;
  scene.crowd.sources[0].arrivals = scene::Source::Arrivals::poisson;
  return scene;
}

/// Everybody's position by number, bit for bit.
std::vector<std::array<float, 4>> by_number(const Agents& agents) {
  std::vector<std::uint32_t> order(agents.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return agents.id[i]; });
  std::vector<std::array<float, 4>> rows;
  for (const std::uint32_t i : order)
    rows.push_back({static_cast<float>(agents.id[i]), agents.x[i], agents.y[i], agents.radius[i]});
  return rows;
}

std::string error_of(const scene::Scene& scene, const Settings& settings = {}) {
  const Result<Simulation> simulation = Simulation::make(scene, settings);
  REQUIRE_FALSE(simulation.ok());
  return simulation.error().text();
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// With avoidance: contacts alone leave two who meet head-on face to face, for minutes.
scene::PbdModel avoiding() {
  scene::PbdModel model;
  model.far = 2;
  return model;
}

const std::vector<scene::CrowdModel> kModels = {avoiding(), scene::PowerLawModel{}, scene::SocialForceModel{},
                                                scene::OrcaModel{}};

}  // namespace

TEST_CASE("people come and go and nobody is lost or put back with any model") {
  const scene::Scene scene = corridor();
  for (const scene::CrowdModel& model : kModels) {
    Settings settings;
    settings.model = model;
    Result<Simulation> made = Simulation::make(scene, settings);
    REQUIRE(made.ok());
    Simulation& simulation = *made;
    CHECK(simulation.agents().size() == 30);
    CHECK(simulation.intakes()[0].placed == 30);
    while (!simulation.finished() && simulation.time() < 120) {
      simulation.step();
      const Agents& agents = simulation.agents();
      REQUIRE(simulation.people() == agents.size() + simulation.arrived());
      for (std::size_t i = 0; i < agents.size(); ++i)
        REQUIRE(simulation.world().walls.on_floor(agents.x[i], agents.y[i]));
    }
    CAPTURE(model.index());
    CHECK(simulation.people() == 36);
    CHECK(simulation.arrived() == 36);
    CHECK(simulation.put_back() == 0);
    CHECK(simulation.time() == doctest::Approx(static_cast<double>(simulation.steps()) / 48));
  }
}

TEST_CASE("the same seed gives the same bytes at any number of threads with every model") {
  scene::Scene scene = corridor();
  // Enough for several blocks of every loop, 512 people each.
  const double spacing = core::kSlowBuild ? 3 : 1.5;
  scene.space.outline = rectangle(0, 0, 160, 160);
  scene.space.holes[0].outline = rectangle(70, 70, 90, 90);
  scene.crowd.goals[0].area = rectangle(159, 0, 160, 160);
  scene.crowd.populations = {grid_of("walkers", rectangle(1, 1, 151, 151), spacing, "east")};
  scene.crowd.populations[0].jitter = 0.4;
  for (const scene::CrowdModel& model : kModels) {
    std::vector<std::array<float, 4>> first;
    for (const int threads : {1, 2, 8}) {
      Settings settings;
      settings.model = model, settings.threads = threads;
      Result<Simulation> simulation = Simulation::make(scene, settings);
      REQUIRE(simulation.ok());
      for (int k = 0; k < 4; ++k) simulation->step();
      const auto rows = by_number(simulation->agents());
      REQUIRE(rows.size() > (core::kSlowBuild ? 2000 : 9000));
      if (threads == 1) first = rows;
      CHECK(rows == first);
    }
  }
}

TEST_CASE("populations that start walking have their wish as velocity before the first step and the others none") {
  scene::Scene scene = corridor();
  scene.crowd.populations.push_back(grid_of("resting", rectangle(17, 1, 20, 5), 1, "west"));
  scene.crowd.populations[0].walking = true;
  Result<Simulation> simulation = Simulation::make(scene, {});
  REQUIRE(simulation.ok());
  const Agents& agents = simulation->agents();
  REQUIRE(simulation->intakes()[0].placed == 30);
  REQUIRE(agents.size() == 42);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const double speed = std::hypot(agents.vx[i], agents.vy[i]);
    CHECK(speed == doctest::Approx(i < 30 ? agents.preferred_speed[i] : 0).epsilon(1e-6));
    if (i < 30) CHECK(agents.vx[i] > 0);
  }
  // Who starts at rest is slower after a step: alpha = dt / xi is far from 1.
  simulation->step();
  for (std::size_t i = 0; i < agents.size(); ++i)
    CHECK((std::hypot(agents.vx[i], agents.vy[i]) > 0.5) == (agents.id[i] < 30));
}

TEST_CASE("another seed gives other people") {
  const scene::Scene scene = corridor();
  Settings settings;
  settings.seed = 2;
  CHECK(Simulation::make(scene, {})->agents().preferred_speed !=
        Simulation::make(scene, settings)->agents().preferred_speed);
}

TEST_CASE("steps that are too long or no steps are refused") {
  scene::Scene scene = corridor();
  for (const double step : {0.0, -0.1, 1.01, 1e9, std::nan("")}) {
    Settings settings;
    settings.step = step;
    CHECK(has(error_of(scene, settings), "at most 1 s"));
  }
  scene.crowd.step = 2;
  CHECK(has(error_of(scene), "/crowd/step: "));
  Settings settings;
  settings.step = 1;
  CHECK(Simulation::make(scene, settings).ok());
}

TEST_CASE("long steps and impossible starts keep everybody on the floor with every model") {
  scene::Scene scene = corridor();
  scene.crowd.populations.push_back(grid_of("in the way", rectangle(13, 2, 16, 4), 0.5, "west"));
  for (const scene::CrowdModel& model : kModels)
    for (const double step : {1.0 / 100, 1.0 / 12, 1.0}) {
      Settings settings;
      settings.model = model, settings.step = step;
      Result<Simulation> simulation = Simulation::make(scene, settings);
      REQUIRE(simulation.ok());
      for (int k = 0; k < 60; ++k) simulation->step();
      const Agents& agents = simulation->agents();
      for (std::size_t i = 0; i < agents.size(); ++i)
        REQUIRE(simulation->world().walls.on_floor(agents.x[i], agents.y[i]));
    }
}

TEST_CASE("scenes without people and populations without anybody") {
  scene::Scene scene = room_of(5, 5);
  CHECK(has(error_of(scene), "no people"));
  scene.crowd.populations = {grid_of("nobody", rectangle(1, 1, 4, 4), 1)};
  scene.crowd.populations[0].count = 0;
  Result<Simulation> simulation = Simulation::make(scene, {});
  REQUIRE(simulation.ok());
  CHECK(simulation->finished());
  simulation->step();
  CHECK(simulation->agents().empty());
  CHECK(simulation->intakes()[0].asked == 0);
}

TEST_CASE("goals that nobody can reach are named before the run starts") {
  scene::Scene scene = corridor();
  scene.crowd.sources.clear();
  scene.objects = {thing_of("wall", {6, 0.5, 2.5}, {20, 3, 0})};  // across the corridor
  CHECK(has(error_of(scene), "/crowd/populations/0/goal: nobody can get from population \"walkers\" to \"east\""));
  // Half of them can.
  scene.crowd.populations = {grid_of("walkers", rectangle(17, 0.5, 23, 5.5), 1, "east")};
  const Result<Simulation> some = Simulation::make(scene, {});
  REQUIRE(some.ok());
  CHECK(some->intakes()[0].unreachable > 0);
  CHECK(some->intakes()[0].unreachable < some->intakes()[0].placed);
  // The second leg.
  scene.crowd.populations = {grid_of("walkers", rectangle(2, 0.5, 8, 5.5), 1)};
  scene.crowd.populations[0].goal.legs = {{"west"}, {"east"}};
  CHECK(has(error_of(scene), "nobody can get from \"west\" to \"east\""));
  // Sources.
  scene = corridor();
  scene.crowd.sources[0].area = rectangle(40, 0, 42, 2);
  CHECK(has(error_of(scene), "/crowd/sources/0/area: no floor"));
  scene = corridor();
  scene.objects = {thing_of("wall", {6, 0.5, 2.5}, {20, 3, 0})};
  scene.crowd.populations.clear();
  CHECK(has(error_of(scene), "source \"entrance\" to \"west\""));
}

TEST_CASE("people from a source enter walking and the time they come at does not depend on the step") {
  scene::Scene scene = corridor();
  scene.crowd.populations.clear();
  std::vector<std::size_t> counts;
  for (const double step : {1.0 / 48, 1.0 / 12}) {
    Settings settings;
    settings.step = step;
    Result<Simulation> simulation = Simulation::make(scene, settings);
    REQUIRE(simulation.ok());
    while (simulation->time() < 2) simulation->step();
    counts.push_back(simulation->people());
  }
  CHECK(counts[0] == counts[1]);
  CHECK(counts[0] > 0);
}
