#include "layout/house_rules.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "layout/check.h"
#include "layout/furnish.h"

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

/// The places that the rules give to `i`, relative to others.
std::vector<HeatPoint> places(const Scene& scene, std::size_t i) {
  std::vector<HeatPoint> found;
  for (const HeatPoint& c : scene.constraints.of<HeatPoint>()) {
    if (names(std::vector<HeatPoint>{c}, i)) found.push_back(c);
  }
  return found;
}

/// Furnished by the rules, in a room of this size.
Scene furnished(Scene scene, double width, double depth) {
  scene.space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  add_house_rules(scene);
  Options options;
  options.threads = 1;
  return with_placement(scene, furnish(scene, options)->best.placement);
}

Vec2 seen_from(const Object& focal, const Object& o) {
  return rotate_back(o.position->xy() - focal.position->xy(), direction(*focal.angle));
}

}  // namespace

TEST_CASE("a bed stands with its back to a wall and bedside tables at both sides of its head") {
  Scene scene;
  const auto bed = add(scene, "Bed_27", {1.4, 2, 0.5});
  const auto left = add(scene, "bedside table", {0.4, 0.4, 0.5}), right = add(scene, "nightstand", {0.4, 0.4, 0.5});
  const Scene out = furnished(scene, 4, 4);
  CHECK(names(out.constraints.of<WallDistance>(), bed));
  CHECK(names(out.constraints.of<WallOrientation>(), bed));
  CHECK_FALSE(names(out.constraints.of<WallDistance>(), left));
  CHECK(out.objects[bed].clearance.front > 0);
  CHECK(check(out).feasible);
  for (const auto i : {left, right}) {
    const Vec2 at = seen_from(out.objects[bed], out.objects[i]);
    CHECK(at.x == doctest::Approx(-0.8).epsilon(0.1));
    CHECK(std::abs(at.y) == doctest::Approx(0.93).epsilon(0.1));
  }
}

TEST_CASE("chairs share the tables by their size, sit opposite each other and look at the table") {
  Scene scene;
  const auto a = add(scene, "Dining_Table_16_2", {1.8, 0.9, 0.75}), b = add(scene, "desk", {1.2, 0.6, 0.75});
  for (int i = 0; i < 4; ++i) add(scene, "chair", {0.45, 0.5, 0.9});
  const auto office = add(scene, "RoboTHOR_office_chair_jules", {0.5, 0.5, 0.9});
  const Scene out = furnished(scene, 6, 5);
  CHECK(check(out).feasible);
  for (std::size_t i = 2; i < 6; ++i) {
    const Vec2 at = seen_from(out.objects[a], out.objects[i]);
    CHECK(std::abs(at.x) == doctest::Approx(0.45 + 0.25 + 0.03).epsilon(0.05));
    CHECK(std::abs(at.y) < 0.7);
    const Vec2 look = rotate_back(direction(*out.objects[i].angle), direction(*out.objects[a].angle));
    CHECK(look.x * at.x < -0.6);
  }
  CHECK(seen_from(out.objects[b], out.objects[office]).x == doctest::Approx(0.3 + 0.25 + 0.03).epsilon(0.05));
}

TEST_CASE("one chair comes to the front of its table, whose back is at a wall") {
  Scene scene;
  const auto table = add(scene, "table", {1.2, 0.7, 0.75}), chair = add(scene, "chair", {0.45, 0.5, 0.9});
  add_house_rules(scene);
  CHECK(names(scene.constraints.of<WallDistance>(), table));
  REQUIRE(places(scene, chair).size() == 1);
  CHECK(places(scene, chair)[0].point.x > 0.35);
  CHECK_FALSE(places(scene, chair)[0].on_fixed);
}

TEST_CASE("stools come to a table whose chairs have their places already, and no two get the same") {
  Scene scene;
  const auto table = add(scene, "table", {1.2, 0.7, 0.75});
  for (int i = 0; i < 2; ++i) add(scene, "chair", {0.45, 0.5, 0.9});
  const auto stool = add(scene, "stool", {0.35, 0.35, 0.5});
  add_house_rules(scene);
  CHECK(places(scene, stool).empty());
  REQUIRE(scene.constraints.of<FocalDistance>().size() == 1);
  CHECK(scene.constraints.of<FocalDistance>()[0].focal.index == table);
  CHECK(places(scene, 1)[0].point != places(scene, 2)[0].point);
}

TEST_CASE("the sofa looks at the television which stands in the middle of its unit, armchairs before its ends") {
  Scene scene;
  const auto sofa = add(scene, "Sofa_3", {2, 0.9, 0.8});
  const auto unit = add(scene, "TVStand", {1.2, 0.4, 0.5}), tv = add(scene, "Television", {1, 0.1, 0.6});
  const auto armchair = add(scene, "armchair", {0.8, 0.8, 0.8});
  scene.objects[tv].on = {Ref::Kind::object, static_cast<std::uint32_t>(unit)};
  const Scene out = furnished(scene, 4.5, 4);
  CHECK(check(out).feasible);
  REQUIRE(out.constraints.of<Stacking>().size() == 1);
  CHECK_FALSE(out.constraints.of<Stacking>()[0].anywhere);
  CHECK_FALSE(names(out.constraints.of<WallDistance>(), tv));
  CHECK(length(out.objects[tv].position->xy() - out.objects[unit].position->xy()) < 1e-9);
  const Vec2 ahead = seen_from(out.objects[sofa], out.objects[tv]);
  CHECK(ahead.x > 1);
  CHECK(std::abs(ahead.y) < 0.2);
  REQUIRE(places(out, armchair).size() == 1);
  CHECK(places(out, armchair)[0].on.index == sofa);
}

TEST_CASE("a rug lies under the coffee table") {
  Scene scene;
  const auto rug = add(scene, "Carpet", {2, 1.5, 0.01}), table = add(scene, "coffee table", {1, 0.6, 0.4});
  add(scene, "sofa", {2, 0.9, 0.8});
  add_house_rules(scene);
  REQUIRE(places(scene, rug).size() == 1);
  CHECK(places(scene, rug)[0].on.index == table);
}

TEST_CASE("pictures and what is higher than the sill keep out from before a window") {
  Scene scene;
  scene.space.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  scene.space.windows = {{"window", 0, 1, 1.4, 0.9, 1.2, {}}};
  const auto wardrobe = add(scene, "wardrobe", {1, 0.6, 2}), chest = add(scene, "chest", {1, 0.5, 0.8});
  const auto picture = add(scene, "picture", {0.6, 0.05, 0.5}), curtain = add(scene, "curtain", {1.6, 0.1, 1.4});
  scene.objects[picture].mount = scene.objects[curtain].mount = Mount::wall;
  add_house_rules(scene);
  const auto& free = scene.constraints.of<KeepOut>();
  CHECK(names(free, wardrobe));
  CHECK(names(free, picture));
  CHECK_FALSE(names(free, chest));
  CHECK_FALSE(names(free, curtain));
}

TEST_CASE("what has nobody to go to stands with its back at a wall") {
  Scene scene;
  const auto chair = add(scene, "chair", {0.45, 0.5, 0.9}), cart = add(scene, "cart", {0.5, 0.4, 0.8});
  add_house_rules(scene);
  CHECK(names(scene.constraints.of<WallDistance>(), chair));
  CHECK(names(scene.constraints.of<WallDistance>(), cart));
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
  REQUIRE(places(scene, chair).size() == 1);
  CHECK(places(scene, chair)[0].on.index == table);
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
