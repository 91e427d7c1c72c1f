#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The restaurant of "Make it Home": five tables laid for four, a counter at the back.
namespace inhabit::session {
namespace {

struct Restaurant {
  double width, depth;
  int empty;  ///< which of the six places has no table
  double door;
  bool mirror;
};

void lay_table(RoomPlan& plan, Vec2 p, double heading) {
  const Ref table = plan.stand(p, heading, "table", {0.9, 0.9, 0.75});
  plan.round(table, 4, 0.74, "chair", {0.45, 0.45, 0.9});
  for (int k = 0; k < 4; ++k) {
    const Vec2 way = direction(radians(90.0 * k));
    // The dish's front is towards the one who eats.
    plan.on(table, {-0.29 * way.y, 0.29 * way.x}, 90.0 * k, "dish set", {0.26, 0.2, 0.06});
  }
}

}  // namespace

Scene plan_restaurant(int k) {
  static constexpr Restaurant kRooms[] = {{8.6, 7.4, 4, 3.6, false}, {8.9, 7.6, 1, 3.7, true},
                                          {8.6, 7.8, 5, 6.2, false}, {9.2, 7.4, 3, 0.9, false},
                                          {8.8, 7.5, 0, 0.9, true},  {9.0, 7.6, 2, 6.6, false}};
  const Restaurant& v = kRooms[k - 1];
  RoomPlan plan("restaurant", rectangle(v.width, v.depth), 3, 200 + static_cast<std::uint64_t>(k));
  plan.door("door", 0, v.door, 1.0);
  plan.window(3, 2.0, 2.4, 0.8, 1.6);
  for (int place = 0; place < 6; ++place) {
    if (place == v.empty) continue;
    const double x = v.width * (0.2 + 0.3 * (place % 3)), y = place < 3 ? 2.35 : 2.35 + (v.depth - 4.6);
    lay_table(plan, {x, y}, 90 * (place % 2));
  }
  plan.wall(2, v.width / 2, "counter", {2.2, 0.6, 1.1});
  plan.wall(2, v.width / 2 + 1.9, "cupboard", {1.1, 0.42, 1.9});
  plan.wall(2, 0.35, "plant", {0.45, 0.45, 1.3}, 0.06);
  plan.wall(2, v.width - 0.35, "plant", {0.45, 0.45, 1.3}, 0.06);
  plan.wall(0, v.door < v.width / 2 ? v.width - 0.35 : 0.35, "plant", {0.45, 0.45, 1.3}, 0.06);
  plan.hang(1, 2.4, "painting", {1.2, 0.04, 0.7}, 1.4);
  plan.hang(1, 4.8, "painting", {1.2, 0.04, 0.7}, 1.4);
  plan.hang(3, v.depth - 1.3, "painting", {0.9, 0.04, 0.6}, 1.4);
  plan.hang(2, v.width / 2 - 1.7, "clock", {0.4, 0.06, 0.4}, 2.1);
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
