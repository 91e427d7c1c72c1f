#include "layout/house_rules.h"

#include <doctest/doctest.h>

#include <string>

using namespace inhabit;
using namespace inhabit::layout;

namespace {

std::size_t add(Scene& scene, const std::string& kind, Vec3 size, bool fixed = false) {
  Object o;
  o.kind = kind;
  o.id = kind + "-" + std::to_string(scene.objects.size());
  o.size = size;
  o.fixed = fixed;
  scene.objects.push_back(o);
  return scene.objects.size() - 1;
}

template <class T>
bool names(const std::vector<T>& constraints, std::size_t i) {
  for (const T& c : constraints) {
    for (const Ref m : c.members.list) {
      if (m == Ref{Ref::Kind::object, static_cast<std::uint32_t>(i)}) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("a bed stands with its back to a wall and a bedside table next to it") {
  Scene scene;
  const auto bed = add(scene, "Bed_27", {1.4, 2, 0.5}), table = add(scene, "bedside table", {0.4, 0.4, 0.5});
  add_house_rules(scene);
  CHECK(names(scene.constraints.of<WallDistance>(), bed));
  CHECK(names(scene.constraints.of<WallOrientation>(), bed));
  CHECK_FALSE(names(scene.constraints.of<WallDistance>(), table));
  REQUIRE(scene.constraints.of<FocalDistance>().size() == 1);
  const FocalDistance& at = scene.constraints.of<FocalDistance>()[0];
  CHECK(at.focal.index == bed);
  // Beside the pillow, touching: 0.7 + 0.2 across and 0.8 along is near enough.
  CHECK(*at.max >= std::hypot(0.9, 0.8));
  CHECK(scene.objects[bed].clearance.front > 0);
}

TEST_CASE("chairs share the tables and stand at their edges looking at them") {
  Scene scene;
  const auto a = add(scene, "Dining_Table_16_2", {1.8, 0.9, 0.75}), b = add(scene, "desk", {1.2, 0.6, 0.75});
  for (int i = 0; i < 4; ++i) add(scene, "chair", {0.45, 0.5, 0.9});
  const auto office = add(scene, "RoboTHOR_office_chair_jules", {0.5, 0.5, 0.9});
  add_house_rules(scene);
  std::size_t at_a = 0, at_b = 0;
  for (const FocalDistance& at : scene.constraints.of<FocalDistance>()) {
    at_a += at.focal.index == a;
    at_b += at.focal.index == b;
    CHECK(at.focal_fixed);
    if (at.focal.index == a) CHECK(*at.min == doctest::Approx(0.45 + 0.25));
    if (at.focal.index == a) CHECK(*at.max == doctest::Approx(0.9 + 0.25 + 0.05));
  }
  CHECK(at_a == 4);
  CHECK(at_b == 1);
  CHECK(names(scene.constraints.of<Orientation>(), office));
}

TEST_CASE("the sofa looks at the television which stands on its unit") {
  Scene scene;
  const auto sofa = add(scene, "Sofa_3", {2, 0.9, 0.8});
  const auto unit = add(scene, "TVStand", {1.2, 0.4, 0.5}), tv = add(scene, "Television", {1, 0.1, 0.6});
  scene.objects[tv].on = {Ref::Kind::object, static_cast<std::uint32_t>(unit)};
  add_house_rules(scene);
  REQUIRE(scene.constraints.of<Orientation>().size() == 1);
  CHECK(scene.constraints.of<Orientation>()[0].to.index == tv);
  CHECK(names(scene.constraints.of<Orientation>(), sofa));
  REQUIRE(scene.constraints.of<Stacking>().size() == 1);
  CHECK(scene.constraints.of<Stacking>()[0].anywhere);
  CHECK_FALSE(names(scene.constraints.of<WallDistance>(), tv));
}

TEST_CASE("what is fixed or in a rigid group gets no rules but others gather round it") {
  Scene scene;
  const auto table = add(scene, "table", {1, 1, 0.75}, true), chair = add(scene, "chair", {0.4, 0.4, 0.9});
  const auto wardrobe = add(scene, "wardrobe", {1, 0.6, 2}), bed = add(scene, "bed", {0.9, 2, 0.5}, true);
  Group group;
  group.rigid = true;
  group.members = {{Ref::Kind::object, static_cast<std::uint32_t>(wardrobe)}};
  scene.groups.push_back(group);
  add_house_rules(scene);
  CHECK(scene.constraints.of<WallDistance>().empty());
  REQUIRE(scene.constraints.of<FocalDistance>().size() == 1);
  CHECK(scene.constraints.of<FocalDistance>()[0].focal.index == table);
  CHECK(scene.constraints.of<FocalDistance>()[0].members.list[0].index == chair);
  CHECK_FALSE(scene.objects[bed].clearance.any());
}

TEST_CASE("rugs collide with nothing") {
  Scene scene;
  add(scene, "Carpet", {2, 3, 0.01});
  add(scene, "sofa", {2, 0.9, 0.8});
  add(scene, "armchair", {0.9, 0.9, 0.8});
  add_house_rules(scene);
  CHECK(scene.objects[0].size.z == 0.001);
  CHECK(scene.objects[1].size.z == 0.8);
}

TEST_CASE("a scene with constraints of its own is left alone and rules are added once") {
  Scene scene;
  add(scene, "bed", {0.9, 2, 0.5});
  scene.constraints.add(VisualBalance{});
  add_house_rules(scene);
  CHECK(scene.constraints.size() == 1);
  Scene other;
  add(other, "bed", {0.9, 2, 0.5});
  add_house_rules(other);
  const std::size_t once = other.constraints.size();
  add_house_rules(other);
  CHECK(other.constraints.size() == once);
}
