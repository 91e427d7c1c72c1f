#include <cmath>
#include <string>

#include "session/paper_scenes.h"
#include "session/scene_builder.h"

/// Thesis A.3 and A.5.
namespace inhabit::session {

/// 6.5 m by 5 m, a usual living room with a place to work.
/// - The door is one of the paper's ten objects and looks for its place at a wall, so the space itself has none.
/// - A.3 names a book case that is not among the ten of 6.2.1.3: there is none.
/// - "Couch as focal point to table": the only table is the office desk.
Scene living_room() {
  Scene scene;
  scene.name = "living-room";
  scene.space = rectangular_space(6.5, 5);
  scene.space.windows.push_back({"window-left", 2, 0.8, 1.8, 0.9, 1.3, {}});
  scene.space.windows.push_back({"window-right", 2, 3.8, 1.8, 0.9, 1.3, {}});

  const Ref tv = add_object(scene, "tv", "tv", {1.4, 0.45, 1.1}, {.front = 0.6});
  const Ref sofa = add_object(scene, "sofa", "sofa", {2.0, 0.9, 0.85}, {.front = 0.45});
  const Ref chair_1 = add_object(scene, "chair-1", "armchair", {0.85, 0.85, 0.9}, {.front = 0.4});
  const Ref chair_2 = add_object(scene, "chair-2", "armchair", {0.85, 0.85, 0.9}, {.front = 0.4});
  const Ref desk = add_object(scene, "desk", "desk", {1.4, 0.7, 0.75});
  const Ref office_chair = add_object(scene, "office-chair", "office chair", {0.6, 0.6, 1.0});
  const Ref coat_rack = add_object(scene, "coat-rack", "coat rack", {0.5, 0.5, 1.8}, {.front = 0.5});
  const Ref door = add_object(scene, "door", "door", {0.9, 0.1, 2.1}, {.front = 0.9});
  const Ref plant_1 = add_object(scene, "plant-1", "plant", {0.45, 0.45, 1.2});
  const Ref plant_2 = add_object(scene, "plant-2", "plant", {0.45, 0.45, 1.2});

  gather_round(scene, sofa, {desk}, 2.3);
  gather_round(scene, tv, {sofa, chair_1, chair_2}, 2.5);
  gather_round(scene, desk, {office_chair}, 0.75);
  stand_at_wall(scene, {tv, coat_rack, plant_1, plant_2}, 0.05);
  stand_at_wall(scene, {door}, 0);
  turn_from_wall(scene, {tv, coat_rack, door, plant_1, plant_2});
  // Ours: the door keeps out of the wall that has the windows.
  KeepOut windows;
  windows.members = list_of({door});
  windows.polygon = {{0.5, 4.6}, {6, 4.6}, {6, 5}, {0.5, 5}};
  scene.constraints.add(std::move(windows));
  scene.constraints.add(VisualBalance{});
  look_at(scene, {sofa, chair_1, chair_2}, tv);
  look_at(scene, {office_chair}, desk);
  // Whoever sits at the desk looks towards the sofa: its front, where the chair is, points away from it.
  Orientation back_turned;
  back_turned.members = list_of({desk});
  back_turned.to = sofa;
  back_turned.angle = kPi;
  scene.constraints.add(back_turned);
  return scene;
}

namespace {

void place(Scene& scene, Ref ref, Vec2 p, double angle) {
  Object& object = scene.objects[ref.index];
  object.position = Vec3{p.x, p.y, 0};
  object.angle = angle;
}

/// A bunk whose head is its back, a locker at its foot and, for the first, a night stand at its left: one rigid piece.
Ref add_bunk(Scene& scene, std::size_t number) {
  Group group;
  group.id = numbered("bunk", number);
  group.rigid = true;
  const Ref bed = add_object(scene, numbered("bed", number), "bed", {0.9, 2.0, 0.5});
  const Ref locker = add_object(scene, numbered("footlocker", number), "footlocker", {0.8, 0.4, 0.4});
  place(scene, bed, {0, 0}, 0);
  place(scene, locker, {1.22, 0}, 0);
  group.members = {bed, locker};
  if (number == 1) {
    const Ref stand = add_object(scene, "night-stand", "night stand", {0.4, 0.4, 0.5});
    place(scene, stand, {-0.8, 0.67}, 0);
    group.members.push_back(stand);
  }
  add_group(scene, std::move(group));
  return bed;
}

}  // namespace

/// 12 objects: 3 beds, 3 lockers, a night stand ("army style accessories") and the five pieces of 6.2.2.1. They cover
/// 8.125 m2; the room keeps the proportions 3.40 : 2.87, in which a layout without overlap at 83 % is known: the bunks
/// side by side with their heads at the back wall, table, coat rack and lamp in the strip beside the night stand,
/// bookcase and chair in the strip before the door. A.5's first line, four chairs round each table, is a slip: 6.2.2.1
/// has one chair, which the next lines name. Wall orientation is ours: a back at the wall means it, and projection
/// turns nothing for a distance.
Scene tight_bedroom(double coverage) {
  Scene scene;
  scene.name = "tight-bedroom";
  std::vector<Ref> beds;
  for (std::size_t i = 1; i <= 3; ++i) beds.push_back(add_bunk(scene, i));
  const Ref bookcase = add_object(scene, "bookcase", "bookcase", {0.9, 0.35, 1.8});
  const Ref table = add_object(scene, "table", "table", {1.1, 0.65, 0.75});
  const Ref coat_rack = add_object(scene, "coat-rack", "coat rack", {0.5, 0.5, 1.8});
  const Ref lamp = add_object(scene, "floor-lamp", "floor lamp", {0.35, 0.35, 1.6});
  const Ref chair = add_object(scene, "chair", "chair", {0.45, 0.45, 0.9});

  double used = 0;
  for (const Object& o : scene.objects) used += o.size.x * o.size.y;
  const double proportion = 3.40 / 2.87, depth = std::sqrt(used / coverage / proportion);
  scene.space = rectangular_space(proportion * depth, depth);
  Door door;
  door.id = "door";
  door.width = 0.8;
  // In the middle of the front wall; it opens outward, as the doors of such rooms must.
  door.from = proportion * depth / 2 - door.width / 2;
  door.swing = Door::Swing::out;
  scene.space.doors.push_back(door);
  scene.space.windows.push_back({"window", 2, proportion * depth / 2 - 0.6, 1.2, 1.1, 1.0, {}});

  gather_round(scene, table, {chair}, 0.65);
  keep_distance(scene, lamp, table, 0.8);
  keep_distance(scene, lamp, chair, 0.8);
  keep_distance(scene, chair, table, 0.65);
  keep_distance(scene, bookcase, coat_rack, 0.9);
  look_at(scene, {chair}, table);
  std::vector<Ref> at_wall = beds;
  at_wall.insert(at_wall.end(), {bookcase, table});
  stand_at_wall(scene, at_wall, 0);
  turn_from_wall(scene, at_wall);
  return scene;
}

}  // namespace inhabit::session
