#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "annealing/arranger.h"
#include "annealing/test_room.h"

using namespace inhabit::annealing;
using namespace inhabit::annealing::testing;

namespace {

struct Furnished {
  Scene scene = flat(2);
  Priors priors = some_priors();
  Targets targets = choose_targets(scene, priors, 1);
  Result<Furniture> furniture = compile(scene, targets, {});
  Arrangement x{*furniture};
};

/// Makes the move until it has been made `times` times; `look` sees the state before and after each.
template <class Move, class Look>
int made(Arrangement& x, int times, Look look) {
  Rng rng(11);
  int done = 0;
  for (int k = 0; k < 200 * times && done < times; ++k) {
    const Arrangement::Snapshot before = x.snapshot();
    if (!Move::make(x, {0.3, 0.3}, rng, [] {})) continue;
    x.settle();
    look(before, x.snapshot());
    ++done;
  }
  return done;
}

}  // namespace

TEST_CASE("swapped objects stand in each other's places and belong to the same tier") {
  Furnished f;
  Arranger arranger(*f.furniture, {});
  Rng rng(2);
  arranger.scatter(rng, false);
  f.x.restore(arranger.snapshot());
  const int done = made<Swap>(f.x, 100, [&](const auto& before, const auto& after) {
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < before.positions.size(); ++i) {
      const bool moved = before.positions[i] != after.positions[i];
      // A carried object that kept its carrier only went along.
      if (moved && !(f.furniture->items[i].carried && before.carriers[i] == after.carriers[i])) roots.push_back(i);
    }
    if (roots.size() != 2) return;  // two of one carrier's
    CHECK(before.positions[roots[0]] == after.positions[roots[1]]);
    CHECK(before.angles[roots[1]] == after.angles[roots[0]]);
    CHECK(f.furniture->items[roots[0]].carried == f.furniture->items[roots[1]].carried);
  });
  CHECK(done == 100);
}

TEST_CASE("what hangs on a wall slides along walls with its back to them") {
  Furnished f;
  const int done = made<Slide>(f.x, 100, [&](const auto&, const auto&) {
    for (std::uint32_t i = 0; i < f.furniture->items.size(); ++i) {
      if (!f.furniture->items[i].hung) continue;
      const Box& box = f.x.body(i).box;
      if (box.center == f.furniture->room.center()) continue;  // not moved yet
      const WallPoint w = f.furniture->room.nearest_wall(box.center - box.half_depth * box.front);
      CHECK(std::abs(w.distance) < 1e-9);
      CHECK(dot(f.furniture->room.walls()[w.wall].normal, box.front) > 1 - 1e-12);
    }
  });
  CHECK(done == 100);
}

TEST_CASE("a carrier is changed for another that may carry it with its place on top kept") {
  Furnished f;
  const int done = made<ChangeCarrier>(f.x, 50, [&](const auto& before, const auto& after) {
    for (std::uint32_t i = 0; i < before.carriers.size(); ++i) {
      if (before.carriers[i] == after.carriers[i]) continue;
      CHECK(f.scene.objects[i].kind == "plate");
      CHECK(f.scene.objects[after.carriers[i]].kind == "table");
      const Vec2 a = rotate_back(before.positions[i] - before.positions[before.carriers[i]],
                                 direction(before.angles[before.carriers[i]]));
      const Vec2 b = rotate_back(after.positions[i] - after.positions[after.carriers[i]],
                                 direction(after.angles[after.carriers[i]]));
      CHECK(length(a - b) < 1e-9);
    }
  });
  CHECK(done == 50);
}

TEST_CASE("what is taken to its prior costs nothing there") {
  Furnished f;
  std::map<std::string, int> kinds;
  made<ToPrior>(f.x, 300, [&](const auto& before, const auto& after) {
    for (std::uint32_t i = 0; i < before.positions.size(); ++i) {
      if (f.scene.objects[i].kind != "bookcase" || before.positions[i] == after.positions[i]) continue;
      ++kinds["bookcase"];
      CHECK(PriorAngle::of_item(f.x, i) < 1e-9);
      // Unless another wall is nearer, in a corner, or it was put back into the room.
      if (f.furniture->room.contains(after.positions[i] - 0.2 * direction(after.angles[i])))
        CHECK(PriorDistance::of_item(f.x, i) < 0.021);
    }
  });
  CHECK(kinds["bookcase"] > 5);
}

TEST_CASE("steps have the deviation that they are asked for") {
  Furnished f;
  double sum = 0, squares = 0;
  int n = 0;
  Rng rng(4);
  for (int k = 0; k < 20000; ++k) {
    const Vec2 s = normal_shift(rng, 0.25);
    sum += s.x + s.y, squares += dot(s, s), n += 2;
  }
  // 40,000 samples: the mean's standard error is 0.00125, the deviation's 0.0009.
  CHECK(std::abs(sum / n) < 0.006);
  CHECK(std::abs(std::sqrt(squares / n) - 0.25) < 0.005);
}

TEST_CASE("what is fixed or hangs where the scene says is never moved") {
  Scene scene = flat(1);
  scene.objects[0].position = Vec3{2, 2, 0}, scene.objects[0].angle = 0.3, scene.objects[0].fixed = true;
  Object& picture = scene.objects.back();
  picture.mount = Mount::wall, picture.position = Vec3{3, 0.02, 1.4}, picture.angle = kPi / 2;
  const Priors priors = some_priors();
  const auto furniture = compile(scene, choose_targets(scene, priors, 1), {});
  REQUIRE(furniture.ok());
  Arranger arranger(*furniture, {});
  Rng rng(9);
  arranger.scatter(rng, false);
  for (int k = 0; k < 5000; ++k) arranger.propose(rng, 1), arranger.accept();
  CHECK(arranger.arrangement().position(0) == Vec2{2, 2});
  CHECK(arranger.arrangement().angle(0) == 0.3);
  const auto last = static_cast<std::uint32_t>(scene.objects.size() - 1);
  CHECK(arranger.arrangement().position(last) == Vec2{3, 0.02});
  CHECK(arranger.arrangement().body(last).low == 1.4);
}
