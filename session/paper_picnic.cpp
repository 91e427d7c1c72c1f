#include <array>
#include <cmath>
#include <string>

#include "core/rng.h"
#include "session/paper_scenes.h"
#include "session/scene_builder.h"

/// Thesis A.2 and A.6. The thesis prints the constraints, not the sizes: these are of ordinary park furniture.
namespace inhabit::session {
namespace {

constexpr Vec3 kRoundTable{1.1, 1.1, 0.75}, kLongTable{1.8, 0.8, 0.75}, kChair{0.45, 0.45, 0.85};
constexpr Vec3 kTrashCan{0.5, 0.5, 0.9}, kGrill{1.2, 0.6, 1.1};

/// A.2 and A.6: the grills are linked together, the cans stand in pairs, and each pair has its place.
void add_grills(Scene& scene, int count, double distance, double clearance, std::vector<Ref>& grills) {
  for (int i = 1; i <= count; ++i)
    grills.push_back(
        add_object(scene, numbered("grill", static_cast<std::size_t>(i)), "grill", kGrill, {.front = clearance}));
  for (std::size_t i = 1; i < grills.size(); ++i) keep_distance(scene, grills[i - 1], grills[i], distance);
}

void add_trash_pairs(Scene& scene, std::span<const Vec2> places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Ref a = add_object(scene, numbered("trash-can", 2 * i + 1), "trash can", kTrashCan);
    const Ref b = add_object(scene, numbered("trash-can", 2 * i + 2), "trash can", kTrashCan);
    keep_distance(scene, a, b, 0.6);
    centre_at(scene, {a, b}, places[i]);
  }
}

/// Where table k of the picnic belongs: three rows of five without the place under the carousel.
std::vector<Vec2> table_places() {
  std::vector<Vec2> places;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 5; ++column)
      if (row < 2 || column != 2) places.push_back({4 + 4.5 * column, 3.5 + 4 * row});
  return places;
}

/// A table at its place with four chairs that look at it. 1 m from centre to centre keeps a chair clear of the table's
/// corners at any angle; neighbours on a square round it are sqrt(2) times as far apart.
void add_chairs(Scene& scene, Ref table, std::size_t number) {
  std::vector<Ref> chairs;
  for (std::size_t k = 0; k < 4; ++k)
    chairs.push_back(add_object(scene, numbered("chair", 4 * number + k + 1), "chair", kChair));
  gather_round(scene, table, chairs, 1.05);
  for (std::size_t k = 0; k < 4; ++k) keep_distance(scene, chairs[k], chairs[(k + 1) % 4], 1.05 * std::sqrt(2.0));
  look_at(scene, chairs, table);
}

}  // namespace

/// A lawn of 26 m by 20 m: 4.5 m by 4 m for a table with its chairs and the way round it, and a carousel of 5 m.
Scene picnic() {
  Scene scene;
  scene.name = "picnic";
  scene.space = rectangular_space(26, 20, 6);
  const std::vector<Vec2> places = table_places();
  std::vector<Ref> tables;
  for (std::size_t i = 0; i < places.size(); ++i)
    tables.push_back(add_object(scene, numbered("table", i + 1), "table", kRoundTable));
  // The two tables without chairs are the ones beside the carousel.
  for (std::size_t i = 0, chairs = 0; i < tables.size(); ++i) {
    centre_at(scene, {tables[i]}, places[i]);
    if (i != 11 && i != 12) add_chairs(scene, tables[i], chairs++);
  }
  // Neighbouring tables stay apart by their chairs and a way between them.
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (std::size_t j = i + 1; j < tables.size(); ++j)
      if (length(places[i] - places[j]) < 4.6) keep_apart(scene, tables[i], tables[j], 3.2);
  const std::array cans = {Vec2{6.25, 5.5}, Vec2{19.75, 5.5}, Vec2{6.25, 9.5}, Vec2{19.75, 9.5}};
  add_trash_pairs(scene, cans);
  std::vector<Ref> grills;
  add_grills(scene, 6, 1.5, 0.8, grills);
  centre_at(scene, grills, {5, 16.5});
  const Ref carousel = add_object(scene, "carousel", "carousel", {5, 5, 4}, {0.8, 0.8, 0.8, 0.8});
  centre_at(scene, {carousel}, {13, 16.6});
  return scene;
}

namespace {

struct PicnicCounts {
  int round = 0, rectangular = 0, trash_pairs = 0, grills = 0;
  int objects() const { return 5 * round + rectangular + 2 * trash_pairs + grills + 1; }
};

/// Thesis 6.2.2.2: the number of each kind is drawn at random.
PicnicCounts draw_counts(std::uint64_t seed) {
  Rng rng(seed, 53);
  PicnicCounts c;
  c.round = 6 + static_cast<int>(rng.index(3));
  c.rectangular = 3 + static_cast<int>(rng.index(4));
  c.trash_pairs = 3 + static_cast<int>(rng.index(3));
  c.grills = 4 + static_cast<int>(rng.index(4));
  return c;
}

/// A round table of 1.2 m with four chairs rigidly round it: the shape stands in the members' positions; the group has
/// none, so that the whole starts anywhere.
void add_round_set(Scene& scene, int number) {
  const auto place = [](Object& object, Vec2 p, double angle) {
    object.position = Vec3{p.x, p.y, 0};
    object.angle = angle;
  };
  Group set;
  set.id = numbered("set", static_cast<std::size_t>(number + 1));
  set.rigid = true;
  set.members.push_back(
      add_object(scene, numbered("table", static_cast<std::size_t>(number + 1)), "table", {1.2, 1.2, 0.75}));
  place(scene.objects.back(), {0, 0}, 0);
  const double reach = 0.6 + kChair.y / 2 + 0.01;
  for (int k = 0; k < 4; ++k) {
    const std::size_t id = static_cast<std::size_t>(4 * number + k + 1);
    set.members.push_back(add_object(scene, numbered("chair", id), "chair", kChair));
    const std::array<Vec2, 4> sides = {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    place(scene.objects.back(), reach * sides[static_cast<std::size_t>(k)], wrap_angle(kPi / 2 * k + kPi));
  }
  add_group(scene, std::move(set));
}

}  // namespace

Scene tight_picnic(std::uint64_t seed) {
  const PicnicCounts counts = draw_counts(seed);
  Scene scene;
  scene.name = "tight-picnic";
  scene.seed = seed;
  scene.space = rectangular_space(10, 10, 6);
  for (int i = 0; i < counts.round; ++i) add_round_set(scene, i);
  for (int i = 1; i <= counts.rectangular; ++i)
    add_object(scene, numbered("long-table", static_cast<std::size_t>(i)), "table", kLongTable);
  const Ref carousel = add_object(scene, "carousel", "carousel", {4, 4, 4});

  // The objects cover 52 % of the lawn; with the corners that chairs leave between them, sets and all take 70 % of it.
  double used = 2 * counts.trash_pairs * kTrashCan.x * kTrashCan.y + counts.grills * kGrill.x * kGrill.y;
  for (const Object& o : scene.objects) used += o.size.x * o.size.y;
  const double depth = std::floor(100 * std::sqrt(used / 0.52 / 1.3)) / 100, width = std::floor(130 * depth) / 100;
  scene.space = rectangular_space(width, depth, 6);

  std::vector<Ref> grills;
  add_grills(scene, counts.grills, 1.5, 0, grills);
  const std::array places = {Vec2{0.25, 0.2}, Vec2{0.75, 0.2}, Vec2{0.2, 0.55}, Vec2{0.8, 0.55}, Vec2{0.5, 0.3}};
  std::vector<Vec2> cans;
  for (int i = 0; i < counts.trash_pairs; ++i) {
    const Vec2 p = places[static_cast<std::size_t>(i)];
    cans.push_back({p.x * width, p.y * depth});
  }
  add_trash_pairs(scene, cans);
  centre_at(scene, {carousel}, {width / 2, depth - 2.05});
  return scene;
}

}  // namespace inhabit::session
