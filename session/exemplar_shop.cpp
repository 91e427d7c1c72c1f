#include <cmath>

#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The flower shop of "Make it Home": a clear way from the main door, which is elsewhere in every room, to the back
/// door.
namespace inhabit::session {
namespace {

struct Shop {
  double width, depth;
  double main, back;  ///< middles of the two doors
  bool mirror;
};

/// How near x comes to the straight way between the doors at height y.
double off_way(const Shop& v, Vec2 p) { return std::abs(p.x - (v.main + (v.back - v.main) * p.y / v.depth)); }

void racks(RoomPlan& plan, const Shop& v) {
  for (const std::size_t side : {std::size_t{1}, std::size_t{3}})
    for (const double y : {1.5, 2.85, 4.2}) {
      const Ref rack = plan.wall(side, side == 1 ? y : v.depth - y, "flower shelf", {1.25, 0.42, 0.9});
      for (int i = 0; i < 4; ++i) plan.on(rack, {0.3 * (i - 1.5), 0}, 0, "flower pot", {0.22, 0.22, 0.35});
    }
}

/// The two columns of places that are nearest to the way without standing in it.
void tables(RoomPlan& plan, const Shop& v) {
  int left = 4;
  for (double x = 1.7; x < v.width - 1.6 && left > 0; x += 0.05) {
    const Vec2 low{x, 2.0}, high{x, 4.1};
    if (std::min(off_way(v, low), off_way(v, high)) < 1.25) continue;
    for (const Vec2 p : {low, high}) {
      const Ref table = plan.stand(p, 90, "display table", {1.1, 0.7, 0.75});
      for (const double i : {-0.36, 0.0, 0.36}) plan.on(table, {i, 0}, 0, "vase", {0.2, 0.2, 0.4});
    }
    left -= 2, x += 1.75;
  }
}

/// Plants and buckets along the front and the back, where no door is.
void plants(RoomPlan& plan, const Shop& v, double till) {
  int count = 0;
  for (const std::size_t wall : {std::size_t{0}, std::size_t{2}})
    for (double x = 0.4; x < v.width - 0.3 && count < 12; x += 0.62) {
      const bool door = std::abs(x - (wall == 0 ? v.main : v.back)) < 1.15;
      if (door || (wall == 2 && (std::abs(x - till) < 1.5 || x < 1.15 || x > v.width - 1.15))) continue;
      const bool bucket = count == 3 || count == 7;
      plan.wall(wall, wall == 0 ? x : v.width - x, bucket ? "bucket" : "plant",
                bucket ? Vec3{0.35, 0.35, 0.4} : Vec3{0.42, 0.42, 0.9}, 0.05);
      ++count;
    }
}

}  // namespace

Scene plan_flower_shop(int k) {
  static constexpr Shop kRooms[] = {{8.6, 6.6, 4.3, 4.3, false}, {9.0, 6.8, 2.6, 2.8, false},
                                    {8.8, 6.6, 5.9, 5.6, false}, {9.2, 6.8, 4.8, 3.6, true},
                                    {8.6, 7.0, 3.0, 4.2, false}, {9.0, 6.8, 4.5, 4.5, false},
                                    {9.0, 6.8, 2.4, 4.5, false}, {9.0, 6.8, 6.4, 4.5, false}};
  const Shop& v = kRooms[k - 1];
  RoomPlan plan("flower shop", rectangle(v.width, v.depth), 3, 500 + static_cast<std::uint64_t>(k));
  plan.door("main door", 0, v.main - 0.6, 1.2);
  plan.door("back door", 2, v.width - v.back - 0.45, 0.9);
  plan.window(0, v.main > v.width / 2 ? 0.8 : v.width - 2.8, 2.0, 0.6, 1.8);
  racks(plan, v);
  tables(plan, v);
  const bool till_right = v.back < v.width / 2 + 0.2;
  const double till = till_right ? v.width - 1.7 : 1.7;
  const Ref counter = plan.stand({till, v.depth - 1.15}, -90, "counter", {1.6, 0.6, 0.95});
  plan.on(counter, {0.4, 0}, 180, "cash register", {0.35, 0.35, 0.25});
  plan.near(counter, {0, -0.65}, 0, "stool", {0.4, 0.4, 0.6});
  plan.wall(2, till_right ? v.width - 0.5 : 0.5, "flower fridge", {0.75, 0.6, 1.9}, 0.05);
  plants(plan, v, till);
  plan.hang(2, v.width - till, "sign", {1.4, 0.05, 0.4}, 2.2);
  plan.hang(3, v.depth - 0.6, "clock", {0.35, 0.06, 0.35}, 2.1);
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
