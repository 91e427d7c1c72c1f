#include "layout/solver.h"

#include <doctest/doctest.h>

#include <chrono>

#include "layout/check.h"
#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

/// A bedroom that anybody could furnish: 4 x 4 m, a bed, a cupboard, a desk with its chair, a lamp.
Scene easy_room() {
  Scene scene = empty_room(4, 4);
  add_door(scene, 0, 0.5, 0.9);
  const Ref bed = add(scene, "bed", {1.4, 2, 0.5}), cupboard = add(scene, "cupboard", {1.2, 0.6, 2});
  const Ref desk = add(scene, "desk", {1.2, 0.6, 0.75}), chair = add(scene, "chair", {0.5, 0.5, 0.9});
  add(scene, "lamp", {0.3, 0.3, 1.6});
  WallDistance wall;
  wall.members = list_of({bed, cupboard, desk});
  scene.constraints.add(wall);
  WallOrientation back;
  back.members = wall.members;
  scene.constraints.add(back);
  Distance reach;
  reach.between = {chair, desk}, reach.distance = 0.7;
  scene.constraints.add(reach);
  Orientation looks;
  looks.members = list_of({chair}), looks.to = desk;
  scene.constraints.add(looks);
  return scene;
}

Options quick(std::uint64_t seed = 1) {
  Options o;
  o.seed = seed, o.starts = 2, o.threads = 1;
  return o;
}

bool finite(const Placement& p) {
  for (const auto& o : p.objects) {
    if (!std::isfinite(o.position.x + o.position.y + o.position.z + o.angle)) return false;
  }
  return true;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("solver: both schemes furnish an easy room whatever the seed") {
  for (const Scheme scheme : {Scheme::gauss_seidel, Scheme::averaged}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(static_cast<int>(scheme));
      CAPTURE(seed);
      Options options = quick(seed);
      options.scheme = scheme;
      const Scene scene = easy_room();
      const auto outcome = furnish(scene, options);
      REQUIRE(outcome.ok());
      CHECK(outcome->best.feasible);
      CHECK(check(with_placement(scene, outcome->best.placement)).feasible);
      CHECK(outcome->starts.size() == 2);
    }
  }
}

TEST_CASE("solver: every way to start ends in a layout and the papers' method runs") {
  for (const Start start : {Start::given, Start::random, Start::placed}) {
    Options options = quick();
    options.start = start;
    const auto outcome = furnish(easy_room(), options);
    REQUIRE(outcome.ok());
    CHECK(outcome->best.feasible);
  }
  Options paper = quick();
  paper.paper = true, paper.starts = 10, paper.trace = true, paper.max_iterations = 1000;
  const auto outcome = furnish(easy_room(), paper);
  REQUIRE(outcome.ok());
  CHECK(finite(outcome->best.placement));
  for (const TraceRow& row : outcome->trace) CHECK_FALSE(row.relocated);
}

TEST_CASE("solver: the energy of a layout is that of its residuals") {
  const Scene scene = easy_room();
  for (const bool paper : {false, true}) {
    Options options = quick();
    options.paper = paper, options.max_iterations = 200;
    const auto outcome = furnish(scene, options);
    REQUIRE(outcome.ok());
    for (const Layout& l : outcome->starts) {
      const double energy = residuals(with_placement(scene, l.placement)).energy;
      CHECK(std::abs(energy - l.energy) <= 1e-9 * std::max(1e-3, energy));
    }
  }
}

TEST_CASE("solver: the trace has a row for every iteration of every start") {
  Options options = quick();
  options.trace = true, options.starts = 3, options.threads = 2, options.paper = true, options.max_iterations = 120;
  const auto outcome = furnish(easy_room(), options);
  REQUIRE(outcome.ok());
  REQUIRE(outcome->starts.size() == 3);
  std::size_t row = 0;
  for (const Layout& l : outcome->starts) {
    double best_feasible = 1e300, best = 1e300;
    for (int i = 1; i <= l.iterations; ++i, ++row) {
      REQUIRE(row < outcome->trace.size());
      const TraceRow& t = outcome->trace[row];
      CHECK(t.start == l.start);
      CHECK(t.iteration == i);
      CHECK((std::isfinite(t.energy) && t.energy >= 0 && t.overlap >= 0));
      if (t.feasible) best_feasible = std::min(best_feasible, t.energy);
      best = std::min(best, t.energy);
    }
    // What a start returns is the best row of its trace.
    CHECK(l.energy == (l.feasible ? best_feasible : best));
  }
  CHECK(row == outcome->trace.size());
}

TEST_CASE("solver: of several starts the best is feasible before it is low") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Options options = quick(seed);
    options.starts = 6, options.paper = true, options.max_iterations = 60;
    const auto outcome = furnish(easy_room(), options);
    REQUIRE(outcome.ok());
    for (const Layout& l : outcome->starts) {
      CHECK((outcome->best.feasible || !l.feasible));
      if (l.feasible == outcome->best.feasible) CHECK(outcome->best.energy <= l.energy);
    }
  }
}

TEST_CASE("solver: suggestions are distinct and the best comes first") {
  const Scene scene = easy_room();
  const auto list = suggest(scene, quick(), 3);
  REQUIRE(list.ok());
  REQUIRE(list->size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((*list)[i].feasible);
    if (i > 0) CHECK((*list)[i].energy >= (*list)[i - 1].energy);
    for (std::size_t j = 0; j < i; ++j) {
      bool distinct = false;
      for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        const auto &a = (*list)[i].placement.objects[k], &b = (*list)[j].placement.objects[k];
        const Vec3 size = scene.objects[k].size;
        distinct = distinct || length(a.position.xy() - b.position.xy()) > std::max(size.x, size.y) ||
                   std::abs(wrap_angle(a.angle - b.angle)) > kPi / 4;
      }
      CHECK(distinct);
    }
  }
}

TEST_CASE("solver: a room with only one layout suggests one") {
  Scene scene = empty_room(4, 4);
  const Ref a = add(scene, "a", {1, 1, 1}, {2, 2});
  scene.objects[a.index].fixed = true;
  const auto list = suggest(scene, quick(), 3);
  REQUIRE(list.ok());
  CHECK(list->size() == 1);
}

TEST_CASE("solver: more furniture than floor ends infeasible in bounded time with finite numbers") {
  Scene scene = empty_room(3, 3);
  for (int i = 0; i < 12; ++i) add(scene, "crate" + std::to_string(i), {1, 1, 1});
  Options options = quick();
  options.starts = 1, options.max_iterations = 2000;
  const auto begin = std::chrono::steady_clock::now();
  const auto outcome = furnish(scene, options);
  CHECK(seconds_since(begin) < 20);
  REQUIRE(outcome.ok());
  CHECK_FALSE(outcome->best.feasible);
  CHECK(outcome->best.violation > 0.1);
  CHECK(outcome->best.iterations <= 2000);
  CHECK(finite(outcome->best.placement));
}

TEST_CASE("solver: constraints that contradict each other end with a report") {
  Scene scene = empty_room(8, 8);
  const Ref a = add(scene, "a", {1, 1, 1}), b = add(scene, "b", {1, 1, 1});
  Distance near, far;
  near.between = far.between = {a, b};
  near.distance = 2, far.distance = 5;
  scene.constraints.add(near);
  scene.constraints.add(far);
  const auto begin = std::chrono::steady_clock::now();
  const auto outcome = furnish(scene, quick());
  CHECK(seconds_since(begin) < 5);
  REQUIRE(outcome.ok());
  CHECK(outcome->best.feasible);
  const CheckReport report = check(with_placement(scene, outcome->best.placement));
  CHECK(report.violations.size() >= 1);
  // The sum of the two residuals is 3 m wherever they stand between the two.
  CHECK(outcome->best.energy >= std::sqrt(4.5) - 1e-9);
  CHECK(outcome->best.energy <= 3.01);
}

TEST_CASE("solver: cancelled before it starts it still returns a layout in the room") {
  Cancel cancel;
  cancel.request();
  Options options = quick();
  options.cancel = &cancel;
  const Scene scene = easy_room();
  const auto outcome = furnish(scene, options);
  REQUIRE(outcome.ok());
  CHECK(outcome->cancelled);
  CHECK(outcome->starts.size() == 1);
  CHECK(finite(outcome->best.placement));
  CHECK(outcome->best.feasible == check(with_placement(scene, outcome->best.placement)).feasible);
}

TEST_CASE("solver: cancelled on its way it returns what it has") {
  Scene scene = empty_room(3, 3);
  for (int i = 0; i < 12; ++i) add(scene, "crate" + std::to_string(i), {1, 1, 1});
  Cancel cancel;
  Options options = quick();
  options.starts = 50, options.max_iterations = 300;
  options.cancel = &cancel;
  options.progress = [&](double, std::string_view) { cancel.request(); };
  const auto outcome = furnish(scene, options);
  REQUIRE(outcome.ok());
  CHECK(outcome->cancelled);
  CHECK(outcome->starts.size() >= 1);
  CHECK(outcome->starts.size() < 50);
  CHECK(finite(outcome->best.placement));
}

TEST_CASE("solver: progress rises to one") {
  Options options = quick();
  options.starts = 4;
  double last = 0;
  options.progress = [&](double done, std::string_view) {
    CHECK(done > last);
    last = done;
  };
  REQUIRE(furnish(easy_room(), options).ok());
  CHECK(last == 1);
}

TEST_CASE("solver: an empty scene and a scene without constraints are furnished too") {
  const auto none = furnish(empty_room(3, 3), quick());
  REQUIRE(none.ok());
  CHECK(none->best.feasible);
  Scene scene = empty_room(3, 3);
  add(scene, "only", {1, 1, 1});
  const auto one = furnish(scene, quick());
  REQUIRE(one.ok());
  CHECK(one->best.feasible);
  CHECK(one->best.energy < 1e-9);
}

TEST_CASE("solver: zero iterations are no licence to call anything feasible") {
  Scene scene = empty_room(3, 3);
  for (int i = 0; i < 12; ++i) add(scene, "crate" + std::to_string(i), {1, 1, 1});
  Options options = quick();
  options.max_iterations = 0;
  const auto outcome = furnish(scene, options);
  REQUIRE(outcome.ok());
  CHECK_FALSE(outcome->best.feasible);
}

TEST_CASE("solver: fitting one particle never moves another") {
  Scene scene = empty_room(6, 6);
  const Ref chair = add(scene, "chair", {0.5, 0.5, 1}, {2, 2}, 0), tv = add(scene, "tv", {1, 0.3, 1}, {4, 4});
  Orientation looks;
  looks.members = list_of({chair}), looks.to = tv;
  scene.constraints.add(looks);
  Ready ready(scene);
  Placer placer(ready.problem, ready.x);
  placer.reset({true, true});
  placer.lift(1);
  Rng rng(1);
  placer.place(1, rng, 16);
  CHECK(ready.x.bodies[0].p == Vec2{2, 2});
  CHECK(ready.x.bodies[0].angle == 0);
}
