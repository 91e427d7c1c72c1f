#include "session/exemplar_scenes.h"
#include "session/room_plan.h"

/// The gallery of "Make it Home": a T-shaped hall with pillars. Walls: 0 front, 1 right, 2 and 3 the right step, 4
/// back, 5 and 6 the left step, 7 left.
namespace inhabit::session {
namespace {

struct Gallery {
  double width, depth, hall;  ///< the whole; the depth of the cross hall
  double left, right;         ///< the stem of the T
  bool mirror;
};

/// `count` paintings evenly over what is left of a wall after `from` and before `until`.
void paintings(RoomPlan& plan, std::size_t wall, int count, double from, double until) {
  for (int i = 0; i < count; ++i)
    plan.hang(wall, from + (until - from) * (i + 0.5) / count, "painting", {0.9, 0.04, 0.7}, 1.4);
}

/// Two chairs side by side.
void two_chairs(RoomPlan& plan, Vec2 p, double heading) {
  const Vec2 aside = 0.36 * perp(direction(radians(heading)));
  plan.stand(p + aside, heading, "chair", {0.5, 0.5, 0.85});
  plan.stand(p - aside, heading, "chair", {0.5, 0.5, 0.85});
}

void show(RoomPlan& plan, Vec2 p, double heading) {
  const Ref pedestal = plan.stand(p, heading, "pedestal", {0.5, 0.5, 0.9});
  plan.on(pedestal, {0, 0}, 0, "sculpture", {0.32, 0.32, 0.6});
}

}  // namespace

Scene plan_gallery(int k) {
  static constexpr Gallery kRooms[] = {{12.4, 9.4, 5.2, 3.6, 8.8, false},  {13.0, 9.8, 5.4, 3.8, 9.2, true},
                                       {12.2, 10.0, 5.0, 3.4, 8.8, false}, {12.8, 9.6, 5.6, 3.8, 9.0, false},
                                       {13.4, 9.4, 5.2, 4.0, 9.6, true},   {12.8, 9.6, 5.4, 3.8, 9.0, false}};
  const Gallery& v = kRooms[k - 1];
  RoomPlan plan("gallery",
                {{0, 0},
                 {v.width, 0},
                 {v.width, v.hall},
                 {v.right, v.hall},
                 {v.right, v.depth},
                 {v.left, v.depth},
                 {v.left, v.hall},
                 {0, v.hall}},
                3.4, 600 + static_cast<std::uint64_t>(k));
  const double middle = (v.left + v.right) / 2;
  plan.door("entrance", 0, middle - 0.6, 1.2);
  plan.door("side door", 7, v.hall - 1.1, 0.9);
  for (const double x : {v.left + 0.4, v.right - 0.4})
    for (const double y : {2.4, v.hall - 0.4}) plan.pillar({x, y}, 0.4);
  paintings(plan, 0, 2, 0.8, middle - 1.2);
  paintings(plan, 0, 2, middle + 1.2, v.width - 0.6);
  paintings(plan, 1, 2, 0.5, v.hall - 0.5);
  paintings(plan, 2, 2, 0.3, v.width - v.right - 0.2);
  paintings(plan, 3, 2, 0.4, v.depth - v.hall - 0.6);
  paintings(plan, 4, 2, 0.6, v.right - v.left - 0.6);
  paintings(plan, 5, 2, 0.6, v.depth - v.hall - 0.4);
  paintings(plan, 6, 2, 0.3, v.left - 0.3);
  two_chairs(plan, {v.left * 0.55, v.hall - 1.9}, 90);
  two_chairs(plan, {v.width - (v.width - v.right) * 0.55, v.hall - 1.9}, 90);
  two_chairs(plan, {middle, v.depth - 2.1}, 90);
  show(plan, {v.left * 0.55, 1.5}, -90);
  show(plan, {v.width - (v.width - v.right) * 0.5, 1.5}, -90);
  show(plan, {middle - 0.9, v.hall + 0.9}, -90);
  show(plan, {middle + 0.9, v.hall + 0.9}, -90);
  plan.wall(4, 0.45, "plant", {0.5, 0.5, 1.5}, 0.06);
  plan.wall(4, v.right - v.left - 0.45, "plant", {0.5, 0.5, 1.5}, 0.06);
  plan.wall(1, v.hall - 0.4, "plant", {0.5, 0.5, 1.5}, 0.06);
  plan.stand({middle + 2.0, 1.0}, 150, "reception desk", {1.5, 0.65, 1.05});
  plan.stand({middle - 1.9, 0.75}, 60, "brochure stand", {0.5, 0.35, 1.3});
  return plan.done(v.mirror);
}

}  // namespace inhabit::session
