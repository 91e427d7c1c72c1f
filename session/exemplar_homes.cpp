#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The living room and the bedroom of "Make it Home".
namespace inhabit::session {
namespace {

/// What differs from room to room.
struct Living {
  double width, depth, away;  ///< of the sofa's centre from the television's
  double turn;                ///< of the armchairs, towards the television
  bool mirror;
};

void seat_living_room(RoomPlan& plan, Ref tv, const Living& v) {
  const Ref sofa = plan.near(tv, {0, v.away}, 180, "sofa", {2.1, 0.9, 0.85});
  const Ref table = plan.near(sofa, {0, 1.1}, 0, "coffee table", {1.1, 0.6, 0.45});
  plan.near(table, {-1.55, 0.1}, -90 + v.turn, "armchair", {0.85, 0.85, 0.9});
  plan.near(table, {1.55, 0.1}, 90 - v.turn, "armchair", {0.85, 0.85, 0.9});
  const Ref left = plan.near(sofa, {-1.45, -0.15}, 0, "side table", {0.45, 0.45, 0.55});
  plan.near(sofa, {1.45, -0.15}, 0, "side table", {0.45, 0.45, 0.55});
  plan.on(left, {0, 0}, 0, "table lamp", {0.25, 0.25, 0.45});
  plan.on(table, {0.2, 0}, 0, "vase", {0.15, 0.15, 0.3});
  plan.near(table, {0, 0.05}, 0, "rug", {2.3, 1.5, 0.001});
  plan.near(table, {-0.6, 0.9}, -150, "ottoman", {0.5, 0.5, 0.42});
}

struct Bedroom {
  double width, depth;
  double bed;   ///< along the back wall
  double desk;  ///< along the right wall
  double away;  ///< of the armchair from the television
  bool mirror;
};

void furnish_bed(RoomPlan& plan, double along) {
  const Ref bed = plan.wall(2, along, "bed", {1.6, 2.05, 0.5});
  for (const double side : {-1.0, 1.0}) {
    const Ref stand = plan.wall(2, along + side * 1.08, "bedside table", {0.45, 0.4, 0.5});
    plan.on(stand, {0, 0}, 0, "desk lamp", {0.22, 0.22, 0.4});
  }
  plan.near(bed, {0, 0.55}, 0, "rug", {2.3, 1.6, 0.001});
  plan.hang(2, along, "painting", {1.1, 0.04, 0.6}, 1.4);
}

void furnish_desk(RoomPlan& plan, double along) {
  const Ref desk = plan.wall(1, along, "desk", {1.3, 0.65, 0.75});
  plan.near(desk, {0.05, 0.68}, 180, "work chair", {0.55, 0.55, 0.95});
  plan.on(desk, {0, -0.1}, 0, "computer", {0.55, 0.2, 0.45});
  plan.on(desk, {-0.45, 0.05}, 15, "book", {0.2, 0.28, 0.05});
  plan.wall(1, along - 0.9, "trash can", {0.28, 0.28, 0.35});
}

}  // namespace

Scene plan_living_room(int k) {
  static constexpr Living kRooms[] = {{5.6, 5.0, 2.9, 12, false}, {6.0, 5.2, 3.0, 20, true},
                                      {5.4, 4.9, 2.8, 6, false},  {6.2, 5.4, 3.1, 15, true},
                                      {5.8, 5.1, 2.9, 10, false}, {6.4, 4.9, 2.9, 12, false}};
  const Living& v = kRooms[k - 1];
  RoomPlan plan("living room", rectangle(v.width, v.depth), 2.6, static_cast<std::uint64_t>(k));
  plan.door("door", 0, 0.25, 0.9);
  plan.window(1, 2.0, 1.8);
  plan.window(3, 1.4, 1.6);
  const double middle = v.width / 2;
  const Ref stand = plan.wall(2, middle, "tv stand", {1.5, 0.42, 0.5});
  const Ref tv = plan.on(stand, {0, 0}, 0, "tv", {1.15, 0.1, 0.68});
  plan.view(tv, 1.6, 30);
  seat_living_room(plan, tv, v);
  plan.wall(0, v.width - 0.75, "bookcase", {0.9, 0.32, 1.9});
  plan.wall(0, v.width - 1.7, "bookcase", {0.9, 0.32, 1.9});
  plan.wall(2, 0.4, "plant", {0.45, 0.45, 1.2}, 0.06);
  plan.wall(2, v.width - 0.4, "plant", {0.45, 0.45, 1.2}, 0.06);
  plan.wall(1, 0.8, "floor lamp", {0.35, 0.35, 1.6}, 0.08);
  plan.hang(2, middle - 1.6, "painting", {0.8, 0.04, 0.6}, 1.4);
  plan.hang(2, middle + 1.6, "painting", {0.8, 0.04, 0.6}, 1.4);
  plan.hang(3, v.depth - 1.4, "clock", {0.35, 0.06, 0.35}, 1.8);
  return plan.done(v.mirror);
}

Scene plan_bedroom(int k) {
  static constexpr Bedroom kRooms[] = {{5.8, 4.8, 2.75, 2.6, 1.9, false}, {6.2, 5.0, 2.9, 2.9, 2.0, true},
                                       {5.6, 4.6, 2.7, 2.5, 1.8, false},  {6.0, 5.2, 2.85, 2.7, 2.1, true},
                                       {5.9, 4.9, 2.75, 2.8, 1.9, false}, {6.4, 4.7, 2.9, 2.6, 1.9, false}};
  const Bedroom& v = kRooms[k - 1];
  RoomPlan plan("bedroom", rectangle(v.width, v.depth), 2.6, 100 + static_cast<std::uint64_t>(k));
  plan.door("door", 0, v.width - 1.2, 0.9, Door::Hinge::end);
  plan.window(1, v.desk - 0.7, 1.4);
  furnish_bed(plan, v.bed);
  furnish_desk(plan, v.desk);
  // Wardrobes along the left wall, which runs from the back to the front.
  plan.wall(3, 1.1, "wardrobe", {1.0, 0.6, 2.1});
  plan.wall(3, 2.17, "wardrobe", {1.0, 0.6, 2.1});
  const Ref stand = plan.wall(0, 1.75, "tv stand", {1.2, 0.4, 0.5});
  const Ref tv = plan.on(stand, {0, 0}, 0, "tv", {1.0, 0.1, 0.6});
  plan.view(tv, 1.1, 30);
  plan.near(tv, {0.25, v.away}, 172, "armchair", {0.8, 0.8, 0.9});
  const Ref dresser = plan.wall(0, 3.2, "dresser", {1.1, 0.48, 0.8});
  plan.hang(0, plan.of(dresser).position->x, "mirror", {0.7, 0.04, 0.8}, 1.2);
  plan.hang(3, v.depth - 1.0, "painting", {0.7, 0.04, 0.5}, 1.5);
  plan.hang(0, 1.75, "clock", {0.3, 0.06, 0.3}, 1.9);
  plan.wall(2, v.width - 0.3, "plant", {0.4, 0.4, 1.1}, 0.06);
  plan.wall(0, 0.35, "floor lamp", {0.35, 0.35, 1.6}, 0.08);
  plan.wall(2, 0.5, "bookcase", {0.8, 0.32, 1.9});
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
