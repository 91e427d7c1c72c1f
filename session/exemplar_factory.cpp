#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The factory of "Make it Home": work desks in rows before the supervisor, who looks at them.
namespace inhabit::session {
namespace {

struct Factory {
  int columns;
  double across, down;  ///< from desk to desk
  bool mirror;
};

void work_places(RoomPlan& plan, const Factory& v) {
  for (int i = 0; i < 16; ++i) {
    const Vec2 p{1.7 + v.across * (i % v.columns), 2.1 + v.down * (i / v.columns)};
    const Ref desk = plan.stand(p, -90, "work desk", {1.3, 0.7, 0.75});
    plan.near(desk, {0, 0.68}, 180, "work chair", {0.5, 0.5, 0.95});
    if (i % 4 == 1) plan.on(desk, {0.2, 0}, 0, "sewing machine", {0.45, 0.25, 0.35});
  }
}

void supervise(RoomPlan& plan, double width, double depth) {
  const Ref desk = plan.stand({width - 2.0, depth / 2}, 0, "supervisor desk", {1.7, 0.8, 0.76});
  plan.near(desk, {0, 0.8}, 180, "supervisor chair", {0.65, 0.65, 1.1});
  plan.on(desk, {0.35, -0.1}, 0, "computer", {0.55, 0.2, 0.45});
  for (const double side : {0.0, 0.52, 1.04}) plan.wall(1, depth / 2 + 1.6 + side, "filing cabinet", {0.48, 0.6, 1.3});
  plan.wall(1, depth / 2 - 1.7, "plant", {0.5, 0.5, 1.3}, 0.06);
  plan.hang(1, depth / 2, "white board", {1.8, 0.05, 1.1}, 1.0);
}

}  // namespace

Scene plan_factory(int k) {
  static constexpr Factory kRooms[] = {{4, 2.3, 2.1, false}, {4, 2.5, 2.2, true}, {8, 2.1, 2.6, false},
                                       {4, 2.4, 2.3, false}, {8, 2.2, 2.4, true}, {4, 2.4, 2.2, false}};
  const Factory& v = kRooms[k - 1];
  const int rows = 16 / v.columns;
  const double width = 1.7 + v.across * (v.columns - 1) + 4.6, depth = std::max(2.1 + v.down * (rows - 1) + 1.7, 7.6);
  RoomPlan plan("factory", rectangle(width, depth), 3.5, 400 + static_cast<std::uint64_t>(k));
  plan.door("door", 0, width - 3.2, 1.2);
  plan.door("yard door", 2, 0.8, 1.2);
  plan.window(3, 1.5, 3.0, 1.2, 1.5);
  work_places(plan, v);
  supervise(plan, width, depth);
  plan.wall(2, width - 1.2, "box", {0.6, 0.5, 0.5}, 0.05);
  plan.wall(2, width - 1.9, "box", {0.6, 0.5, 0.5}, 0.05);
  plan.wall(0, width - 0.6, "trash can", {0.4, 0.4, 0.6}, 0.05);
  plan.hang(2, width / 2, "clock", {0.5, 0.06, 0.5}, 2.4);
  plan.hang(2, width / 2 + 1.8, "poster", {0.7, 0.02, 1.0}, 1.3);
  plan.hang(2, width / 2 - 1.8, "poster", {0.7, 0.02, 1.0}, 1.3);
  plan.hang(0, width - 4.0, "fire extinguisher", {0.18, 0.18, 0.5}, 1.0);
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
