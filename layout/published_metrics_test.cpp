#include "layout/published_metrics.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace inhabit::layout;

namespace {

Scene room(double w, double h) {
  Scene scene;
  scene.space.outline = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  return scene;
}

void add(Scene& scene, std::string id, Vec3 size, Vec3 position, double angle = -90) {
  Object object;
  object.id = std::move(id);
  object.size = size;
  object.position = position;
  object.angle = radians(angle);
  scene.objects.push_back(object);
}

}  // namespace

TEST_CASE("an empty room is wholly navigable and a room full of boxes not at all") {
  Scene scene = room(4, 4);
  CHECK(sceneeval_navigability(scene) == 1);
  CHECK(physcene(scene).walkable == 1);
  CHECK(physcene(scene).walkable_physcene_compat == 1);
  add(scene, "block", {4, 4, 1}, {2, 2, 0});
  CHECK(sceneeval_navigability(scene) == 0);
  CHECK(physcene(scene).walkable == 0);
}

TEST_CASE("a wall of boxes halves the navigable floor unless it hangs high") {
  Scene scene = room(6, 6);
  for (int i = 0; i < 6; ++i) add(scene, std::to_string(i), {1, 0.2, 1}, {0.5 + i, 3, 0});
  CHECK(sceneeval_navigability(scene) == doctest::Approx(0.5).epsilon(0.02));
  CHECK(physcene(scene).walkable == doctest::Approx(0.5).epsilon(0.02));
  for (Object& o : scene.objects) o.position->z = 1.8;
  CHECK(sceneeval_navigability(scene) == 1);
  CHECK(physcene(scene).walkable == 1);
}

TEST_CASE("a wall drawn turned cuts the same floor as a straight one") {
  Scene across = room(6, 6), along = room(6, 6);
  add(across, "w", {6, 0.2, 1}, {3, 2, 0}, -90);
  add(along, "w", {6, 0.2, 1}, {2, 3, 0}, 0);
  CHECK(sceneeval_navigability(across) == doctest::Approx(sceneeval_navigability(along)).epsilon(0.02));
  CHECK(sceneeval_navigability(across) == doctest::Approx(3.7 / (3.7 + 1.7)).epsilon(0.03));
}

TEST_CASE("the published PhyScene code reports the first part where the paper means the largest") {
  Scene scene = room(6, 6);
  // The upper part, which the raster meets first, is the smaller one.
  add(scene, "w", {6, 0.2, 1}, {3, 4.5, 0});
  const PhyScene p = physcene(scene);
  CHECK(p.walkable > 0.7);
  CHECK(p.walkable_physcene_compat == doctest::Approx(1 - p.walkable));
  CHECK_FALSE(p.walkable_doors.has_value());
  Door d;
  d.wall = 2, d.from = 2, d.width = 1;
  scene.space.doors.push_back(d);
  CHECK(*physcene(scene).walkable_doors == doctest::Approx(1 - p.walkable));
}

TEST_CASE("PhyScene counts colliding boxes strictly and what crosses the floor's edge") {
  Scene scene = room(6, 6);
  add(scene, "a", {1, 1, 1}, {2, 2, 0});
  add(scene, "b", {1, 1, 1}, {3, 2, 0});
  add(scene, "on a", {1, 1, 1}, {2, 2, 1});
  CHECK(physcene(scene).colliding == 0);
  CHECK(physcene(scene).out == 0);
  scene.objects[1].position->x = 2.99;
  scene.objects[2].position->x = 0.2;
  CHECK(physcene(scene).colliding == 2);
  CHECK(physcene(scene).out == 1);
}

TEST_CASE("R_reach weighs each part of the floor with the objects that it touches") {
  Scene scene = room(6, 6);
  CHECK(physcene(scene).reach == 0);
  add(scene, "a", {0.5, 0.5, 1}, {1, 1, 0});
  CHECK(physcene(scene).reach == doctest::Approx(1));
  // The wall is touched from both sides, the object from one half only.
  add(scene, "w", {6, 0.2, 1}, {3, 3, 0});
  CHECK(physcene(scene).reach == doctest::Approx(0.75).epsilon(0.03));
}

TEST_CASE("a free side is accessible and a side at the wall or another box is not") {
  Scene scene = room(6, 6);
  add(scene, "a", {1, 1, 1}, {3, 3, 0});
  CHECK(sceneeval_accessibility(scene).empty());
  scene.objects[0].clearance.front = 0.5;
  CHECK(sceneeval_accessibility(scene)[0].score == doctest::Approx(1));
  // The front looks down.
  add(scene, "b", {2, 1, 1}, {3, 2, 0});
  CHECK(sceneeval_accessibility(scene)[0].score == doctest::Approx(0));
  scene.objects[1].position = Vec3{3.5, 2, 0};
  scene.objects[1].size.x = 1;
  CHECK(sceneeval_accessibility(scene)[0].score == doctest::Approx(0.5).epsilon(0.1));
  // The best side counts.
  scene.objects[0].clearance.left = 0.5;
  CHECK(sceneeval_accessibility(scene)[0].score > 0.95);  // its strip loses a row of pixels to the object
}

TEST_CASE("an opening is hidden by the share of its face that boxes in front of it cover") {
  Scene scene = room(6, 6);
  scene.space.doors.push_back({.id = "door", .wall = 0, .from = 2, .width = 1, .height = 2});
  scene.space.windows.push_back({.id = "window", .wall = 2, .from = 2, .width = 2, .sill = 1, .height = 1});
  auto list = sceneeval_opening_clearance(scene);
  REQUIRE(list.size() == 2);
  CHECK_FALSE(list[0].occluded);
  // Covers the door's left half up to its half height; the window is 0.6 m away.
  add(scene, "low", {1, 0.4, 1}, {2, 0.5, 0});
  add(scene, "far", {2, 0.4, 2}, {3, 5.2, 0});
  list = sceneeval_opening_clearance(scene);
  CHECK(list[0].occluded);
  CHECK(list[0].share == doctest::Approx(0.25).epsilon(0.03));
  CHECK_FALSE(list[1].occluded);
  scene.objects[1].position->y = 5.6;
  CHECK(sceneeval_opening_clearance(scene)[1].share == doctest::Approx(1));
}

TEST_CASE("an opening of square kilometres takes no gigabytes") {
  Scene scene = room(1e4, 1e4);
  Window window;
  window.id = "view", window.wall = 0, window.from = 0, window.width = 1e4, window.sill = 0, window.height = 1e3;
  scene.space.windows.push_back(window);
  add(scene, "tower", {2500, 1, 1e3}, {5000, 0.5, 0}, 90);
  const auto list = sceneeval_opening_clearance(scene);
  REQUIRE(list.size() == 1);
  CHECK(list[0].share == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("out of bound means one per cent of the surface off the floor") {
  Scene scene = room(6, 6);
  add(scene, "in", {1, 1, 1}, {0.5, 3, 0});
  add(scene, "out", {1, 1, 1}, {0.4, 1, 0});
  CHECK(sceneeval_out_of_bound(scene, 1) == std::vector<std::string>{"out"});
  // Flush with the wall, a sixth of the samples lies on the floor's very edge and counts as above it.
  scene.objects[1].position->x = 0.5;
  CHECK(sceneeval_out_of_bound(scene, 1).empty());
}

TEST_CASE("SceneEval's collision forgives five millimetres") {
  Scene scene = room(6, 6);
  add(scene, "a", {1, 1, 1}, {2, 2, 0});
  add(scene, "b", {1, 1, 1}, {2.996, 2, 0});
  CHECK(sceneeval_colliding(scene) == 0);
  scene.objects[1].position->x = 2.99;
  CHECK(sceneeval_colliding(scene) == 2);
}

TEST_CASE("relations are certain inside their range and fade outside") {
  CHECK(sceneeval_relation(Relation::next_to, 0.3) == 1);
  CHECK(sceneeval_relation(Relation::near, 0.3) == doctest::Approx(std::exp(-0.04 / 0.125)));
  CHECK(sceneeval_relation(Relation::near, 1.75) == doctest::Approx(std::exp(-0.5)));
  CHECK(sceneeval_relation(Relation::far, 1e4) == 1);
  CHECK(sceneeval_relation(Relation::against_wall, 0.4) == doctest::Approx(std::exp(-0.5)));
}

TEST_CASE("LayoutGPT looks at the room's bounding rectangle with a tenth of a metre of slack") {
  Scene scene = room(4, 4);
  scene.space.outline = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  add(scene, "in the notch", {1, 1, 1}, {3, 3, 0});
  add(scene, "slack", {1, 1, 1}, {0.41, 1, 0});
  CHECK(layoutgpt_out_of_bound(scene) == 0);
  scene.objects[1].position->x = 0.39;
  CHECK(layoutgpt_out_of_bound(scene) == 1);
}

TEST_CASE("ReSpace measures volumes outside and shared in voxels of five centimetres") {
  Scene scene = room(4, 4);
  add(scene, "a", {1, 1, 1}, {1, 1, 0});
  CHECK(respace(scene).pbl == 0);
  add(scene, "b", {1, 1, 1}, {1.5, 1, 0.5});
  CHECK(respace(scene).mbl == doctest::Approx(0.25));
  add(scene, "c", {1, 1, 1}, {4, 3, 0});
  const ReSpace r = respace(scene);
  CHECK(r.oob == doctest::Approx(0.5));
  CHECK(r.pbl == doctest::Approx(0.75));
}

TEST_CASE("DiffuScene counts intersections of upright bounds and symmetric pairs") {
  Scene scene = room(6, 6);
  add(scene, "a", {1, 1, 1}, {1, 1, 0});
  add(scene, "b", {1, 1, 1}, {1.5, 1, 0});
  add(scene, "c", {1, 1, 1}, {4, 4, 0});
  const DiffuScene d = diffuscene(scene);
  CHECK(d.mean_iou == doctest::Approx(1.0 / 3 / 3));
  CHECK(d.intersecting == doctest::Approx(1.0 / 3));
  CHECK(*d.symmetric == 1);
}

TEST_CASE("Infinigen's costs are nothing for an object that looks along the nearest side's normal") {
  const Box a{{0, 0}, {1, 0}, 0.5, 0.5}, b{{3, 0}, {0, 1}, 0.5, 1};
  CHECK(infinigen_focus(a, b) == doctest::Approx(0));
  CHECK(infinigen_focus({{0, 0}, {-1, 0}, 0.5, 0.5}, b) == doctest::Approx(1));
  CHECK(infinigen_angle_alignment(a, b) == doctest::Approx(0));
  CHECK(infinigen_angle_alignment({{0, 0}, {0, 1}, 0.5, 0.5}, b) == doctest::Approx(0.5));
  // The nearest point of b is 2 m ahead; b's diagonal is sqrt(1 + 4).
  CHECK(infinigen_accessibility(a, std::vector{b}) == doctest::Approx(2.0 / 4 * std::sqrt(5.0)));
  CHECK(infinigen_accessibility({{0, 0}, {-1, 0}, 0.5, 0.5}, std::vector{b}) == 0);
  Scene scene = room(4, 5);
  add(scene, "a", {2, 1, 1}, {2, 2, 0});
  CHECK(infinigen_freespace_2d(scene) == doctest::Approx(90));
}

TEST_CASE("the table of published measures names every source and what was asked and placed") {
  Scene scene = room(4, 4);
  add(scene, "a", {1, 1, 1}, {2, 2, 0});
  add(scene, "lost", {1, 1, 1}, {2, 2, 0});
  scene.objects[1].position.reset();
  const PublishedMetrics p = published_metrics(scene, 1);
  CHECK(p.asked == 2);
  CHECK(p.placed == 1);
  for (const auto& source : {"SceneEval", "PhyScene", "LayoutGPT", "ReSpace", "DiffuScene", "Infinigen"})
    CHECK(std::ranges::any_of(p.measures, [&](const auto& m) { return m.source == source; }));
  CHECK_FALSE(p.left_out.empty());
}
