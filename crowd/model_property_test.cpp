#include <doctest/doctest.h>

#include <cstring>

#include "core/type_list.h"
#include "crowd/model_table.h"
#include "crowd/steering.h"
#include "crowd/test_crowds.h"

/// What every model of the table promises, over random crowds. A case is named by the model and its number.
using namespace inhabit::crowd;
using namespace inhabit::crowd::testing;

namespace {

/// Its parameters' defaults are the thesis's contact and friction alone, which leave two who meet exactly head-on face
/// to face; crowd/models/pbd_test.cpp has the same case with long range and avoidance.
using ContactAlone = std::variant<Pbd>;

constexpr float kStep = 1.0f / 48;
const Walls kNoWalls;

template <class T, class V>
constexpr bool kIsIn = false;
template <class T, class... Ts>
constexpr bool kIsIn<T, std::variant<Ts...>> = (std::is_same_v<T, Ts> || ...);

template <class Except, class F, class... Ms>
void for_each_of(std::variant<Ms...>*, F&& f) {
  const auto one = [&]<class M>(std::type_identity<M> type) {
    if constexpr (!kIsIn<M, Except>) {
      INFO(M::Parameters::kName);
      f(type);
    }
  };
  (one(std::type_identity<Ms>{}), ...);
}

/// Calls f(make) for every model; make() is a new one with its usual parameters.
template <class Except = std::variant<>, class F>
void for_each_model(F&& f) {
  for_each_of<Except>(static_cast<Models*>(nullptr),
                      [&]<class M>(std::type_identity<M>) { f([] { return M(typename M::Parameters{}); }); });
}

/// People of random sizes, walking, about `spacing` metres apart.
Agents random_crowd(std::uint64_t number, int count, double spacing) {
  Agents agents;
  Rng rng(71, number);
  const double size = 0.5 * spacing * std::sqrt(count);
  for (int k = 0; k < count; ++k) {
    const std::size_t i = add_agent(agents, {rng.uniform(-size, size), rng.uniform(-size, size)},
                                    1.4 * direction(rng.uniform(-kPi, kPi)), rng.uniform(0.2, 0.3));
    agents.vx[i] = static_cast<float>(rng.uniform(-1, 1)), agents.vy[i] = static_cast<float>(rng.uniform(-1, 1));
    agents.mass[i] = static_cast<float>(rng.uniform(0.5, 2));
  }
  return agents;
}

/// The largest difference of positions in metres, and of velocities in metres per second, between agents of one id.
struct Difference {
  double position = 0, velocity = 0;
};
Difference difference(const Agents& a, const Agents& b) {
  const auto in_a = index_of(a), in_b = index_of(b);
  Difference most;
  for (std::size_t k = 0; k < a.size(); ++k) {
    most.position = std::max(most.position, length(position(a, in_a[k]) - position(b, in_b[k])));
    most.velocity = std::max(most.velocity, length(velocity(a, in_a[k]) - velocity(b, in_b[k])));
  }
  return most;
}

/// What rounding of floats of some ten metres may do in a step, and what that is as a velocity. The tie-break (1e-5 of
/// 1.4 m/s, kTieBreak) is less.
constexpr double kPlace = 1e-5, kSpeed = kPlace * 48;

/// Everything about everybody, byte for byte, in the order of their ids.
std::vector<std::byte> bytes_of(Agents agents) {
  std::vector<std::uint32_t> order(agents.size());
  const auto index = index_of(agents);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint32_t>(index[k]);
  agents.permute(order);
  std::vector<std::byte> bytes;
  agents.for_each_array([&](const auto& array) {
    const auto span = std::as_bytes(std::span(array));
    bytes.insert(bytes.end(), span.begin(), span.end());
  });
  return bytes;
}

bool slow_enough(const Agents& agents) {
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (!(length(velocity(agents, i)) <= agents.maximum_speed[i] * (1 + 1e-5))) return false;
  return true;
}

}  // namespace

TEST_CASE("every model: an empty crowd is no trouble") {
  for_each_model([](auto make) {
    Agents nobody;
    auto model = make();
    model.step(nobody, {kNoWalls, kStep, 0});
    CHECK(nobody.empty());
  });
}

TEST_CASE("every model: the order of the agents does not matter") {
  for_each_model([](auto make) {
    for (std::uint64_t n = 0; n < 40; ++n) {
      INFO("case ", n);
      Agents one = random_crowd(n, 100, n % 2 == 0 ? 3 : 1.2), other = one;
      std::vector<std::uint32_t> order(one.size());
      for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = (k * 37 + 11) % 100;
      other.permute(order);
      auto a = make(), b = make();
      a.step(one, {kNoWalls, kStep, 1}), b.step(other, {kNoWalls, kStep, 1});
      const Difference d = difference(one, other);
      CHECK(d.position <= kPlace);
      CHECK(d.velocity <= kSpeed);
    }
  });
}

TEST_CASE("every model: a mirrored scene gives the mirrored result") {
  const auto mirror = [](Agents& agents) {
    for (std::size_t i = 0; i < agents.size(); ++i)
      agents.y[i] = -agents.y[i], agents.vy[i] = -agents.vy[i], agents.wish_y[i] = -agents.wish_y[i];
  };
  const Walls walls({make_floor({{-30, -6}, {30, -6}, {30, 6}, {-30, 6}}, {})}, {}, 5);
  for_each_model([&](auto make) {
    for (std::uint64_t n = 0; n < 40; ++n) {
      INFO("case ", n);
      Agents one = random_crowd(n, 40, n % 2 == 0 ? 1.6 : 1.2), other = one;
      mirror(other);
      auto a = make(), b = make();
      a.step(one, {walls, kStep, 1}), b.step(other, {walls, kStep, 1});
      mirror(other);
      const Difference d = difference(one, other);
      CHECK(d.position <= kPlace);
      CHECK(d.velocity <= kSpeed);
    }
  });
}

TEST_CASE("every model: somebody alone takes up the wished velocity and keeps it") {
  for_each_model([](auto make) {
    Agents agents;
    add_agent(agents, {3, -2}, {1.1, -0.6});
    auto model = make();
    for (int k = 0; k < 48 * 10; ++k) model.step(agents, {kNoWalls, kStep, 1});
    CHECK(length(velocity(agents, 0) - Vec2{1.1, -0.6}) < 1e-4);
  });
}

TEST_CASE("every model: a kilometre from the origin people walk as fast as anywhere") {
  for_each_model([](auto make) {
    Agents agents;
    add_agent(agents, {1000, -700}, {1.1, -0.6});
    auto model = make();
    for (int k = 0; k < 48 * 10; ++k) model.step(agents, {kNoWalls, kStep, 1});
    CHECK(length(velocity(agents, 0) - Vec2{1.1, -0.6}) < 1e-3);
    const Vec2 before = position(agents, 0);
    for (int k = 0; k < 48 * 10; ++k) model.step(agents, {kNoWalls, kStep, 1});
    // A position is kept to 3e-5 m, every step may round alike: 3e-5 of 0.0125 m at most along y, as much as 0.3 %.
    CHECK(length(position(agents, 0) - before - 10 * Vec2{1.1, -0.6}) < 0.003 * 12.5);
  });
}

TEST_CASE("every model: two who are far from each other walk as if alone") {
  for_each_model([](auto make) {
    Agents both, one;
    add_agent(both, {0, 0}, {1.4, 0}), add_agent(both, {300, 0}, {-1.4, 0});
    add_agent(one, {0, 0}, {1.4, 0});
    auto a = make(), b = make();
    for (int k = 0; k < 48; ++k) a.step(both, {kNoWalls, kStep, 1}), b.step(one, {kNoWalls, kStep, 1});
    const std::size_t i = index_of(both)[0];
    CHECK(position(both, i) == position(one, 0));
    CHECK(velocity(both, i) == velocity(one, 0));
  });
}

TEST_CASE("every model: two who meet exactly head-on get past each other") {
  for_each_model<ContactAlone>([](auto make) {
    for (const double gap : {4.0, 20.0}) {
      INFO("gap ", gap);
      Agents agents;
      add_agent(agents, {-gap / 2, 0}, {1.4, 0}), add_agent(agents, {gap / 2, 0}, {-1.4, 0});
      auto model = make();
      // The way takes 9 s at most; we measured 2 to 15 s in all.
      const auto past = [&] {
        const auto index = index_of(agents);
        return agents.x[index[0]] > agents.x[index[1]] + 1;
      };
      for (int k = 0; k < 48 * 30 && !past(); ++k) {
        model.step(agents, {kNoWalls, kStep, 1});
        CHECK(overlaps(agents).worst < 0.02);
      }
      CHECK(past());
    }
  });
}

TEST_CASE("every model: the same bytes at any number of threads") {
  const Walls walls({make_floor({{-200, -20}, {200, -20}, {200, 20}, {-200, 20}}, {})}, {}, 5);
  for_each_model([&](auto make) {
    std::vector<std::byte> expected;
    for (const int threads : {1, 2, 8}) {
      Agents agents = passing(20, 50, 1.5, 3);
      auto model = make();
      for (int k = 0; k < 5; ++k) model.step(agents, {walls, kStep, threads});
      const auto bytes = bytes_of(agents);
      if (expected.empty()) expected = bytes;
      CHECK(bytes == expected);
    }
  });
}

TEST_CASE("every model: people in the same place make no NaN and no explosion") {
  for_each_model([](auto make) {
    Agents agents;
    for (int k = 0; k < 60; ++k) add_agent(agents, {2, 3}, k % 3 == 0 ? Vec2{1, 1} : 1.4 * direction(k));
    auto model = make();
    for (int k = 0; k < 100; ++k) model.step(agents, {kNoWalls, kStep, 1});
    CHECK(all_finite(agents));
    CHECK(slow_enough(agents));
  });
}

TEST_CASE("every model: radii of 1 to 20 and masses of 1 to 1000 at any step make no NaN and no explosion") {
  for_each_model([](auto make) {
    for (std::uint64_t n = 0; n < 30; ++n) {
      INFO("case ", n);
      Agents agents = random_crowd(n, 150, 1);
      Rng rng(72, n);
      for (std::size_t i = 0; i < agents.size(); ++i) {
        agents.radius[i] = static_cast<float>(0.1 * std::pow(20.0, rng.uniform()));
        agents.mass[i] = static_cast<float>(0.03 * std::pow(1000.0, rng.uniform()));
      }
      const float dt = n % 3 == 0 ? 0.01f : n % 3 == 1 ? kStep : 1.0f / 12;
      auto model = make();
      for (int k = 0; k < 50; ++k) model.step(agents, {kNoWalls, dt, 1});
      CHECK(all_finite(agents));
      CHECK(slow_enough(agents));
    }
  });
}

TEST_CASE("every model: nobody walks through a wall") {
  // A corridor with a pillar, a thin partition and a dead end that narrows.
  const Walls walls({make_floor({{0, 0}, {12, 0}, {20, 1.9}, {20, 2.1}, {12, 4}, {0, 4}},
                                {{{3, 1}, {4, 1}, {4, 2}, {3, 2}}, {{8, 0.5}, {8.05, 0.5}, {8.05, 3}, {8, 3}}})},
                    {}, 5);
  for_each_model([&](auto make) {
    for (std::uint64_t n = 0; n < 6; ++n) {
      INFO("case ", n);
      Rng rng(73, n);
      Agents agents;
      for (int k = 0; k < 30; ++k) {
        const Vec2 p{rng.uniform(0.3, 12), rng.uniform(0.3, 3.7)};
        if (!walls.on_floor(static_cast<float>(p.x), static_cast<float>(p.y))) continue;
        add_agent(agents, p, 1.4 * direction(n % 2 == 0 ? rng.uniform(-kPi, kPi) : 0.1 * rng.uniform(-1, 1)), 0.25);
      }
      auto model = make();
      const float dt = n % 3 == 0 ? 0.01f : n % 3 == 1 ? kStep : 1.0f / 12;
      for (int k = 0; k < 400; ++k) {
        model.step(agents, {walls, dt, 1});
        for (std::size_t i = 0; i < agents.size(); ++i) REQUIRE(walls.on_floor(agents.x[i], agents.y[i]));
      }
      // Whoever went through the partition or a side would be counted on the other side's floor: look at one who
      // pushes against the partition from the start.
      Agents pushing;
      add_agent(pushing, {7, 1.5}, {1.4, 0}, 0.25);
      for (int k = 0; k < 200; ++k) model.step(pushing, {walls, dt, 1});
      CHECK(pushing.x[0] <= 8 - 0.2);
    }
  });
}
