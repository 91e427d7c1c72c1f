#include <array>
#include <string>

#include "session/paper_scenes.h"
#include "session/scene_builder.h"

/// Thesis C.4: the things that were put into photographs of empty rooms, here in plain rooms of the size that such a
/// room has.
namespace inhabit::session {
namespace {

constexpr Vec3 kChair{0.45, 0.5, 0.9};

void add_door(Space& space, int wall, double from, double width = 0.9) {
  Door door;
  door.id = "door";
  door.wall = wall;
  door.from = from;
  door.width = width;
  space.doors.push_back(door);
}

Ref add_placed(Scene& scene, std::string id, std::string kind, Vec3 size, Pose pose) {
  const Ref ref = add_object(scene, std::move(id), std::move(kind), size);
  scene.objects[ref.index].position = Vec3{pose.p.x, pose.p.y, 0};
  scene.objects[ref.index].angle = pose.angle;
  return ref;
}

/// A dining table with two chairs at each long side, as furniture shops sell them: one rigid piece.
Ref add_dining_set(Scene& scene, std::size_t number) {
  Group set;
  set.id = numbered("dining", number);
  set.rigid = true;
  set.members.push_back(add_placed(scene, numbered("table", number), "table", {1.4, 0.8, 0.75}, {{0, 0}, 0}));
  for (std::size_t k = 0; k < 4; ++k) {
    const double side = k < 2 ? 1 : -1, along = k % 2 ? 0.35 : -0.35;
    set.members.push_back(add_placed(scene, numbered("chair", 4 * (number - 1) + k + 1), "chair", kChair,
                                     {{side * 0.68, along}, side > 0 ? kPi : 0}));
  }
  return add_group(scene, std::move(set));
}

}  // namespace

/// 8 m by 6 m. "We did not impose any strict distance constraints in this setting, except for the floor lamp to be
/// close to the wall"; the tables ask for room to sit at their long sides.
Scene hosting_room() {
  Scene scene;
  scene.name = "hosting-room";
  scene.space = rectangular_space(8, 6, 2.8);
  add_door(scene.space, 0, 0.6);
  scene.space.windows.push_back({"window", 2, 3, 2, 0.9, 1.4, {}});
  for (std::size_t i = 1; i <= 5; ++i)
    add_object(scene, numbered("table", i), "table", {1.4, 0.8, 0.75}, {.front = 0.6, .back = 0.6});
  add_object(scene, "clothes-rack", "clothes rack", {1.2, 0.45, 1.7}, {.front = 0.5});
  const Ref lamp = add_object(scene, "floor-lamp", "floor lamp", {0.4, 0.4, 1.7});
  stand_at_wall(scene, {lamp}, 0.05);
  turn_from_wall(scene, {lamp});
  return scene;
}

/// A yard of 8 m by 7 m: two patio tables with four chairs each, a grill away from everything, a trash can.
Scene outdoor_yard() {
  Scene scene;
  scene.name = "outdoor-yard";
  scene.space = rectangular_space(8, 7, 4);
  std::array<Ref, 2> tables;
  for (std::size_t t = 0; t < 2; ++t) {
    tables[t] = add_object(scene, numbered("table", t + 1), "table", {1.0, 1.0, 0.75});
    std::vector<Ref> chairs;
    for (std::size_t k = 1; k <= 4; ++k)
      chairs.push_back(add_object(scene, numbered("chair", 4 * t + k), "chair", kChair));
    gather_round(scene, tables[t], chairs, 1.0);
    for (std::size_t k = 0; k < 4; ++k) keep_distance(scene, chairs[k], chairs[(k + 1) % 4], 1.414);
    look_at(scene, chairs, tables[t]);
  }
  const Ref grill = add_object(scene, "grill", "grill", {1.2, 0.6, 1.1}, {.front = 0.8});
  const Ref can = add_object(scene, "trash-can", "trash can", {0.5, 0.5, 0.9});
  for (const Ref other : {tables[0], tables[1]}) keep_apart(scene, grill, other, 3.0);
  keep_apart(scene, grill, can, 2.0);
  return scene;
}

/// 10 m by 7 m: table tennis wants space. The dining tables come with their chairs, as C.3.3 describes.
Scene game_room() {
  Scene scene;
  scene.name = "game-room";
  scene.space = rectangular_space(10, 7, 2.8);
  add_door(scene.space, 0, 4.5, 1.2);
  scene.space.windows.push_back({"window", 2, 3.5, 3, 0.9, 1.4, {}});
  const Ref sofa = add_object(scene, "sofa", "sofa", {2.0, 0.9, 0.85}, {.front = 0.5});
  const Ref lamp = add_object(scene, "floor-lamp", "floor lamp", {0.4, 0.4, 1.7});
  // The front is a short end, where a player stands.
  const Ref tennis_1 = add_object(scene, "tennis-1", "table tennis", {1.525, 2.74, 0.76}, {.front = 0.9, .back = 0.9});
  const Ref tennis_2 = add_object(scene, "tennis-2", "table tennis", {1.525, 2.74, 0.76}, {.front = 0.9, .back = 0.9});
  add_dining_set(scene, 1);
  add_dining_set(scene, 2);
  // Close, yet with 0.9 m between the tables; side by side, so that the distance is the same all along.
  keep_distance(scene, tennis_1, tennis_2, 2.4);
  run_parallel(scene, {tennis_2}, tennis_1);
  keep_distance(scene, lamp, sofa, 1.4);
  // "Slightly rotated": by 15 degrees; its back's centre then needs 0.3 m for the corner behind it.
  stand_at_wall(scene, {sofa}, 0.3);
  turn_from_wall(scene, {sofa}, radians(15));
  return scene;
}

/// 4 m by 3.4 m. C.4 lists six things; a night stand beside the bed is ours.
Scene bedroom() {
  Scene scene;
  scene.name = "bedroom";
  scene.space = rectangular_space(4, 3.4);
  add_door(scene.space, 0, 0.3);
  scene.space.windows.push_back({"window", 1, 1.0, 1.4, 0.9, 1.2, {}});
  const Ref bed = add_object(scene, "bed", "bed", {1.4, 2.0, 0.5}, {.front = 0.4});
  const Ref stand = add_object(scene, "night-stand", "night stand", {0.4, 0.4, 0.5});
  const Ref closet = add_object(scene, "closet", "wardrobe", {1.2, 0.6, 2.0}, {.front = 0.6});
  const Ref rack = add_object(scene, "clothes-rack", "clothes rack", {0.8, 0.4, 1.6}, {.front = 0.3});
  const Ref table = add_object(scene, "table", "desk", {1.1, 0.6, 0.75});
  const Ref chair = add_object(scene, "chair", "chair", kChair);
  const Ref lamp = add_object(scene, "floor-lamp", "floor lamp", {0.35, 0.35, 1.6});
  stand_at_wall(scene, {bed, stand, closet}, 0.02);
  turn_from_wall(scene, {bed, stand, closet});
  keep_distance(scene, bed, stand, 1.22);
  keep_distance(scene, lamp, table, 0.8);
  gather_round(scene, table, {chair}, 0.6);
  look_at(scene, {chair}, table);
  stand_at_wall(scene, {rack, table}, 0.05);
  turn_from_wall(scene, {rack, table});
  return scene;
}

/// 6 m by 4.5 m: the television is the focal point of sofa, armchairs and coffee table.
Scene living_room_photo() {
  Scene scene;
  scene.name = "living-room-photo";
  scene.space = rectangular_space(6, 4.5);
  add_door(scene.space, 3, 3.2);
  scene.space.windows.push_back({"window", 2, 2, 2, 0.4, 1.8, {}});
  const Ref tv = add_object(scene, "tv", "tv", {1.4, 0.45, 1.1}, {.front = 0.6});
  const Ref sofa = add_object(scene, "sofa", "sofa", {2.0, 0.9, 0.85});
  const Ref chair_1 = add_object(scene, "chair-1", "armchair", {0.8, 0.8, 0.9});
  const Ref chair_2 = add_object(scene, "chair-2", "armchair", {0.8, 0.8, 0.9});
  const Ref coffee = add_object(scene, "coffee-table", "coffee table", {1.1, 0.6, 0.45});
  const Ref table = add_object(scene, "table", "desk", {1.2, 0.6, 0.75});
  const Ref office_chair = add_object(scene, "office-chair", "office chair", {0.6, 0.6, 1.0});
  const Ref plant_1 = add_object(scene, "plant-1", "plant", {0.4, 0.4, 1.2});
  const Ref plant_2 = add_object(scene, "plant-2", "plant", {0.4, 0.4, 1.2});
  gather_round(scene, tv, {sofa}, 2.8);
  gather_round(scene, tv, {chair_1, chair_2}, 2.3);
  gather_round(scene, tv, {coffee}, 1.6);
  look_at(scene, {sofa, chair_1, chair_2}, tv);
  run_parallel(scene, {coffee}, sofa);
  gather_round(scene, table, {office_chair}, 0.7);
  look_at(scene, {office_chair}, table);
  stand_at_wall(scene, {tv, table, plant_1, plant_2}, 0.05);
  turn_from_wall(scene, {tv, table, plant_1, plant_2});
  return scene;
}

}  // namespace inhabit::session
