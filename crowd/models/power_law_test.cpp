#include "crowd/models/power_law.h"

#include <doctest/doctest.h>

#include "crowd/test_crowds.h"

using namespace inhabit::crowd;
using namespace inhabit::crowd::testing;

namespace {

const PowerLaw::Parameters kModel;

/// -grad E by central differences, E(tau(x)) through `tau_of(x)`.
template <class F>
Vec2 numerical_force(Vec2 x, F&& tau_of) {
  const double h = 1e-6;
  const auto energy = [&](Vec2 at) { return power_law_energy(kModel, tau_of(at)); };
  return {-(energy(x + Vec2{h, 0}) - energy(x - Vec2{h, 0})) / (2 * h),
          -(energy(x + Vec2{0, h}) - energy(x - Vec2{0, h})) / (2 * h)};
}

/// What one step makes of the velocities, in order of id, when everybody walks as they wish.
std::vector<Vec2> accelerations(Agents agents, const Walls& walls, float dt = 1e-3f) {
  for (std::size_t i = 0; i < agents.size(); ++i) agents.vx[i] = agents.wish_x[i], agents.vy[i] = agents.wish_y[i];
  const Agents before = agents;
  PowerLaw(kModel).step(agents, {walls, dt, 1});
  std::vector<Vec2> result;
  const auto index = index_of(agents);
  for (std::size_t k = 0; k < agents.size(); ++k)
    result.push_back((1.0 / dt) * (velocity(agents, index[k]) - velocity(before, k)));
  return result;
}

}  // namespace

TEST_CASE("the force is the slope of the energy") {
  int meetings = 0;
  for (std::uint64_t n = 0; n < 5000; ++n) {
    INFO("case ", n);
    Rng rng(41, n);
    const Vec2 x{rng.uniform(-8, 8), rng.uniform(-8, 8)};
    // Every other pair head-on.
    const Vec2 v = n % 2 == 0 ? -rng.uniform(0.5, 3) * unit(x) : Vec2{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const double R = rng.uniform(0.2, 1.5);
    const auto meeting = encounter(x, v, R);
    if (!meeting || meeting->time < 0.05) continue;
    // A grazing pair's energy has no slope to measure: sqrt(d) -> 0.
    if (length(meeting->gradient) > 20) continue;
    ++meetings;
    const Vec2 expected = numerical_force(x, [&](Vec2 at) { return encounter(at, v, R)->time; });
    CHECK(length(power_law_force(kModel, *meeting) - expected) <= 1e-4 * length(expected));
    CHECK(std::abs(length(x + meeting->time * v) - R) < 1e-9);
  }
  CHECK(meetings > 2500);
}

TEST_CASE("a head-on pair 4 m apart that closes in at 3 m per second meets after a second") {
  // Two of radius 0.5: E = 1.5 exp(-1/3), F = E (2 + 1/3) / 3.
  const auto meeting = encounter({4, 0}, {-3, 0}, 1);
  REQUIRE(meeting);
  CHECK(std::abs(meeting->time - 1) < 1e-14);
  const double energy = 1.5 * std::exp(-1.0 / 3);
  CHECK(std::abs(power_law_energy(kModel, 1) - energy) < 1e-14);
  CHECK(length(power_law_force(kModel, *meeting) - Vec2{energy * (2 + 1.0 / 3) / 3, 0}) < 1e-14);
}

TEST_CASE("pairs that part or miss or touch do not interact") {
  CHECK(!encounter({4, 0}, {3, 0}, 1));
  CHECK(!encounter({4, 0}, {}, 1));
  CHECK(!encounter({4, 1.001}, {-3, 0}, 1));
  CHECK(encounter({4, 0.999}, {-3, 0}, 1));
  CHECK(!encounter({0.5, 0}, {-3, 0}, 1));
  CHECK(!encounter({}, {}, 1));
}

TEST_CASE("near collisions the energy is the inverse square of time and far ones are screened") {
  // d ln E / d ln tau -> -2 for tau << tau_0; E(tau) tau^2 falls by e in tau_0.
  const auto slope = [](double tau) {
    return (std::log(power_law_energy(kModel, 1.001 * tau)) - std::log(power_law_energy(kModel, tau))) /
           std::log(1.001);
  };
  CHECK(std::abs(slope(1e-4) + 2) < 1e-4);
  CHECK(std::abs(slope(1e-2) + 2) < 1e-2);
  CHECK(std::abs(power_law_energy(kModel, 6) * 36 / (power_law_energy(kModel, 3) * 9) - std::exp(-1)) < 1e-12);
  // The force of a head-on pair goes with tau^-3: eightfold at half the time.
  const auto force = [](double tau) { return power_law_force(kModel, *encounter({1 + 2 * tau, 0}, {-2, 0}, 1)).x; };
  CHECK(std::abs(force(1e-4) / force(2e-4) - 8) < 1e-3);
}

TEST_CASE("walls are met where the disc first touches them") {
  int meetings = 0;
  for (std::uint64_t n = 0; n < 8000; ++n) {
    INFO("case ", n);
    Rng rng(42, n);
    const Vec2 a{rng.uniform(-3, 3), rng.uniform(-3, 3)}, b{rng.uniform(-3, 3), rng.uniform(-3, 3)};
    const Vec2 p{rng.uniform(-5, 5), rng.uniform(-5, 5)}, v{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const double r = rng.uniform(0.1, 1);
    const auto gap = [&](double t) { return length(p + t * v - nearest_on_segment(a, b, p + t * v)) - r; };
    if (gap(0) <= 0.01 || cross(b - a, p - a) <= 0) continue;
    const auto meeting = encounter(p, v, r, a, b);
    double nearest = 1e9;
    for (int k = 0; k <= 2000; ++k) nearest = std::min(nearest, gap(0.01 * k));
    if (nearest < -1e-3) REQUIRE(meeting);
    if (nearest > 1e-3 && meeting) CHECK(meeting->time > 20);
    if (!meeting) continue;
    ++meetings;
    CHECK(std::abs(gap(meeting->time)) < 1e-9);
    for (int k = 0; k < 20; ++k) CHECK(gap(meeting->time * k / 20) > -1e-9);
    if (meeting->time < 0.05 || length(meeting->gradient) > 20) continue;
    const Vec2 expected = numerical_force(p, [&](Vec2 at) { return encounter(at, v, r, a, b)->time; });
    CHECK(length(power_law_force(kModel, *meeting) - expected) <= 1e-4 * length(expected) + 1e-9);
  }
  CHECK(meetings > 500);
}

TEST_CASE("a step accelerates by the force and the drive") {
  Agents agents;
  add_agent(agents, {-2, 0}, {1.5, 0}), add_agent(agents, {2, 0}, {-1.5, 0});
  const double force = 1.5 * std::exp(-1.0 / 3) * (2 + 1.0 / 3) / 3;
  const auto a = accelerations(agents, {});
  // Floats keep 1.2e-7 m/s of 1.5 m/s: 2.4e-4 m/s^2 after a millisecond; the tie-break turns by 1e-5.
  CHECK(length(a[0] - Vec2{-force, 0}) < 1e-3);
  CHECK(length(a[1] - Vec2{force, 0}) < 1e-3);

  // From rest, alone: (1 - exp(-dt / xi)) v_wish.
  Agents alone;
  add_agent(alone, {}, {1.5, 0});
  PowerLaw(kModel).step(alone, {{}, 1.0f / 48, 1});
  CHECK(std::abs(alone.vx[0] - 1.5 * (1 - std::exp(-1 / (48 * 0.54)))) < 1e-6);
}

TEST_CASE("unequal masses keep the momentum and the heavier gives way less") {
  Agents agents;
  add_agent(agents, {-2, 0.3}, {1.5, 0}), add_agent(agents, {2, 0}, {-1.5, 0});
  agents.mass[0] = 30;
  const auto a = accelerations(agents, {});
  CHECK(length(a[1]) > 1);
  CHECK(length(30 * a[0] + a[1]) < 30 * 1e-3);
}

TEST_CASE("forces longer than the maximum are cut") {
  Agents agents;
  add_agent(agents, {-0.51, 0}, {1.5, 0}), add_agent(agents, {0.51, 0}, {-1.5, 0});
  const auto a = accelerations(agents, {});
  CHECK(std::abs(length(a[0]) - kModel.maximum_acceleration) < 1e-2);
}

TEST_CASE("a wall in pieces acts like one wall") {
  const Walls whole = room(10, 10);
  const Walls pieces({make_floor({{0, 0}, {4.8, 0}, {5, 0}, {5.2, 0}, {10, 0}, {10, 10}, {0, 10}}, {})}, {}, 5);
  Agents agents;
  add_agent(agents, {5, 2}, {0.1, -1.4});
  const auto a = accelerations(agents, whole), b = accelerations(agents, pieces);
  CHECK(a[0].y > 1);
  CHECK(length(a[0] - b[0]) < 1e-3);
}

TEST_CASE("passing crowds keep clear when sparse and overlap for good when dense as in thesis figure 6.7") {
  // The thesis's 1,344 agents at separations of 4.5 and 3.3. They are in the units of its solver, whose particles have
  // radius 1 (thesis 4.2.3): with radius 0.5 nobody overlaps at either.
  const auto run = [](double spacing) {
    Agents agents = passing(28, 24, spacing, 6);
    Rng rng(3);
    for (std::size_t i = 0; i < agents.size(); ++i) {
      agents.radius[i] = 1, agents.wish_x[i] *= static_cast<float>(rng.uniform(0.9, 1.1));
      agents.vx[i] = agents.wish_x[i];
    }
    PowerLaw model(kModel);
    Overlaps worst;
    for (int k = 0; k < 48 * 25; ++k) {
      model.step(agents, {{}, 1.0f / 48, 0});
      if (k % 48 != 47) continue;
      const Overlaps now = overlaps(agents, 0.04);  // 2 % of the radii's sum
      worst.pairs = std::max(worst.pairs, now.pairs), worst.worst = std::max(worst.worst, now.worst);
    }
    return worst;
  };
  const Overlaps sparse = run(4.5), dense = run(3.3);
  CHECK(sparse.pairs == 0);
  CHECK(dense.pairs > 100);
  CHECK(dense.worst > 0.5);
}
