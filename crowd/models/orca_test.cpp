#include "crowd/models/orca.h"

#include <doctest/doctest.h>

#include "crowd/models/velocity_obstacle.h"
#include "crowd/test_crowds.h"

using namespace inhabit::crowd;
using namespace inhabit::crowd::testing;

namespace {

const Orca::Parameters kModel;
constexpr double kTau = 5, kDt = 1.0 / 48;

/// The nearest that two come, less r, before tau, when one moves with v relative to the other at x.
double clearance(Vec2 x, Vec2 v, double r, double tau) {
  const double vv = dot(v, v), t = vv > 0 ? std::clamp(dot(x, v) / vv, 0.0, tau) : 0;
  return length(x - t * v) - r;
}

/// People on a circle, give or take 10 cm, who want to be on its other side (in exact symmetry they block each other
/// for ever: every one is held by two neighbours who are held likewise); returns the seconds until all are, and the
/// worst overlap.
struct Swap {
  double seconds = 0, overlap = 0;
};
Swap swap_on_circle(int count, double circle) {
  Agents agents;
  std::vector<Vec2> goals;
  Rng rng(9);
  for (int k = 0; k < count; ++k) {
    const Vec2 d = direction(2 * kPi * k / count);
    const std::size_t i =
        add_agent(agents, circle * d + Vec2{rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)}, -1.4 * d);
    agents.vx[i] = agents.wish_x[i], agents.vy[i] = agents.wish_y[i];
    goals.push_back(-circle * d);
  }
  Orca model(kModel);
  Swap result;
  for (int k = 0; k < 48 * 300; ++k) {
    double farthest = 0;
    for (std::size_t i = 0; i < agents.size(); ++i) {
      const Vec2 way = goals[agents.id[i]] - position(agents, i);
      const Vec2 v = limited((1 / kDt) * way, 1.4);
      agents.wish_x[i] = static_cast<float>(v.x), agents.wish_y[i] = static_cast<float>(v.y);
      farthest = std::max(farthest, length(way));
    }
    result.seconds = k * kDt;
    if (farthest < 0.1) return result;
    model.step(agents, {{}, static_cast<float>(kDt), 1});
    result.overlap = std::max(result.overlap, overlaps(agents).worst);
  }
  result.seconds = 1e9;
  return result;
}

}  // namespace

TEST_CASE("two head-on share the turn that the tangent asks for") {
  // 10 m apart, radii 0.5: the leg stands at asin(1 / 10) to the line between them.
  const Vec2 x{10, 0}, v_A{1.4, 0};
  const HalfPlane a = orca_half_plane(x, 2 * v_A, v_A, 1, kTau, kDt, 0.5, {});
  const HalfPlane b = orca_half_plane(-x, -2 * v_A, -v_A, 1, kTau, kDt, 0.5, {});
  // Both keep to their right: the right leg, whose normal is perpendicular to it.
  const double sine = 0.1, cosine = std::sqrt(0.99);
  CHECK(length(a.n - Vec2{-sine, -cosine}) < 1e-12);
  CHECK(length(a.n + b.n) < 1e-12);
  CHECK(std::abs(a.c - b.c) < 1e-12);
  // |u| = 2.8 sin, and each takes half of it.
  CHECK(std::abs(violation(a, v_A) - 1.4 * sine) < 1e-12);
  LinearProgramme programme;
  const Vec2 new_A = programme.solve({{a}}, 0, v_A, 2), new_B = programme.solve({{b}}, 0, -v_A, 2);
  CHECK(std::abs(violation(a, new_A)) < 1e-12);
  CHECK(length(new_A - (v_A + 1.4 * sine * a.n)) < 1e-12);
  CHECK(length(new_A + new_B) < 1e-12);
  // They graze: the slope of the relative velocity is the tangent's.
  const Vec2 v = new_A - new_B;
  CHECK(std::abs(v.y / v.x + sine / cosine) < 1e-12);
  CHECK(std::abs(clearance(x, v, 1, 100)) < 1e-12);
}

TEST_CASE("whatever two choose in their half planes keeps them apart for tau") {
  int met = 0;
  for (std::uint64_t n = 0; n < 20000; ++n) {
    INFO("case ", n);
    Rng rng(61, n);
    const Vec2 x{rng.uniform(-8, 8), rng.uniform(-8, 8)};
    const double r = rng.uniform(0.2, 1.5), share = n % 2 == 0 ? 0.5 : rng.uniform();
    if (length(x) <= r) continue;
    const Vec2 v_A{rng.uniform(-2, 2), rng.uniform(-2, 2)}, v_B{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const HalfPlane a = orca_half_plane(x, v_A - v_B, v_A, r, kTau, kDt, share, {});
    const HalfPlane b = orca_half_plane(-x, v_B - v_A, v_B, r, kTau, kDt, 1 - share, {});
    const bool collides = clearance(x, v_A - v_B, r, kTau) < 0;
    met += collides;
    // The present velocities are forbidden exactly when they collide.
    if (std::abs(clearance(x, v_A - v_B, r, kTau)) > 1e-9 && share > 0.01 && share < 0.99)
      CHECK((violation(a, v_A) > 0) == collides);
    if (!collides) continue;
    for (int k = 0; k < 20; ++k) {
      const auto any = [&](const HalfPlane& h) {
        return h.c * h.n + rng.uniform(0, 2) * h.n + rng.uniform(-2, 2) * perp(h.n);
      };
      // Optimal: the best half planes of the kind, so points of their borders may touch.
      CHECK(clearance(x, any(a) - any(b), r, kTau) > -1e-9);
    }
  }
  CHECK(met > 500);
}

TEST_CASE("two who overlap are apart after one step") {
  for (const double dx : {0.0, 1e-6, 0.3, 0.9}) {
    INFO("dx ", dx);
    Agents agents;
    add_agent(agents, {0, 0}, {1, 0}), add_agent(agents, {dx, 0}, {1, 0});
    agents.maximum_speed[0] = agents.maximum_speed[1] = 100;
    Orca(kModel).step(agents, {{}, static_cast<float>(kDt), 1});
    CHECK(overlaps(agents).worst < 1e-5);
  }
}

TEST_CASE("the heavier gives way less") {
  Agents agents;
  add_agent(agents, {-3, 0.1}, {1.4, 0}), add_agent(agents, {3, 0}, {-1.4, 0});
  agents.vx[0] = 1.4f, agents.vx[1] = -1.4f, agents.mass[0] = 30;
  Orca(kModel).step(agents, {{}, static_cast<float>(kDt), 1});
  const auto index = index_of(agents);
  CHECK(std::abs(agents.vy[index[1]]) > 0.1);
  CHECK(std::abs(agents.vy[index[0]] / agents.vy[index[1]] + 1.0 / 30) < 1e-3);
}

TEST_CASE("eight on a circle change places without touching") {
  const Swap swap = swap_on_circle(8, 8);
  CHECK(swap.overlap <= 1e-3);
  CHECK(swap.seconds < 60);
}

TEST_CASE("a hundred on a circle change places") {
  // In the jam at the centre no velocity satisfies everybody; the least violation (sec. 5.3) guarantees nothing. We
  // measured 1 to 3 % over eight arrangements.
  const Swap swap = swap_on_circle(100, 30);
  CHECK(swap.overlap <= 0.04);
  CHECK(swap.seconds < 150);
}

TEST_CASE("towards a wall the speed is the gap over the horizon and nothing hinders along it") {
  const Walls walls = room(20, 20);
  std::vector<HalfPlane> planes;
  append_wall_half_planes(walls, {10, 2}, {0, -1.4}, 0.5, 2, 2, planes);
  REQUIRE(planes.size() == 1);
  CHECK(length(planes[0].n - Vec2{0, 1}) < 1e-12);
  CHECK(std::abs(planes[0].c + 0.75) < 1e-12);

  Agents agents;
  add_agent(agents, {2, 2}, {1, -1});
  Orca model(kModel);
  for (int k = 0; k < 48 * 10; ++k) {
    model.step(agents, {walls, static_cast<float>(kDt), 1});
    CHECK(agents.y[0] > 0.5 - 1e-5);
    CHECK(std::abs(agents.vx[0] - 1) < 1e-4);
  }
  CHECK(agents.y[0] < 0.6);
}

TEST_CASE("a wall in pieces leaves the same half planes as one wall") {
  const Walls whole = room(10, 10, {}, 4);
  Ring ring;
  for (int k = 0; k < 40; ++k) ring.push_back({0.25 * k, 0});
  ring.insert(ring.end(), {{10, 0}, {10, 10}, {0, 10}});
  const Walls pieces({make_floor(ring, {})}, {}, 4);
  for (std::uint64_t n = 0; n < 500; ++n) {
    INFO("case ", n);
    Rng rng(62, n);
    const Vec2 p{rng.uniform(2, 8), rng.uniform(0.6, 3)}, v{rng.uniform(-1, 1), rng.uniform(-2, 2)};
    std::vector<HalfPlane> a, b;
    append_wall_half_planes(whole, p, v, 0.5, 2, 2, a);
    append_wall_half_planes(pieces, p, v, 0.5, 2, 2, b);
    for (int k = 0; k < 50; ++k) {
      const Vec2 u{rng.uniform(-2, 2), rng.uniform(-2, 2)};
      const auto allowed = [&](const std::vector<HalfPlane>& planes) {
        return std::ranges::all_of(planes, [&](const HalfPlane& h) { return violation(h, u) <= 1e-9; });
      };
      CHECK(allowed(a) == allowed(b));
    }
  }
}

TEST_CASE("people walk through a door one after the other") {
  // Two rooms with a door 0.8 m wide.
  const Walls walls = room(
      20, 10, {{{9.9, 0.1}, {10.1, 0.1}, {10.1, 4.6}, {9.9, 4.6}}, {{9.9, 5.4}, {10.1, 5.4}, {10.1, 9.9}, {9.9, 9.9}}});
  Agents agents;
  add_agent(agents, {3, 3}, {1.4, 0}, 0.25), add_agent(agents, {2, 7.1}, {1.4, 0}, 0.25);
  add_agent(agents, {4, 5.1}, {1.4, 0}, 0.25);
  Orca model(kModel);
  const auto through = [](float x) { return x > 15; };
  for (int k = 0; k < 48 * 60 && !std::ranges::all_of(agents.x, through); ++k) {
    for (std::size_t i = 0; i < agents.size(); ++i) {
      const Vec2 goal = agents.x[i] < 10.3f ? Vec2{10.4, 5} : Vec2{17, 3.0 + 2 * agents.id[i]};
      const Vec2 v = 1.4 * unit(goal - position(agents, i));
      agents.wish_x[i] = static_cast<float>(v.x), agents.wish_y[i] = static_cast<float>(v.y);
    }
    model.step(agents, {walls, static_cast<float>(kDt), 1});
    CHECK(overlaps(agents).worst < 1e-3);
    for (std::size_t i = 0; i < agents.size(); ++i) CHECK(walls.on_floor(agents.x[i], agents.y[i]));
  }
  CHECK(std::ranges::all_of(agents.x, through));
}
