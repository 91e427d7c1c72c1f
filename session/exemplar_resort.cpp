#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The resort of "Make it Home": an L-shaped hall. Walls: 0 front, 1 right, 2 and 3 the step, 4 back, 5 left.
namespace inhabit::session {
namespace {

struct Resort {
  double width, depth, arm_width, arm_depth;  ///< the whole; the arm to the back, the arm to the right
  double easels;                              ///< heading
  bool mirror;
};

void seat(RoomPlan& plan, std::size_t wall, double along) {
  const Ref couch = plan.wall(wall, along, "couch", {1.9, 0.85, 0.85}, 0.05);
  const Ref table = plan.near(couch, {0, 1.0}, 0, "tea table", {0.9, 0.5, 0.42});
  plan.on(table, {0, 0}, 0, "tea set", {0.35, 0.25, 0.15});
}

void make_music(RoomPlan& plan, const Resort& v) {
  const Ref drum = plan.stand({v.width - 1.3, v.arm_depth - 2.1}, 200, "drum", {1.3, 1.0, 1.1});
  plan.near(drum, {0, -0.85}, 0, "chair", {0.45, 0.45, 0.9});
  const Ref guitar = plan.stand({v.width - 1.9, 0.75}, 100, "guitar", {0.45, 0.4, 1.1});
  plan.near(guitar, {0, 0.75}, 180, "chair", {0.45, 0.45, 0.9});
}

void paint(RoomPlan& plan, const Resort& v) {
  for (const double x : {0.32, 0.72}) {
    const Ref easel = plan.stand({x * v.arm_width, v.depth - 1.3}, v.easels, "easel", {0.7, 0.6, 1.7});
    plan.near(easel, {0, 0.9}, 180, "stool", {0.38, 0.38, 0.5});
  }
}

}  // namespace

Scene plan_resort(int k) {
  static constexpr Resort kRooms[] = {{9.4, 8.6, 5.4, 4.8, -90, false},  {9.8, 9.0, 5.6, 4.9, -80, true},
                                      {9.2, 8.8, 5.6, 4.8, -100, false}, {10.0, 8.8, 5.8, 5.0, -95, true},
                                      {9.6, 9.2, 5.5, 4.8, -85, false},  {9.8, 8.6, 5.8, 5.0, -90, false}};
  const Resort& v = kRooms[k - 1];
  RoomPlan plan(
      "resort",
      {{0, 0}, {v.width, 0}, {v.width, v.arm_depth}, {v.arm_width, v.arm_depth}, {v.arm_width, v.depth}, {0, v.depth}},
      3, 300 + static_cast<std::uint64_t>(k));
  plan.door("front door", 0, 4.6, 1.0);
  plan.door("garden door", 3, 1.3, 0.9);
  plan.window(5, 2.6, 2.0);
  seat(plan, 5, v.depth - 1.9);
  seat(plan, 5, v.depth - 4.6);
  seat(plan, 0, 2.9);
  make_music(plan, v);
  paint(plan, v);
  plan.stand({5.0, 3.1}, 90, "pool table", {2.3, 1.25, 0.8});
  plan.wall(2, 1.9, "bookcase", {0.9, 0.32, 1.9});
  plan.wall(2, 2.86, "bookcase", {0.9, 0.32, 1.9});
  plan.wall(0, 0.45, "plant", {0.5, 0.5, 1.4}, 0.06);
  plan.wall(0, v.width - 0.45, "plant", {0.5, 0.5, 1.4}, 0.06);
  plan.wall(4, 0.45, "plant", {0.5, 0.5, 1.4}, 0.06);
  plan.wall(4, v.arm_width - 0.45, "plant", {0.5, 0.5, 1.4}, 0.06);
  plan.hang(0, 2.9, "painting", {1.2, 0.04, 0.7}, 1.4);
  plan.hang(1, v.arm_depth / 2, "painting", {1.0, 0.04, 0.7}, 1.4);
  plan.hang(4, v.arm_width / 2, "painting", {1.2, 0.04, 0.7}, 1.4);
  plan.wall(5, v.depth - 3.25, "floor lamp", {0.35, 0.35, 1.6}, 0.08);
  plan.wall(1, 1.4, "floor lamp", {0.35, 0.35, 1.6}, 0.08);
  plan.stand({0.52 * v.arm_width, v.depth - 1.75}, 90, "rug", {3.2, 2.0, 0.001});
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
