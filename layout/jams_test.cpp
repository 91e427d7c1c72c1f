#include "layout/jams.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// Rows of boxes half a metre wide, `pitch` metres apart, each somewhere within `off` of its place.
Scene rows(int columns, int rows, double pitch, double off, std::uint64_t seed) {
  Scene scene = empty_room(pitch * columns + 1, pitch * rows + 1);
  inhabit::core::Rng rng(seed);
  for (int i = 0; i < columns * rows; ++i) {
    const Vec2 p{0.5 + pitch * (i % columns + 0.5), 0.5 + pitch * (i / columns + 0.5)};
    const Vec2 shift{rng.uniform(-off, off), rng.uniform(-off, off)};
    add(scene, std::to_string(i), {0.5, 0.5, 1}, p + shift, rng.uniform(-180, 180));
  }
  return scene;
}

/// The violations of all pairs and boxes, asked one by one.
Score everything(const Ready& r) {
  Score s;
  double squares = 0;
  for (std::uint32_t i = 0; i < r.x.boxes.size(); ++i) {
    score_boundary(r.problem, r.x, i, s, squares);
    for (std::uint32_t j = i + 1; j < r.x.boxes.size(); ++j) {
      const double depth = separation(r.x.boxes[i], r.x.boxes[j]).depth;
      if (depth > 0) s.violation += depth, s.worst = std::max(s.worst, depth);
    }
  }
  return s;
}

/// Sums of some thousand terms below a metre.
constexpr double kRounding = 1e-9;

}  // namespace

TEST_CASE("a polish of jammed spots ends where whole sweeps end") {
  // Corners overlap here and there: nobody strays, so both keep their pairs.
  const Scene scene = rows(20, 20, 0.62, 0.02, 5);
  Ready jammed(scene), whole(scene);
  Contacts a(jammed.problem), b(whole.problem);
  Jams jams(jammed.problem, a);
  jams.reset(jammed.x);
  b.refresh(whole.x);
  Direct sink{whole.x};
  REQUIRE(everything(whole).worst > 0.01);
  for (int i = 0; i < 20; ++i) {
    jams.sweep(jammed.x);
    for (const Contacts::Pair& pair : b.pairs()) b.project_pair(whole.x, pair, 1, sink, 1e-6);
    for (std::uint32_t k = 0; k < whole.x.boxes.size(); ++k) {
      whole.problem.room.for_each_violation(whole.x.boxes[k], [&](Vec2 n, double depth) {
        if (depth > 1e-6) whole.x.shift(k, depth * n);
      });
    }
    for (std::uint32_t k = 0; k < whole.x.bodies.size(); ++k) CHECK(jammed.x.bodies[k].p == whole.x.bodies[k].p);
  }
  CHECK(everything(jammed).worst < 0.5 * everything(Ready(scene)).worst);
}

TEST_CASE("a polish scores every overlap although it looks at few and boxes stray") {
  // Everything starts in one half of the room, so the heap spreads by metres.
  Scene scene = rows(12, 12, 0.3, 0.1, 6);
  scene.space.outline = empty_room(12, 12).space.outline;
  Ready r(scene);
  Contacts contacts(r.problem);
  Jams jams(r.problem, contacts);
  jams.reset(r.x);
  double farthest = 0;
  for (int i = 0; i < 40; ++i) {
    jams.sweep(r.x);
    if (i % 4 != 3) continue;
    Score s;
    double squares = 0;
    jams.score(r.x, s, squares);
    const Score expected = everything(r);
    CHECK(std::abs(s.violation - expected.violation) < kRounding);
    CHECK(s.worst == expected.worst);
    for (std::uint32_t k = 0; k < r.x.bodies.size(); ++k)
      farthest = std::max(farthest, length(r.x.bodies[k].p - r.problem.start[k].p));
  }
  CHECK(farthest > 1);
}

TEST_CASE("in a large hall the pairs of who strays are those found anew") {
  Scene scene = rows(50, 50, 0.8, 0.05, 7);
  for (std::size_t i = 0; i < scene.objects.size(); i += 3) scene.objects[i].clearance.front = 0.4;
  add_door(scene, 0, 3, 1);
  // One that is large, and moves.
  add(scene, "stage", {6, 3, 1}, {20, 20});
  Ready r(scene);
  Contacts kept(r.problem);
  kept.refresh(r.x);
  inhabit::core::Rng rng(8);
  for (int round = 0; round < 60; ++round) {
    const auto n = static_cast<std::uint32_t>(r.x.bodies.size());
    for (int i = 0; i < 10; ++i) {
      const std::uint32_t body = round % 7 == 0 && i == 0 ? n - 1 : rng.index(n);
      // Some step over to their neighbours, some cross the hall, two of them to the same place.
      const double reach = i < 8 ? 0.6 : 10;
      r.x.shift(body, {rng.uniform(-reach, reach), rng.uniform(-reach, reach)});
      if (i == 9) r.x.place(body, r.x.bodies[rng.index(n)].p + Vec2{0.1, 0}, 1);
    }
    kept.refresh(r.x);
    Contacts fresh(r.problem);
    fresh.refresh(r.x);
    Score a, b;
    double squares_a = 0, squares_b = 0;
    kept.score(r.x, a, squares_a), fresh.score(r.x, b, squares_b);
    REQUIRE(b.violation > 0);
    CHECK(std::abs(a.violation - b.violation) < kRounding);
    CHECK(std::abs(squares_a - squares_b) < 150 * kRounding);
    CHECK(a.worst == b.worst);
    CHECK(a.slack == b.slack);
  }
}
