#include <doctest/doctest.h>

#include <cstdlib>

#include "core/test_data.h"
#include "core/text.h"
#include "crowd/model_table.h"
#include "crowd/safety.h"
#include "crowd/test_crowds.h"

/// Random configurations of every model: the suite takes some, `INHABIT_SOAK_CONFIGURATIONS=1000000 crowd_tests
/// -tc="random configurations*"` as many as one likes.
using namespace inhabit::crowd;
using namespace inhabit::crowd::testing;

namespace {

constexpr int kSteps = 20;
constexpr double kFastest = 2, kRoom = 6;

std::uint64_t configurations() {
  if (const char* count = std::getenv("INHABIT_SOAK_CONFIGURATIONS")) return std::strtoull(count, nullptr, 10);
  return inhabit::core::kSlowBuild ? 100 : 1000;
}

/// Open ground, a room with a pillar and a thin partition, a corridor that ends in a wedge.
const std::vector<Walls>& places() {
  static const std::vector<Walls> walls = [] {
    std::vector<Walls> list;
    list.emplace_back();
    list.push_back(room(kRoom, kRoom, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{4, 0.5}, {4.05, 0.5}, {4.05, 4}, {4, 4}}}));
    list.push_back(Walls({make_floor({{0, 0}, {4, 0}, {6, 0.9}, {6, 1.1}, {4, 2}, {0, 2}}, {})}, {}, 5));
    return list;
  }();
  return walls;
}

/// Radii of 0.05 to 1 m, masses of 1 to 1000, some on one point, some thrown at 100 m/s, some in walls.
Agents any_crowd(Rng& rng, const Walls& walls) {
  Agents agents;
  const double side = rng.uniform(0.1, kRoom);
  const std::uint32_t count = 2 + rng.index(30);
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool pile = k > 0 && !agents.empty() && rng.uniform() < 0.3;
    const Vec2 p = pile ? Vec2{agents.x[0], agents.y[0]} : Vec2{rng.uniform(0, side), rng.uniform(0, side)};
    if (!walls.on_floor(static_cast<float>(p.x), static_cast<float>(p.y))) continue;
    const Vec2 wish = rng.uniform() < 0.1 ? Vec2{} : Vec2{rng.uniform(-1.4, 1.4), rng.uniform(-1.4, 1.4)};
    const std::size_t i = add_agent(agents, p, wish, 0.05 * std::pow(20, rng.uniform()));
    agents.mass[i] = static_cast<float>(std::pow(1000, rng.uniform()));
    agents.maximum_speed[i] = static_cast<float>(kFastest);
    agents.vx[i] = static_cast<float>(rng.uniform(-100, 100)), agents.vy[i] = static_cast<float>(rng.uniform(-2, 2));
    agents.kept_x[i] = agents.x[i], agents.kept_y[i] = agents.y[i];
  }
  return agents;
}

/// Seven of ten are pbd, with everything that can be switched on or off at random.
Models any_model(Rng& rng) {
  switch (rng.index(10)) {
    case 0:
      return Models(std::in_place_type<PowerLaw>, inhabit::scene::PowerLawModel{});
    case 1:
      return Models(std::in_place_type<SocialForce>, inhabit::scene::SocialForceModel{});
    case 2:
      return Models(std::in_place_type<Orca>, inhabit::scene::OrcaModel{});
    default:
      break;
  }
  inhabit::scene::PbdModel pbd;
  pbd.far = static_cast<int>(rng.index(3));
  pbd.headway = rng.index(2), pbd.cohesion = 0.5 * rng.index(2), pbd.stability_iterations = rng.index(2);
  pbd.sub_steps = 1 + static_cast<int>(rng.index(8)), pbd.iterations = 1 + static_cast<int>(rng.index(8));
  return Models(std::in_place_type<Pbd>, pbd);
}

/// What is wrong with the state; empty when nothing is. The farthest that somebody may be from where all began: the way
/// walked, and once in a step the radii's sum by which an overlap may be taken out.
std::string fault_of(const Agents& agents, const Walls& walls, double dt, int step) {
  const double farthest = kRoom * std::sqrt(2) + step * (kFastest * dt + 2);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (!std::isfinite(agents.x[i] + agents.y[i] + agents.vx[i] + agents.vy[i])) return "a number that is none";
    if (std::hypot(agents.vx[i], agents.vy[i]) > kFastest * (1 + 1e-4)) return "somebody faster than his maximum";
    if (std::hypot(agents.x[i], agents.y[i]) > farthest) return "somebody was thrown away";
    if (!walls.on_floor(agents.x[i], agents.y[i])) return "somebody in a wall";
  }
  return {};
}

std::string fault_of_configuration(std::uint64_t number) {
  Rng rng(74, number);
  const Walls& walls = places()[rng.index(static_cast<std::uint32_t>(places().size()))];
  Agents agents = any_crowd(rng, walls);
  Models model = any_model(rng);
  const auto dt = static_cast<float>(1 / rng.uniform(12, 100));
  for (int step = 1; step <= kSteps; ++step) {
    std::visit([&](auto& m) { m.step(agents, {walls, dt, 1}); }, model);
    // Before the simulation's net: no model may need it to stay finite.
    if (!all_finite(agents)) return "a number that is none, before anybody is put back";
    keep_on_floor(agents, walls, 1);
    if (std::string fault = fault_of(agents, walls, dt, step); !fault.empty())
      return fault + ", step " + std::to_string(step) + ", model " + std::to_string(model.index());
  }
  return {};
}

}  // namespace

TEST_CASE("random configurations of any model with any masses radii steps and walls stay finite and on the floor") {
  const std::uint64_t count = configurations();
  for (std::uint64_t number = 1; number <= count; ++number) {
    const std::string fault = fault_of_configuration(number);
    CHECK_MESSAGE(fault.empty(), "configuration ", number, ": ", fault);
    if (count > 10000 && number % 50000 == 0) MESSAGE(number << " configurations");
  }
}
