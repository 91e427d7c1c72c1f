#include "crowd/models/social_force.h"

#include <doctest/doctest.h>

#include "crowd/test_crowds.h"
#include "crowd/wall_contacts.h"

using namespace inhabit::crowd;
using namespace inhabit::crowd::testing;

namespace {

const SocialForce::Parameters kModel;
constexpr float kStep = 1.0f / 48;

/// The gap at which the push balances a force, by bisection.
double balanced_gap(double newtons) {
  double low = -1, high = 1;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (social_force_contact(kModel, middle).push > newtons ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("contacts push and grip as equation 2 says") {
  // Apart by ln(2) B: half of A, no body force.
  const SocialForceContact apart = social_force_contact(kModel, 0.08 * std::log(2.0));
  CHECK(std::abs(apart.push - 1000) < 1e-9);
  CHECK(apart.grip == 0);
  // One centimetre deep: 2000 exp(1/8) + 1200 N, 2400 kg/s.
  const SocialForceContact deep = social_force_contact(kModel, -0.01);
  CHECK(std::abs(deep.push - (2000 * std::exp(0.125) + 1200)) < 1e-9);
  CHECK(std::abs(deep.grip - 2400) < 1e-9);
}

TEST_CASE("a free walker takes up speed exponentially and ends at the wish") {
  Agents agents;
  add_agent(agents, {}, {1.2, 0});
  SocialForce model(kModel);
  for (int k = 1; k <= 48 * 10; ++k) {
    model.step(agents, {{}, kStep, 1});
    // Twenty sub-steps round twenty times, by half a unit of 1.2 each.
    const double expected = 1.2 * (1 - std::exp(-k / (48 * kModel.relaxation_time)));
    CHECK(std::abs(agents.vx[0] - expected) < k * 20 * 6e-8);
  }
  // Gains of less than half a unit, (1.2 - v) h / tau < 6e-8, are lost.
  CHECK(std::abs(agents.vx[0] - 1.2) < 3e-5);
}

TEST_CASE("a walker against a wall stops where the push balances the drive") {
  const Walls walls = room(10, 10);
  for (const double mass : {0.5, 1.0, 5.0, 20.0}) {
    INFO("mass ", mass);
    Agents agents;
    add_agent(agents, {9, 5}, {1.4, 0}, 0.3);
    agents.mass[0] = static_cast<float>(mass);
    SocialForce model(kModel);
    for (int k = 0; k < 48 * 20; ++k) model.step(agents, {walls, kStep, 1});
    const double gap = balanced_gap(mass * kModel.person_mass * 1.4 / kModel.relaxation_time);
    CHECK(std::abs(10 - agents.x[0] - agents.radius[0] - gap) < 1e-4);
    CHECK(std::abs(agents.vx[0]) < 1e-3);
  }
}

TEST_CASE("two who push against each other stop where the push balances the drive") {
  for (const double mass : {0.5, 1.0, 5.0, 20.0}) {
    INFO("mass ", mass);
    Agents agents;
    // Two centimetres from the balance, of which e^-4 is left after four seconds (half the drive's 1 / tau); the
    // balance itself is unstable, and after some more seconds they slip past each other.
    const double gap = balanced_gap(mass * kModel.person_mass * 1.4 / kModel.relaxation_time), x = 0.31 + 0.5 * gap;
    add_agent(agents, {-x, 0}, {1.4, 0}, 0.3), add_agent(agents, {x, 0}, {-1.4, 0}, 0.3);
    for (float& m : agents.mass) m = static_cast<float>(mass);
    SocialForce model(kModel);
    for (int k = 0; k < 48 * 4; ++k) model.step(agents, {{}, kStep, 1});
    CHECK(std::abs(length(position(agents, 1) - position(agents, 0)) - 0.6 - gap) < 5e-4);
  }
}

TEST_CASE("bodies that rub are slowed by kappa times overlap times sliding speed") {
  Agents agents;
  add_agent(agents, {0, 0}, {0, 1.2}), add_agent(agents, {0.98, 0}, {0, -1.2});
  agents.vy[0] = 1.2f, agents.vy[1] = -1.2f;
  agents.maximum_speed[0] = agents.maximum_speed[1] = 10;
  auto parameters = kModel;
  parameters.sub_steps = 1;
  const float h = 1e-5f;
  SocialForce(parameters).step(agents, {{}, h, 1});
  const auto index = index_of(agents);
  // dv = h / m kappa g(0.02) 2.4; floats of 1.2 keep 6e-8.
  const double expected = h / 80.0 * 240000 * (1.0 - 0.98f) * 2.4;
  CHECK(std::abs(1.2 - agents.vy[index[0]] - expected) < 0.01 * expected);
  CHECK(std::abs(agents.vy[index[1]] + 1.2 - expected) < 0.01 * expected);
  // And apart by the push.
  const double push = h / 80.0 * social_force_contact(parameters, 0.98f - 1.0).push;
  CHECK(std::abs(agents.vx[index[1]] - push) < 1e-3 * push);
}

TEST_CASE("friction however strong only stops the sliding") {
  auto parameters = kModel;
  parameters.sub_steps = 1, parameters.friction = 1e7, parameters.repulsion = 0, parameters.body = 0;
  parameters.relaxation_time = 100;
  Agents agents;
  add_agent(agents, {0, 0}, {0, 1}), add_agent(agents, {0.5, 0}, {0, 0});
  agents.vy[0] = 1, agents.mass[1] = 1000;
  SocialForce model(parameters);
  for (int k = 0; k < 20; ++k) {
    model.step(agents, {{}, 1.0f / 12, 1});
    const auto index = index_of(agents);
    CHECK(agents.vy[index[0]] > -1e-2);
    CHECK(agents.vy[index[0]] < 1);
  }
}

TEST_CASE("a crowd that is pressed together parts without an explosion at any step") {
  for (const double dt : {1.0 / 100, 1.0 / 48, 1.0 / 12})
    for (const int sub_steps : {1, 20}) {
      INFO("dt ", dt, " sub-steps ", sub_steps);
      auto parameters = kModel;
      parameters.sub_steps = sub_steps;
      Agents agents;
      Rng rng(51);
      for (int k = 0; k < 40; ++k) add_agent(agents, {rng.uniform(-1, 1), rng.uniform(-1, 1)}, {1.2, 0});
      SocialForce model(parameters);
      for (int k = 0; k < 20 / dt; ++k) {
        model.step(agents, {{}, static_cast<float>(dt), 1});
        REQUIRE(all_finite(agents));
      }
      for (std::size_t i = 0; i < agents.size(); ++i)
        CHECK(length(velocity(agents, i)) <= agents.maximum_speed[i] * (1 + 1e-6));
      if (sub_steps == 20) CHECK(overlaps(agents).worst < 0.02);
    }
}

TEST_CASE("neighbours found once count in every sub-step") {
  // Two who close in at 16 m/s each, from just outside of the range in which pushes count: in the last sub-steps they
  // feel each other.
  auto parameters = kModel;
  parameters.relaxation_time = 100;
  Agents agents;
  const double far = 17 * kModel.repulsion_range;
  add_agent(agents, {-0.5 * far - 0.5 - 0.3, 0}, {16, 0}), add_agent(agents, {0.5 * far + 0.5 + 0.3, 0}, {-16, 0});
  agents.vx[0] = 16, agents.vx[1] = -16;
  parameters.repulsion = 1e6, parameters.person_mass = 1;
  SocialForce(parameters).step(agents, {{}, kStep, 1});
  const auto index = index_of(agents);
  CHECK(agents.vx[index[0]] < 16 - 1e-5f);
  CHECK(agents.vx[index[1]] > -16 + 1e-5f);
}

TEST_CASE("a wall in pieces is one wall and a corner that sticks out is one corner") {
  const auto contacts = [](const Walls& walls, Vec2 p) {
    std::vector<Vec2> points;
    for_each_facing_wall(walls, static_cast<float>(p.x), static_cast<float>(p.y), [&](Vec2 q) {
      if (length(q - p) < 2) points.push_back(q);
    });
    return points;
  };
  const Walls pieces({make_floor({{0, 0}, {4, 0}, {5, 0}, {6, 0}, {10, 0}, {10, 10}, {0, 10}}, {})}, {}, 2);
  // Before a joint, and beside one.
  CHECK(contacts(pieces, {5, 1}) == std::vector<Vec2>{{5, 0}});
  CHECK(contacts(pieces, {5.25, 1}) == std::vector<Vec2>{{5.25, 0}});
  // Around a pillar: each side its foot, each corner once; never the far sides.
  const Walls pillar = room(10, 10, {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}}, 2);
  CHECK(contacts(pillar, {5, 3}) == std::vector<Vec2>{{5, 4}});
  CHECK(contacts(pillar, {3, 3}) == std::vector<Vec2>{{4, 4}});
  CHECK(contacts(pillar, {6.5, 6.5}) == std::vector<Vec2>{{6, 6}});
  // In the corner of a room: both walls.
  const auto corner = contacts(pillar, {1, 1});
  CHECK(corner.size() == 2);
}

TEST_CASE("a wall rubs off speed along it") {
  // Pressed 1 cm into a wall, sliding along it: dv = -h / m kappa g(0.01) 1.2.
  const Walls walls = room(10, 10);
  Agents agents;
  add_agent(agents, {5, 0.49}, {1.2, 0});
  agents.vx[0] = 1.2f;
  auto parameters = kModel;
  parameters.sub_steps = 1;
  const float h = 1e-5f;
  SocialForce(parameters).step(agents, {walls, h, 1});
  const double expected = h / 80.0 * 240000 * (0.5 - 0.49f) * 1.2;
  CHECK(std::abs(1.2 - agents.vx[0] - expected) < 0.01 * expected);
}
