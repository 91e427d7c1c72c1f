#include <doctest/doctest.h>

#include "layout/furnish.h"

using namespace inhabit::layout;

namespace {

Scene hall() {
  Scene scene;
  scene.space.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  return scene;
}

Object& add(Scene& scene, std::string id, Vec3 size, Vec3 position) {
  Object o;
  o.id = std::move(id);
  o.size = size, o.position = position, o.angle = 0;
  scene.objects.push_back(o);
  return scene.objects.back();
}

}  // namespace

TEST_CASE("heights stay when positions are taken away, and lamps where they hang") {
  Scene scene = hall();
  add(scene, "table", {1, 0.6, 0.7}, {1, 1, 0});
  add(scene, "picture", {0.5, 0.03, 0.4}, {2, 0.02, 1.55}).mount = Mount::wall;
  add(scene, "lamp", {0.4, 0.4, 0.5}, {2, 1.5, 2.1}).mount = Mount::ceiling;
  add(scene, "mug", {0.1, 0.1, 0.1}, {1, 1, 0.7}).on = {Ref::Kind::object, 0};
  const Scene bare = without_positions(scene);
  CHECK_FALSE(bare.objects[0].position);
  CHECK_FALSE(bare.objects[0].elevation);
  CHECK_FALSE(bare.objects[1].position);
  CHECK(*bare.objects[1].elevation == 1.55);
  CHECK(bare.objects[2] == scene.objects[2]);
  CHECK_FALSE(bare.objects[3].elevation);
  const Scene out = with_placement(bare, furnish(bare, {.threads = 1})->best.placement);
  CHECK(out.objects[1].position->z == 1.55);
  CHECK(out.objects[2].position->xy() == Vec2{2, 1.5});
  CHECK(out.objects[3].position->z == doctest::Approx(0.7));
}

TEST_CASE("a cushion keeps its height on the seat of its sofa, with which it does not collide") {
  Scene scene = hall();
  add(scene, "sofa", {2, 0.9, 0.8}, {1.5, 1, 0});
  add(scene, "cushion", {0.4, 0.4, 0.2}, {1.5, 1, 0.45}).on = {Ref::Kind::object, 0};
  CHECK_FALSE(without_positions(scene).objects[1].elevation);
  Collision off;
  off.members.list = {{Ref::Kind::object, 0}, {Ref::Kind::object, 1}};
  off.mode = 2;
  scene.constraints.add(off);
  CHECK(*without_positions(scene).objects[1].elevation == 0.45);
}

TEST_CASE("a fixed thing that reaches out of the room makes no layout infeasible") {
  Scene scene = hall();
  add(scene, "stairs", {1, 1.5, 2.5}, {3.8, 1.5, 0}).fixed = true;
  add(scene, "box", {0.5, 0.5, 0.5}, {1, 1, 0});
  const auto outcome = furnish(without_positions(scene), {.threads = 1});
  CHECK(outcome->best.feasible);
  CHECK(outcome->best.iterations < 1000);
}
