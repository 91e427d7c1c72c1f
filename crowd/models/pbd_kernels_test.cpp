#include "crowd/models/pbd_kernels.h"

#include <doctest/doctest.h>
#include <hwy/highway.h>

#include <cmath>
#include <cstring>

#include "core/rng.h"
#include "crowd/models/pbd_reference.h"

using namespace inhabit::crowd;
using namespace inhabit::crowd::pbd_model;
namespace {

/// A crowd so dense that everybody touches somebody, in the order of its grid.
struct State {
  Work work;
  Grid grid;
  Constants k;
  Reach reach;
  std::vector<float> stiffness;
};

std::size_t padded(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes + kLanes; }

State random_state(std::size_t count, bool alike, int far, std::uint64_t seed, double spacing = 0.9) {
  inhabit::core::Rng rng(seed);
  State s;
  const double side = std::sqrt(static_cast<double>(count)) * spacing;
  std::vector<float> x(count), y(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<float>(rng.uniform(-side, side) / 2), y[i] = static_cast<float>(rng.uniform(-side, side) / 2);
    if (i % 50 == 1) x[i] = x[i - 1], y[i] = y[i - 1];  // coincident
  }
  s.grid.build(x, y, 1.4f, 1);
  Work& w = s.work;
  w.count = count;
  for (FloatArray* pairs : {&w.at, &w.next, &w.base, &w.moved, &w.predicted, &w.corrected, &w.v, &w.wish})
    pairs->assign(2 * padded(count), 0);
  for (std::size_t i = 0; i < count; ++i) w.at[2 * i] = x[s.grid.order()[i]], w.at[2 * i + 1] = y[s.grid.order()[i]];
  const auto random = [&](FloatArray& array, std::size_t values, double low, double high) {
    for (std::size_t i = 0; i < values; ++i) array[i] = static_cast<float>(rng.uniform(low, high));
  };
  for (FloatArray* pairs : {&w.v, &w.wish}) random(*pairs, 2 * count, -1.5, 1.5);
  w.maximum_speed.assign(padded(count), 0);
  random(w.maximum_speed, count, 0.5, 2);
  w.common_radius = 0.5f;
  if (!alike) {
    w.radius.assign(padded(count), 0), w.mass.assign(padded(count), 1);
    random(w.radius, count, 0.1, 0.5), random(w.mass, count, 0.1, 30);
  }
  w.chunks.resize((w.blocks() + kBlocksPerChunk - 1) / kBlocksPerChunk);
  s.k.dt = 1.0f / 48, s.k.part = s.k.dt / 8, s.k.inverse_part = 1 / s.k.part, s.k.blend = 0.0048f, s.k.growth = 1.02f;
  s.k.parts = 8, s.k.stride = 2 * s.k.dt;
  s.k.static_friction = 0.21f, s.k.kinetic_friction = 0.1f, s.k.velocity_change = 0.4f;
  s.k.far = far, s.k.far_horizon = 20, s.k.cohesion = 0.3f, s.k.cohesion_range = 4;
  for (int m = 0; m < 1000; ++m) s.stiffness.push_back(static_cast<float>(std::exp(-m * m / 48.0 / 48 / 20)));
  s.k.stiffness_of_delay = s.stiffness.data();
  s.reach = {1.02f, 0.2f, true, 3, 10};
  return s;
}

void check_same(const FloatArray& a, const FloatArray& b) {
  REQUIRE(a.size() == b.size());
  CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

/// Both versions of a whole step, kernel by kernel, from the same state.
void compare(State fast, bool to_come = true) {
  State plain = fast;
  fast.k.stiffness_of_delay = plain.k.stiffness_of_delay = plain.stiffness.data();
  Work &f = fast.work, &p = plain.work;
  const auto each = [&](auto&& run) {
    for (std::size_t c = 0; c < f.chunks.size(); ++c) run(c);
  };
  each([&](std::size_t c) {
    find_neighbours(f, fast.grid, fast.reach, c);
    plainly::find_neighbours(p, plain.reach, c);
    CHECK(f.chunks[c].contacts.items == p.chunks[c].contacts.items);
    CHECK(f.chunks[c].contacts.first == p.chunks[c].contacts.first);
    CHECK(f.chunks[c].far.items == p.chunks[c].far.items);
  });
  for (std::size_t c = 0; c < f.chunks.size(); ++c)
    for (std::size_t b = 0; b < f.blocks_of(c); ++b)
      CHECK(f.chunks[c].gap[b] == doctest::Approx(p.chunks[c].gap[b]).epsilon(1e-5));
  const FloatArray before = f.v;
  each([&](std::size_t c) { intend(f, fast.k, c), plainly::intend(p, plain.k, c); });
  each([&](std::size_t c) { foresee(f, fast.k, c), plainly::foresee(p, plain.k, c); });
  check_same(f.v, p.v);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < f.count; ++i) changed += before[2 * i] != f.v[2 * i];
  if (to_come) CHECK(changed > f.count / 4);  // there was something to compare
  each([&](std::size_t c) { cohere(f, fast.k, c), plainly::cohere(p, plain.k, c); });
  check_same(f.next, p.next);
  each([&](std::size_t c) {
    narrow(f, fast.k, c), plainly::narrow(p, plain.k, c);
    CHECK(f.chunks[c].near.items == p.chunks[c].near.items);
    CHECK(f.chunks[c].busy == p.chunks[c].busy);
  });
  each([&](std::size_t c) { glide(f, fast.k, c), plainly::glide(p, plain.k, c); });
  check_same(f.at, p.at), check_same(f.v, p.v);
  each([&](std::size_t c) { stabilise(f, fast.k, c), plainly::stabilise(p, plain.k, c); });
  check_same(f.corrected, p.corrected);
  each([&](std::size_t c) {
    settle(f, fast.k, c), plainly::settle(p, plain.k, c);
    CHECK(f.chunks[c].thrown == p.chunks[c].thrown);
  });
  check_same(f.at, p.at);
  each([&](std::size_t c) { predict(f, fast.k, c), plainly::predict(p, plain.k, c); });
  check_same(f.predicted, p.predicted);
  each([&](std::size_t c) { plainly::project(p, plain.k, c); });
  // Row by row and pair by pair.
  for (const bool crowded : {false, true}) {
    each([&](std::size_t c) {
      f.chunks[c].crowded = crowded;
      project(f, fast.k, c);
    });
    check_same(f.corrected, p.corrected);
  }
  each([&](std::size_t c) { finish(f, fast.k, c), plainly::finish(p, plain.k, c); });
  check_same(f.next, p.next), check_same(f.v, p.v), check_same(f.moved, p.moved), check_same(f.corrected, p.corrected);
}

/// A step of contacts alone, by the fast loops.
void step(State& s) {
  const auto each = [&](auto&& run) {
    for (std::size_t c = 0; c < s.work.chunks.size(); ++c) run(c);
  };
  s.k.stiffness_of_delay = s.stiffness.data();
  each([&](std::size_t c) { find_neighbours(s.work, s.grid, s.reach, c); });
  each([&](std::size_t c) { narrow(s.work, s.k, c); });
  each([&](std::size_t c) { glide(s.work, s.k, c); });
  each([&](std::size_t c) { stabilise(s.work, s.k, c); });
  each([&](std::size_t c) { settle(s.work, s.k, c); });
  each([&](std::size_t c) { predict(s.work, s.k, c); });
  for (int part = 0; part < s.k.parts; ++part) {
    each([&](std::size_t c) { project(s.work, s.k, c), finish(s.work, s.k, c); });
    s.work.predicted.swap(s.work.corrected), s.work.at.swap(s.work.next);
  }
}

}  // namespace

TEST_CASE("pbd: every instruction set gives the bits of the readable version") {
  const std::int64_t all = hwy::SupportedTargets();
  int sets = 0;
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    CAPTURE(hwy::TargetName(target));
    ++sets;
    for (const int far : {1, 2})
      for (const bool alike : {true, false}) {
        CAPTURE(far);
        CAPTURE(alike);
        compare(random_state(1500, alike, far, 7));
      }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  CHECK(sets >= 1);
}

TEST_CASE("pbd: a step in which everybody is looked at gives what the step of the busy alone gives") {
  for (const bool alike : {true, false}) {
    // Nobody overlaps, or he would be thrown; some are near enough to touch in this step and some are not.
    State some = random_state(3000, alike, 0, 11);
    inhabit::core::Rng rng(5);
    std::vector<float> x, y;
    const double spacing = alike ? 1.3 : 1.2;
    for (int i = 0; i < 3000; ++i) {
      x.push_back(static_cast<float>(spacing * (i % 60) + rng.uniform(-0.12, 0.12)));
      y.push_back(static_cast<float>(spacing * (i / 60) + rng.uniform(-0.1, 0.1)));
      if (!alike) some.work.radius[i] = static_cast<float>(rng.uniform(0.4, 0.49));
      some.work.maximum_speed[i] = 1.5f;
    }
    some.grid.build(x, y, 1.4f, 1);
    for (std::size_t i = 0; i < 3000; ++i)
      some.work.at[2 * i] = x[some.grid.order()[i]], some.work.at[2 * i + 1] = y[some.grid.order()[i]];
    State all = some;
    // Within the skin anyway, but a stride as long as the skin makes everybody busy who has any neighbour.
    some.k.stride = 1.5f * some.k.dt, all.k.stride = all.reach.skin;
    step(some), step(all);
    const auto busy = [](const State& s) {
      std::size_t sum = 0;
      for (const Chunk& c : s.work.chunks) sum += c.busy_count;
      return sum;
    };
    CHECK(busy(some) < busy(all));
    CHECK(busy(some) > 10);
    double worst = 0;
    for (std::size_t k = 0; k < 2 * some.work.count; ++k)
      worst = std::max(worst, std::abs(static_cast<double>(some.work.at[k]) - all.work.at[k]));
    CHECK(worst < 1e-5);  // floats at 200 m, eight times rounded
  }
}

TEST_CASE("pbd: of a pile only the nearest count as contacts and nothing overflows") {
  State s = random_state(600, true, 1, 3, 0.009);
  compare(s, false);
}
