#include "crowd/models/pbd_heed.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "core/rng.h"

using namespace inhabit::crowd;
using namespace inhabit::crowd::pbd_model;
using inhabit::scene::PbdModel;

namespace {

PbdModel heeding() {
  PbdModel model;
  model.headway = 2, model.headway_length = 0.1, model.anticipation = 0.5;
  return model;
}

void add(Agents& agents, float x, float y, float wish_x, float wish_y, float vx = 0, float vy = 0) {
  const std::size_t i = agents.add();
  agents.x[i] = x, agents.y[i] = y, agents.vx[i] = vx, agents.vy[i] = vy, agents.radius[i] = 0.2f;
  agents.wish_x[i] = wish_x, agents.wish_y[i] = wish_y, agents.id[i] = static_cast<std::uint32_t>(i);
}

/// Everybody is everybody's neighbour. Requires: at most a block of agents.
NeighbourRows all_of(std::size_t count) {
  NeighbourRows rows;
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      rows.items.push_back(static_cast<std::int32_t>(lane < count ? r : lane));
  rows.first.fill(static_cast<std::uint32_t>(count)), rows.first[0] = 0;
  return rows;
}

HeedWork heeded(const Agents& agents, const PbdModel& model) {
  HeedWork work;
  take(work, agents);
  heed(work, heed_constants(model), all_of(agents.size()), 0);
  return work;
}

}  // namespace

TEST_CASE("headway: behind somebody who stands the gap is closed in T") {
  Agents agents;
  add(agents, 0, 0, 1.3f, 0), add(agents, 1.5f, 0, 0, 0);
  const HeedWork work = heeded(agents, heeding());
  CHECK(work.wish_x[0] == doctest::Approx((1.5 - 0.4 - 0.1) / 2).epsilon(1e-6));
  CHECK(work.wish_y[0] == 0);
  CHECK(work.wish_x[1] == 0);
}

TEST_CASE("headway: at equal speeds it is T times what is not taken for granted") {
  // v = gap / T + lambda v, so gap = (1 - lambda) T v: 0.8 m at 0.8 m/s.
  Agents agents;
  add(agents, 0, 0, 1.3f, 0, 0.8f, 0), add(agents, 1.3f, 0, 1.3f, 0, 0.8f, 0);
  const HeedWork work = heeded(agents, heeding());
  CHECK(work.wish_x[0] == doctest::Approx(0.8).epsilon(1e-6));
  CHECK(work.wish_x[1] == doctest::Approx(1.3).epsilon(1e-6));
}

TEST_CASE("headway: only the one behind heeds and who comes the other way is not heeded") {
  Agents crossing;  // both have the other ahead; the second is a little ahead of the first along their mean direction
  add(crossing, 0, 0.01f, 1, 1), add(crossing, 0.6f, 0, -1, 1);
  HeedWork work = heeded(crossing, heeding());
  const auto speed = [&](std::size_t i) { return std::hypot(work.wish_x[i], work.wish_y[i]); };
  CHECK(speed(1) < 1.4f);
  CHECK(speed(0) == doctest::Approx(std::sqrt(2)).epsilon(1e-6));
  Agents oncoming;
  add(oncoming, 0, 0, 1, 0), add(oncoming, 0.6f, 0, -1, 0);
  work = heeded(oncoming, heeding());
  CHECK(speed(0) == 1);
  CHECK(speed(1) == 1);
}

TEST_CASE("headway: bodies beside the way do not count and broad ones do") {
  PbdModel model = heeding();
  Agents agents;
  add(agents, 0, 0, 1.3f, 0), add(agents, 0.8f, 0.6f, 0, 0);
  CHECK(heeded(agents, model).wish_x[0] == doctest::Approx(1.3).epsilon(1e-6));
  model.headway_breadth = 2;  // half a breadth of 1 m; s = 0.8 - 0.5 sqrt(1 - 0.36) = 0.4
  CHECK(heeded(agents, model).wish_x[0] == doctest::Approx(0.2).epsilon(1e-5));
}

TEST_CASE("sidestep: people turn to where the way is longer and to the right when both sides are alike") {
  PbdModel model = heeding();
  model.sidestep = 60;
  Agents agents;
  add(agents, 0, 0, 1.3f, 0), add(agents, 0.7f, 0, 0, 0);
  const HeedWork work = heeded(agents, model);
  CHECK(work.wish_x[0] > 0.5f);
  CHECK(work.wish_y[0] < -0.3f);
  Agents alone;
  add(alone, 0, 0, 1.3f, 0);
  CHECK(heeded(alone, model).wish_y[0] == 0);
}

TEST_CASE("sidestep: nobody steps aside into a wall") {
  PbdModel model = heeding();
  model.sidestep = 60;
  const auto turned = [&](double below, double above) {
    const Walls walls({make_floor({{-9, -below}, {9, -below}, {9, above}, {-9, above}}, {})}, {}, 1);
    Agents agents;
    add(agents, 0, 0, 1.3f, 0), add(agents, 1, 0, 0, 0);
    std::vector<NearWall> near;
    for (std::uint32_t s = 0; s < walls.segments().size(); ++s) near.push_back({0, s});
    HeedWork work;
    take(work, agents);
    find_room(work, walls, near);
    heed(work, heed_constants(model), all_of(agents.size()), 0);
    return work.wish_y[0];
  };
  CHECK(turned(3, 3) < -0.3f);
  CHECK(turned(0.25, 3) > 0.3f);      // 5 cm to the right of the body
  CHECK(turned(0.22, 0.22) == 0);     // straight on, however slowly
  CHECK(turned(0.45, 0.45) < -0.3f);  // 25 cm are room enough
}

TEST_CASE("hesitation: who is held up stands still for its share of the time and nobody else does") {
  Agents agents;
  add(agents, 0, 0, 1, 0, 0.1f, 0), add(agents, 5, 0, 1, 0, 0.9f, 0);
  int still = 0;
  constexpr int kMoments = 4000;
  for (int m = 0; m < kMoments; ++m) {
    HeedWork work;
    take(work, agents);
    work.wish_x = {1, 1}, work.wish_y = {0, 0};
    hesitate(work, agents, 0.3, 0.5 * m, 0);
    still += work.wish_x[0] == 0;
    CHECK(work.wish_x[1] == 1);
  }
  // Four standard deviations of a binomial count.
  CHECK(std::abs(still - 0.3 * kMoments) < 4 * std::sqrt(kMoments * 0.3 * 0.7));
}

TEST_CASE("headway: every instruction set gives the bits of the readable version") {
  inhabit::core::Rng rng(5);
  Agents agents;
  constexpr std::size_t kPeople = 700;
  for (std::size_t i = 0; i < kPeople; ++i)
    add(agents, static_cast<float>(rng.uniform(0, 16)), static_cast<float>(rng.uniform(0, 16)),
        static_cast<float>(rng.uniform(-1.5, 1.5)), static_cast<float>(i % 9 == 0 ? 0 : rng.uniform(-1.5, 1.5)),
        static_cast<float>(rng.uniform(-1, 1)), static_cast<float>(rng.uniform(-1, 1)));
  for (std::size_t i = 0; i < kPeople; i += 3) agents.radius[i] = static_cast<float>(rng.uniform(0.1, 0.4));
  PbdModel model = heeding();
  model.headway_breadth = 1.2, model.sidestep = 70;
  const HeedConstants k = heed_constants(model);
  HeedWork fast;
  take(fast, agents);
  for (std::size_t i = 0; i < kPeople; i += 2)
    fast.left[i] = static_cast<float>(rng.uniform(0, kRoom)),
    fast.right[i] = static_cast<float>(rng.uniform(0, 2 * kRoom));
  std::vector<NeighbourRows> rows(2);
  for (std::size_t c = 0; c < rows.size(); ++c)
    for (std::size_t b = 0; b < kBlocksPerChunk; ++b) {
      constexpr std::uint32_t kRows = 9;
      for (std::uint32_t r = 0; r < kRows; ++r)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          rows[c].items.push_back(static_cast<std::int32_t>(rng.index(kPeople)));
      rows[c].first[b + 1] = rows[c].first[b] + kRows;
    }
  HeedWork plain = fast;
  for (std::size_t c = 0; c < rows.size(); ++c) plainly::heed(plain, k, rows[c], c);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < kPeople; ++i) changed += plain.wish_x[i] != agents.wish_x[i];
  CHECK(changed > kPeople / 4);
  const std::int64_t all = hwy::SupportedTargets();
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    CAPTURE(hwy::TargetName(target));
    for (std::size_t c = 0; c < rows.size(); ++c) heed(fast, k, rows[c], c);
    CHECK(std::memcmp(fast.wish_x.data(), plain.wish_x.data(), kPeople * sizeof(float)) == 0);
    CHECK(std::memcmp(fast.wish_y.data(), plain.wish_y.data(), kPeople * sizeof(float)) == 0);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}
