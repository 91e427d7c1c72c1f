#include "session/furnish_methods.h"

#include <doctest/doctest.h>

#include "exemplar/learn.h"
#include "session/exemplar_scenes.h"
#include "session/layout_walk.h"
#include "session/paper_scenes.h"
#include "session/prior_scene.h"

using namespace inhabit::session;

namespace {

struct Lesson {
  Scene input;
  Priors priors;
  explicit Lesson(const char* name) {
    const ExemplarScene* scene = find_exemplar_scene(name);
    REQUIRE(scene != nullptr);
    std::vector<Scene> rooms;
    for (int k = 1; k <= kExemplars; ++k) rooms.push_back(exemplar_room(*scene, k));
    inhabit::exemplar::LearnOptions options;
    for (const auto& [first, second] : scene->pairs) options.pairs.emplace_back(first, second);
    auto learned = inhabit::exemplar::learn(rooms, options);
    REQUIRE(learned.ok());
    priors = learned->priors;
    input = exemplar_input(*scene);
  }
  FurnishJob job(Method method, std::uint64_t seed = 1) const {
    FurnishJob job;
    job.method = method, job.priors = priors;
    job.anneal.weights.learned = priors.weights;
    job.anneal.iterations = 60000;
    job.layout.seed = seed, job.layout.starts = 1, job.layout.threads = 1;
    return job;
  }
};

}  // namespace

TEST_CASE("a living room is furnished from its exemplars by every method and both leaves nothing wrong") {
  const Lesson lesson("living-room");
  for (const Method method : {Method::pbd, Method::anneal, Method::both}) {
    CAPTURE(static_cast<int>(method));
    const FurnishJob job = lesson.job(method);
    const auto found =
        method == Method::pbd ? furnish_by_projection(lesson.input, job) : furnish_by_annealing(lesson.input, job);
    REQUIRE(found.ok());
    REQUIRE(found->list.size() == 1);
    const Suggestion& s = found->list.front();
    CHECK(s.scene.objects.size() == lesson.input.objects.size());
    CHECK(s.scene.house_rules);
    CHECK(s.report.feasible);
    if (method == Method::both) CHECK(faults_of(s.scene, s.report).none());
  }
}

TEST_CASE("the same seed gives the same arrangement at any number of threads") {
  const Lesson lesson("bedroom");
  FurnishJob job = lesson.job(Method::both, 3);
  job.layout.starts = 3, job.anneal.replicas = 2, job.anneal.iterations = 4000;
  const auto one = furnish_by_annealing(lesson.input, job);
  job.layout.threads = 4;
  const auto four = furnish_by_annealing(lesson.input, job);
  REQUIRE(one.ok());
  REQUIRE(four.ok());
  CHECK(one->list.front().scene == four->list.front().scene);
}

TEST_CASE("suggestions are distinct and best first") {
  const Lesson lesson("living-room");
  FurnishJob job = lesson.job(Method::anneal);
  job.variants = 3, job.anneal.iterations = 5000;
  const auto found = furnish_by_annealing(lesson.input, job);
  REQUIRE(found.ok());
  CHECK(found->list.size() == 3);
  const auto faults = [&](std::size_t k) { return faults_of(found->list[k].scene, found->list[k].report); };
  CHECK(faults(0) <= faults(1));
  CHECK(faults(1) <= faults(2));
}

TEST_CASE("annealing without priors is an error that says what to do") {
  FurnishJob job;
  job.method = Method::anneal;
  const auto found = furnish_by_annealing(living_room(), job);
  REQUIRE(!found.ok());
  CHECK(found.error().message.find("inhabit learn") != std::string::npos);
}

TEST_CASE("targets become constraints that a scene as learned satisfies") {
  // A shelf at its wall, a chair before its desk as learned: nothing is violated.
  Scene scene;
  scene.space.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
  const auto add = [&](const char* id, Vec3 size, Vec2 p, double degrees) {
    Object o;
    o.id = o.kind = id, o.size = size, o.position = Vec3{p.x, p.y, 0}, o.angle = inhabit::core::radians(degrees);
    scene.objects.push_back(o);
  };
  add("shelf", {1, 0.3, 2}, {1, 0.25}, 90);
  // Its right side 0.1 from the wall x = 5, along which it heads.
  add("bed", {1, 2, 0.5}, {4.4, 2}, 90);
  add("desk", {1.4, 0.7, 0.75}, {1.5, 3.6}, -90);
  add("stool", {0.4, 0.4, 0.5}, {1.5, 2.9}, 90);
  Priors priors;
  priors.kinds = {{.kind = "bed", .count = 5, .back = Face::right, .wall = {{0.1, 0, 0, 0, 5}}},
                  {.kind = "desk", .count = 5, .wall = {{0.05, 0, 0, 0, 5}}},
                  {.kind = "shelf", .count = 5, .wall = {{0.1, 0, 0, 0, 5}}}};
  priors.pairs = {{"desk", "stool", {{0.7, 0, 0, 0, 0, 0, 5}}, 1, false, 5, 5, 0, false}};
  const inhabit::annealing::Targets targets = inhabit::annealing::choose_targets(scene, priors, 1);
  const auto report = inhabit::layout::check(with_targets(scene, targets));
  for (const auto& v : report.violations) FAIL_CHECK(v.text);
  CHECK(report.constraints.size() >= 4);
}

TEST_CASE("weights are set by name and unknown names offer the nearest") {
  inhabit::annealing::Weights weights;
  CHECK(set_weight(weights, "pair-angle", 3).ok());
  CHECK(weights.learned.pair_angle == 3);
  CHECK(set_weight(weights, "overlap", 7).ok());
  CHECK(weights.overlap == 7);
  const auto bad = set_weight(weights, "pair-angel", 3);
  REQUIRE(!bad.ok());
  CHECK(bad.error().message.find("pair angle") != std::string::npos);
}

TEST_CASE("steps of the baseline add up to the energy that the position-based method counts") {
  for (const char* name : {"living-room", "desk", "tight-bedroom", "picnic"}) {
    CAPTURE(name);
    const Scene scene = find_paper_scene(name)->build();
    const auto problem = inhabit::layout::compile(scene);
    REQUIRE(problem.ok());
    LayoutWalk walk(*problem, 1, 1, 0.1);
    inhabit::core::Rng rng(3);
    double energy = walk.cost();
    for (int k = 0; k < 400; ++k) {
      const double change = walk.propose(rng, rng.uniform(0.01, 1));
      if (rng.index(2) == 0) {
        walk.reject();
      } else {
        walk.accept(), energy += change;
      }
      // Squares of some thousands that nearly cancel: rounding of 1e-12, its root when the rest is small.
      if (k % 20 == 0) CHECK(std::abs(energy - walk.cost()) < 1e-5);
    }
    CHECK(std::abs(walk.score().energy - walk.cost()) < 1e-9);
  }
}

TEST_CASE("the baseline starts where the position-based method starts and ends lower") {
  const Scene scene = living_room();
  BaselineOptions options;
  std::vector<inhabit::layout::TraceRow> rows;
  options.iterations = 5000, options.trace = &rows;
  const auto a = anneal_layout(scene, options);
  options.trace = nullptr;
  const auto b = anneal_layout(scene, options);
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  CHECK(a->energy == b->energy);
  CHECK(a->energy < 0.2 * rows.front().energy);
}
