#include "session/house_rules.h"

#include <doctest/doctest.h>

#include "session/paper_scenes.h"
#include "session/scene_builder.h"

using namespace inhabit::session;

TEST_CASE("house rules put beds at walls and chairs at tables") {
  Scene scene;
  scene.space = rectangular_space(5, 4);
  add_object(scene, "a", "bed", {1.4, 2, 0.5});
  add_object(scene, "b", "chair", {0.45, 0.45, 0.9});
  add_object(scene, "c", "dining table", {1.4, 0.8, 0.75});
  const Scene ruled = with_house_rules(scene);
  REQUIRE(ruled.constraints.of<WallDistance>().size() == 1);
  CHECK(ruled.constraints.of<WallDistance>()[0].members.list == std::vector<Ref>{{Ref::Kind::object, 0}});
  REQUIRE(ruled.constraints.of<Distance>().size() == 1);
  CHECK(ruled.constraints.of<Distance>()[0].between[1] == Ref{Ref::Kind::object, 2});
  CHECK(ruled.objects[0].clearance.front > 0);
}

TEST_CASE("house rules leave a scene that has constraints alone") {
  const Scene scene = living_room();
  CHECK(with_house_rules(scene).constraints.size() == scene.constraints.size());
}
