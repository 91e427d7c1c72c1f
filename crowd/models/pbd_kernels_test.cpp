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

void fill(FloatArray& array, std::size_t count, const std::vector<float>& values) {
  array.assign((count + kLanes - 1) / kLanes * kLanes + kLanes, 0.0f);
  std::copy(values.begin(), values.end(), array.begin());
}

State random_state(std::size_t count, bool alike, int far, std::uint64_t seed) {
  inhabit::core::Rng rng(seed);
  State s;
  const double side = std::sqrt(static_cast<double>(count)) * 0.9;
  std::vector<float> x(count), y(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<float>(rng.uniform(-side, side) / 2), y[i] = static_cast<float>(rng.uniform(-side, side) / 2);
    if (i % 50 == 1) x[i] = x[i - 1], y[i] = y[i - 1];  // coincident
  }
  s.grid.build(x, y, 1.4f, 1);
  std::vector<float> sx(count), sy(count);
  for (std::size_t i = 0; i < count; ++i) sx[i] = x[s.grid.order()[i]], sy[i] = y[s.grid.order()[i]];
  Work& w = s.work;
  w.count = count;
  fill(w.x, count, sx), fill(w.y, count, sy);
  const auto random = [&](double low, double high) {
    std::vector<float> values(count);
    for (float& v : values) v = static_cast<float>(rng.uniform(low, high));
    return values;
  };
  for (FloatArray* v : {&w.vx, &w.vy, &w.wish_x, &w.wish_y}) fill(*v, count, random(-1.5, 1.5));
  fill(w.maximum_speed, count, random(0.5, 2));
  for (FloatArray* v : {&w.next_x, &w.next_y, &w.predicted_x, &w.predicted_y, &w.base_x, &w.base_y, &w.moved_x,
                        &w.moved_y, &w.corrected_x, &w.corrected_y})
    fill(*v, count, {});
  w.common_radius = 0.5f;
  if (!alike) {
    fill(w.radius, count, random(0.1, 0.5)), fill(w.mass, count, random(0.1, 30));
    w.mass.back() = 1;
    for (std::size_t i = count; i < w.mass.size(); ++i) w.mass[i] = 1;
  }
  w.chunks.resize((w.blocks() + kBlocksPerChunk - 1) / kBlocksPerChunk);
  s.k.dt = 1.0f / 48, s.k.part = s.k.dt / 8, s.k.inverse_part = 1 / s.k.part, s.k.blend = 0.0048f, s.k.growth = 1.02f;
  s.k.static_friction = 0.21f, s.k.kinetic_friction = 0.1f, s.k.velocity_change = 0.4f;
  s.k.far = far, s.k.far_horizon = 20, s.k.headway = 0.5f, s.k.cohesion = 0.3f, s.k.cohesion_range = 4;
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
  each([&](std::size_t c) { foresee(f, fast.k, c, f.next_x.data(), f.next_y.data()); });
  each([&](std::size_t c) { plainly::foresee(p, plain.k, c, p.next_x.data(), p.next_y.data()); });
  check_same(f.next_x, p.next_x), check_same(f.next_y, p.next_y);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < f.count; ++i) changed += f.next_x[i] != f.vx[i];
  if (to_come) CHECK(changed > f.count / 4);  // there was something to compare
  each([&](std::size_t c) { cohere(f, fast.k, c, f.next_x.data(), f.next_y.data()); });
  each([&](std::size_t c) { plainly::cohere(p, plain.k, c, p.next_x.data(), p.next_y.data()); });
  check_same(f.next_x, p.next_x), check_same(f.next_y, p.next_y);
  each([&](std::size_t c) { heed(f, fast.k, c), plainly::heed(p, plain.k, c); });
  check_same(f.wish_x, p.wish_x), check_same(f.wish_y, p.wish_y);
  each([&](std::size_t c) { stabilise(f, fast.k, c, f.next_x.data(), f.next_y.data()); });
  each([&](std::size_t c) { plainly::stabilise(p, plain.k, c, p.next_x.data(), p.next_y.data()); });
  check_same(f.next_x, p.next_x), check_same(f.next_y, p.next_y);
  each([&](std::size_t c) { predict(f, fast.k, c), plainly::predict(p, plain.k, c); });
  check_same(f.predicted_x, p.predicted_x);
  each([&](std::size_t c) { project(f, fast.k, c, f.corrected_x.data(), f.corrected_y.data()); });
  each([&](std::size_t c) { plainly::project(p, plain.k, c, p.corrected_x.data(), p.corrected_y.data()); });
  check_same(f.corrected_x, p.corrected_x), check_same(f.corrected_y, p.corrected_y);
  each([&](std::size_t c) { finish(f, fast.k, c), plainly::finish(p, plain.k, c); });
  check_same(f.next_x, p.next_x), check_same(f.vy, p.vy), check_same(f.predicted_y, p.predicted_y);
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

TEST_CASE("pbd: of a pile only the nearest count as contacts and nothing overflows") {
  State s = random_state(600, true, 1, 3);
  for (std::size_t i = 0; i < 600; ++i) s.work.x[i] *= 0.01f, s.work.y[i] *= 0.01f;
  std::vector<float> x(s.work.x.begin(), s.work.x.begin() + 600), y(s.work.y.begin(), s.work.y.begin() + 600);
  s.grid.build(x, y, 1.4f, 1);
  for (std::size_t i = 0; i < 600; ++i) s.work.x[i] = x[s.grid.order()[i]], s.work.y[i] = y[s.grid.order()[i]];
  compare(s, false);
}
