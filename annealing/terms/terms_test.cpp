#include <doctest/doctest.h>

#include "annealing/term_table.h"
#include "annealing/test_room.h"

using namespace inhabit::annealing;
using namespace inhabit::annealing::testing;

namespace {

/// A scene whose objects stand where they are said to, with targets that may be edited before it is compiled.
struct World {
  Scene scene = empty_room(10, 10);
  Targets targets;
  std::optional<Furniture> furniture;
  std::optional<Arrangement> x;

  World() { scene.space.doors.clear(); }
  std::uint32_t add(Vec3 size, Vec2 p, double angle, double base = 0) {
    const auto i = static_cast<std::uint32_t>(scene.objects.size());
    Object o = thing("o" + std::to_string(i), "", size);
    o.position = Vec3{p.x, p.y, base}, o.angle = angle;
    scene.objects.push_back(o);
    targets.objects.emplace_back();
    return i;
  }
  const Arrangement& make() {
    auto compiled = compile(scene, targets, {});
    REQUIRE(compiled.ok());
    furniture.emplace(std::move(*compiled));
    x.emplace(*furniture);
    return *x;
  }
  void move(std::uint32_t i, Vec2 p, double angle) {
    x->touch(i);
    x->place(i, p, angle);
    x->settle();
  }
};
constexpr double kExact = 1e-12;

template <class T>
double sum(const Costs& costs) {
  double found = 0;
  std::size_t k = 0;
  for_each_type(Terms{}, [&]<class U>(std::type_identity<U>) {
    if (std::is_same_v<T, U>) found = costs[k];
    ++k;
  });
  return found;
}

}  // namespace

TEST_CASE("accessibility counts how near to the middle of the free space something is") {
  World w;
  const std::uint32_t desk = w.add({1, 0.6, 0.75}, {5, 5}, 0);
  const std::uint32_t box = w.add({0.4, 0.4, 0.5}, {5.8, 5}, 0);
  w.targets.objects[desk].access = {0, 0, 0.8, 0};
  w.make();
  // The space before the front: 0.8 deep, 1 wide, its centre at 5.7.
  const double b = std::sqrt(0.08), ad = std::sqrt(0.16 + 0.25);
  CHECK(std::abs(sum<AccessibilityCost>(full_cost(*w.x)) - (1 - 0.1 / (b + ad))) < kExact);
  w.move(box, {5.7, 5}, 1.1);
  CHECK(std::abs(sum<AccessibilityCost>(full_cost(*w.x)) - 1) < kExact);
  // Near, but their boxes do not meet.
  w.move(box, {6.31, 5}, 0);
  CHECK(sum<AccessibilityCost>(full_cost(*w.x)) == 0);
  // The space turns with its desk.
  w.move(desk, {5, 5}, kPi / 2);
  w.move(box, {5, 5.7}, 0);
  CHECK(std::abs(sum<AccessibilityCost>(full_cost(*w.x)) - 1) < kExact);
}

TEST_CASE("a clock above a bed is in nobody's way and a chair in it is") {
  World w;
  const std::uint32_t bed = w.add({1.6, 2, 0.5}, {5, 5}, 0);
  w.add({0.3, 0.1, 0.3}, {5, 5}, 0, 2.0);
  w.targets.objects[bed].access = {0.6, 0.6, 0.6, 0.6};
  w.make();
  CHECK(sum<Overlap>(full_cost(*w.x)) == 0);
  CHECK(sum<AccessibilityCost>(full_cost(*w.x)) == 0);
  World v;
  v.add({1.6, 2, 0.5}, {5, 5}, 0);
  v.add({0.4, 0.4, 0.9}, {5.9, 5}, 0);
  v.make();
  // 1 + 0.2 - 0.9 deep along the bed, less than across it.
  CHECK(std::abs(sum<Overlap>(full_cost(*v.x)) - (0.3 + kTouch)) < kExact);
}

TEST_CASE("a pair may stand in each other's space and a thing on a table in the table's") {
  World w;
  const std::uint32_t desk = w.add({1, 0.6, 0.75}, {5, 5}, 0), chair = w.add({0.4, 0.4, 0.9}, {5.7, 5}, 0);
  w.targets.objects[desk].access = {0, 0, 0.8, 0};
  w.targets.pairs.push_back({desk, chair, {0.7, 0, 0}});
  w.make();
  CHECK(sum<AccessibilityCost>(full_cost(*w.x)) == 0);
}

TEST_CASE("a view is three rectangles and counts what stands in them at its height") {
  World w;
  const std::uint32_t tv = w.add({1.2, 0.4, 0.6}, {2, 5}, 0, 0.5);
  const std::uint32_t plant = w.add({0.4, 0.4, 1.2}, {2.7, 5}, 0);
  w.targets.objects[tv].view = View{3, radians(60)};
  w.make();
  // The first rectangle: 1 m deep from 2.2, as wide as the cone is at its end.
  const double half = std::tan(radians(30));
  const double b = std::sqrt(0.08), vd = std::sqrt(0.25 + half * half);
  CHECK(std::abs(sum<VisibilityCost>(full_cost(*w.x)) - 1) < kExact);
  w.move(plant, {2.5, 5}, 0);
  CHECK(std::abs(sum<VisibilityCost>(full_cost(*w.x)) - (1 - 0.2 / (b + vd))) < kExact);
  World low;
  const std::uint32_t high = low.add({1.2, 0.4, 0.6}, {2, 5}, 0, 0.5);
  low.add({0.4, 0.4, 0.5}, {2.7, 5}, 0);
  low.targets.objects[high].view = View{3, radians(60)};
  low.make();
  CHECK(sum<VisibilityCost>(full_cost(*low.x)) == 0);
}

TEST_CASE("walls ask for the learned distance of the back and the learned angle") {
  World w;
  const std::uint32_t shelf = w.add({1, 0.4, 2}, {5, 0.5}, kPi / 2);
  w.targets.objects[shelf].wall = WallMode{0.1, 0, 0.01, 0.01, 5};
  w.make();
  // Its back is 0.3 from the front wall, and faces it squarely.
  CHECK(std::abs(sum<PriorDistance>(full_cost(*w.x)) - 0.2) < kExact);
  CHECK(sum<PriorAngle>(full_cost(*w.x)) < kExact);
  w.move(shelf, {5, 0.3}, kPi / 2 + 0.3);
  CHECK(std::abs(sum<PriorAngle>(full_cost(*w.x)) - 0.3) < kExact);
  w.move(shelf, {5, 0.3}, -kPi / 2 + 0.3);
  // Turned round, its back is 0.2 cos 0.3 beyond its centre.
  CHECK(std::abs(sum<PriorDistance>(full_cost(*w.x)) - (0.2 + 0.2 * std::cos(0.3))) < 1e-9);
  CHECK(std::abs(sum<PriorAngle>(full_cost(*w.x)) - (kPi - 0.3)) < kExact);
}

TEST_CASE("a kind whose left side stands to the wall is measured from there") {
  World w;
  const std::uint32_t bed = w.add({1, 2, 0.5}, {5, 0.7}, 0);
  w.targets.objects[bed].wall = WallMode{0.2, 0, 0.01, 0.01, 5};
  w.targets.objects[bed].back = Face::left;
  w.make();
  // Heading along the wall y = 0 it has the wall on its right: half a turn wrong, and its left side is 1.2 away.
  CHECK(std::abs(sum<PriorAngle>(full_cost(*w.x)) - kPi) < kExact);
  CHECK(std::abs(sum<PriorDistance>(full_cost(*w.x)) - 1.0) < kExact);
  w.move(bed, {5, 0.7}, kPi);
  CHECK(sum<PriorAngle>(full_cost(*w.x)) < kExact);
  CHECK(sum<PriorDistance>(full_cost(*w.x)) < kExact);
}

TEST_CASE("angles that the examples disagree on count less") {
  CHECK(angle_strength(0) == 1);
  CHECK(angle_strength(radians(30)) == 1);
  CHECK(std::abs(angle_strength(radians(60)) - 0.5) < kExact);
  CHECK(angle_strength(radians(120)) == 0);
}

TEST_CASE("pairs ask for distance and bearing and facing") {
  World w;
  const std::uint32_t tv = w.add({1.2, 0.4, 1}, {2, 5}, 0), sofa = w.add({2, 0.9, 0.8}, {5, 5}, kPi);
  w.targets.pairs.push_back({tv, sofa, {2.5, 0, 0}});
  w.make();
  CHECK(std::abs(sum<PairDistance>(full_cost(*w.x)) - 0.5) < kExact);
  CHECK(sum<PairAngle>(full_cost(*w.x)) < kExact);
  // It looks 0.4 past the television.
  w.move(sofa, {4.5, 5}, kPi - 0.4);
  CHECK(sum<PairDistance>(full_cost(*w.x)) < kExact);
  CHECK(std::abs(sum<PairAngle>(full_cost(*w.x)) - 0.4) < kExact);
  // It looks at the television from its side.
  w.move(sofa, {2, 7.5}, -kPi / 2);
  CHECK(std::abs(sum<PairAngle>(full_cost(*w.x)) - kPi / 2) < kExact);
  // Coincident: no direction is wrong.
  w.move(sofa, {2, 5}, 0.3);
  CHECK(sum<PairAngle>(full_cost(*w.x)) == 0);
  CHECK(std::abs(sum<PairDistance>(full_cost(*w.x)) - 2.5) < kExact);
}

TEST_CASE("chairs round a table cost nothing when they are evenly spaced whatever their order") {
  World w;
  const std::uint32_t table = w.add({1, 1, 0.75}, {5, 5}, 0);
  std::vector<std::uint32_t> chairs;
  for (const double at : {0.3, 0.3 + kPi, 0.3 + kPi / 2, 0.3 - kPi / 2})
    chairs.push_back(w.add({0.4, 0.4, 0.9}, Vec2{5, 5} + 0.9 * direction(at), wrap_angle(at + kPi)));
  for (const std::uint32_t c : chairs) w.targets.pairs.push_back({table, c, {0.9, 0, 0}, true});
  w.make();
  CHECK(sum<PairAngle>(full_cost(*w.x)) < 1e-9);
  CHECK(sum<PairDistance>(full_cost(*w.x)) < 1e-9);
  // One chair 0.2 further round: its two gaps miss by 0.2 each.
  w.move(chairs[0], Vec2{5, 5} + 0.9 * direction(0.5), wrap_angle(0.5 + kPi));
  CHECK(std::abs(sum<PairAngle>(full_cost(*w.x)) - 0.2) < 1e-9);
}

TEST_CASE("what leaves the room counts by its depth and what is fixed does not") {
  World w;
  const std::uint32_t box = w.add({1, 1, 1}, {0.4, 5}, 0);
  w.make();
  CHECK(std::abs(sum<Inside>(full_cost(*w.x)) - (0.1 + kTouch)) < kExact);
  w.move(box, {0.5, 5}, 0);
  CHECK(sum<Inside>(full_cost(*w.x)) == 0);
  World fixed;
  fixed.add({1, 1, 1}, {0.4, 5}, 0);
  fixed.scene.objects[0].fixed = true;
  fixed.make();
  CHECK(sum<Inside>(full_cost(*fixed.x)) == 0);
}

TEST_CASE("second tier stays on its carrier") {
  World w;
  const std::uint32_t table = w.add({1, 0.6, 0.75}, {5, 5}, 0), vase = w.add({0.2, 0.2, 0.3}, {5.1, 5}, 0, 0.75);
  w.targets.objects[vase].carrier = table;
  w.targets.objects[vase].carriers = {table};
  w.make();
  CHECK(sum<Inside>(full_cost(*w.x)) == 0);
  CHECK(sum<Overlap>(full_cost(*w.x)) == 0);
  w.move(vase, {5.3, 5}, 0);  // 0.3 - 0.1 is as far as it may go
  CHECK(std::abs(sum<Inside>(full_cost(*w.x)) - (0.1 + kTouch)) < kExact);
}

TEST_CASE("a pathway counts what stands in it and its walls and its detours") {
  World w;
  w.scene = empty_room(4, 6);
  w.scene.space.doors[0].from = 1.55, w.scene.space.doors[1].from = 1.55;  // both in the middle
  const std::uint32_t box = w.add({0.4, 0.4, 1}, {0.5, 3}, 0);
  w.make();
  // The way from (2, 0) to (2, 6) is straight and free.
  CHECK(sum<PathwayCost>(full_cost(*w.x)) < 1e-9);
  w.move(box, {2, 3}, 0);
  const double here = sum<PathwayCost>(full_cost(*w.x));
  CHECK(here > 1);  // in the two parts that meet there
  w.x->touch_path(0);
  w.x->set_points(0, {Vec2{3.2, 1.5}, Vec2{3.2, 4.5}});
  w.x->settle();
  const double round = sum<PathwayCost>(full_cost(*w.x));
  CHECK(round < here);
  CHECK(round > 0);  // longer than need be
  w.x->touch_path(0);
  w.x->set_points(0, {Vec2{9, 1.5}, Vec2{9, 4.5}});
  w.x->settle();
  CHECK(sum<PathwayCost>(full_cost(*w.x)) > 4);  // through the wall
}

TEST_CASE("the weights are those of the paper and of our own two terms") {
  const Weights weights;
  Costs ones;
  ones.fill(1);
  CHECK(std::abs(weighted(ones, weights) - (0.1 + 0.01 + 0.1 + 1 + 10 + 1 + 10 + 20 + 20)) < 1e-12);
}
