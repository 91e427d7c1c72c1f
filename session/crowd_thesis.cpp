#include <cmath>

#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"

namespace inhabit::session {
namespace {

/// Between the front rows of two groups, metres; the thesis does not say. Farther than anybody looks ahead
/// (PbdModel::far_range), so that nobody starts within another's view.
constexpr double kGap = 10;
/// "A loose grid formation": nobody stands exactly behind or before another.
constexpr double kJitter = 0.25;
/// From the last row that is to be passed to the goal, and beside the groups, where they may spread to.
constexpr double kBehind = 5, kBeside = 30;

/// A group as a block: columns deep, rows wide.
struct Block {
  int columns = 0, rows = 0;
  double spacing = 0;
  Body body = game_body();
  double depth() const { return (columns - 1) * spacing; }
  double width() const { return (rows - 1) * spacing; }
};

/// The field on which two groups pass each other along x and the goals behind them, strips across the whole way, so
/// that the way is straight ahead.
Scene field_for(std::string name, double west_depth, double east_depth, double width, Far far) {
  Scene scene;
  scene.name = std::move(name);
  const double west = kGap / 2 + west_depth + kBehind, east = kGap / 2 + east_depth + kBehind;
  const double side = width / 2 + kBeside;
  scene.space.outline = rectangle(-west - 15, -side - 10, east + 15, side + 10);
  scene.crowd.goals = {area_goal("west", rectangle(-west - 5, -side, -west, side)),
                       area_goal("east", rectangle(east, -side, east + 5, side))};
  scene.crowd.model = game_model(far);
  scene.crowd.planner = Planner::straight;
  return scene;
}

Scene passing(std::string name, Block west, Block east, Far far, double seconds) {
  Scene scene = field_for(std::move(name), west.depth(), east.depth(), std::max(west.width(), east.width()), far);
  west.body.goal = route_to({"east"}), east.body.goal = route_to({"west"});
  const auto corner = [](double x, const Block& b) { return Vec2{neat(x), neat(-b.width() / 2)}; };
  scene.crowd.populations = {
      grid_of_people("from-west", corner(-kGap / 2 - west.depth(), west), west.columns, west.rows, west.spacing,
                     kJitter, west.body),
      grid_of_people("from-east", corner(kGap / 2, east), east.columns, east.rows, east.spacing, kJitter, east.body)};
  scene.crowd.seconds = seconds;
  return scene;
}

}  // namespace

// 6.1.2 prints numbers and spacings; how many stand behind and how many beside each other is ours: 20 by 40 for 1,600,
// 38 by 132 for 10,032 and 24 by 28 for 1,344. `seconds`: the slowest, at 1.1 m/s, has half as much again as he needs.
Scene sparse_passing() { return passing("sparse-passing", {20, 40, 4.5}, {20, 40, 4.5}, Far::long_range, 260); }
Scene dense_passing() { return passing("dense-passing", {20, 40, 2.5}, {20, 40, 2.5}, Far::long_range, 160); }
Scene dense_passing_10k() { return passing("dense-passing-10k", {38, 132, 3.5}, {38, 132, 3.5}, Far::long_range, 400); }

/// 1,152 = 1,024 rabbits + 128 bears; how many of each the thesis does not say. "Size" is read as a diameter, since
/// agents of radius 0.5 have size 1: bears have radii of 1.25 to 2 m. Bears stand 6 m apart, rabbits 3 m, so that both
/// groups are about as wide.
Scene bears_and_rabbits() {
  Body bear = game_body();
  bear.radius = {1.25, 2}, bear.mass = 30;
  return passing("bears-and-rabbits", {32, 32, 3}, {8, 16, 6, bear}, Far::avoidance, 260);
}

/// 1,920 = 320 in an ellipse + 1,600 in a rectangle of 40 by 40, our split; the ellipse is 72.6 m by 59.4 m, as many
/// grid cells of 3.3 m as hold 320 centres.
Scene dense_ellipsoid() {
  const double spacing = 3.3, half_depth = 11 * spacing, half_width = 9 * spacing;
  const Block rectangle_block{40, 40, 3};
  Scene scene =
      field_for("dense-ellipsoid", 2 * half_depth, rectangle_block.depth(), rectangle_block.width(), Far::avoidance);
  Population ellipse = people_in("ellipse", {}, 320, game_body());
  const Vec2 center{-kGap / 2 - half_depth, 0};
  constexpr int kCorners = 48;
  for (int k = 0; k < kCorners; ++k) {
    const Vec2 d = direction(2 * kPi * k / kCorners);
    const auto centimetres = [](double x) { return std::round(100 * x) / 100; };
    ellipse.area.push_back({neat(center.x + centimetres(half_depth * d.x)), centimetres(half_width * d.y)});
  }
  ellipse.spacing = spacing, ellipse.jitter = kJitter, ellipse.goal = route_to({"east"});
  Population rest = grid_of_people("rectangle", {kGap / 2, -rectangle_block.width() / 2}, rectangle_block.columns,
                                   rectangle_block.rows, rectangle_block.spacing, kJitter, game_body());
  rest.goal = route_to({"west"});
  scene.crowd.populations = {ellipse, rest};
  scene.crowd.seconds = 280;
  return scene;
}

/// Two groups of 50, ten deep and five wide, 1.1 m apart ("tightly packed"), 20 m between them, in a hallway of 12 m by
/// 80 m: room for two groups beside each other and 1.2 m more. The measures are ours. In 10 m and in 8 m all arrive,
/// too.
Scene proximal() {
  const double spacing = 1.1, front = 10, depth = 9 * spacing, side = 2 * spacing;
  Scene scene;
  scene.name = "proximal";
  scene.space.outline = rectangle(-40, -6, 40, 6);
  scene.crowd.goals = {area_goal("west", rectangle(-38, -6, -35, 6)), area_goal("east", rectangle(35, -6, 38, 6))};
  Body body = game_body();
  body.goal = route_to({"east"});
  scene.crowd.populations.push_back(grid_of_people("from-west", {-front - depth, -side}, 10, 5, spacing, 0.02, body));
  body.goal = route_to({"west"});
  scene.crowd.populations.push_back(grid_of_people("from-east", {front, -side}, 10, 5, spacing, 0.02, body));
  scene.crowd.model = game_model(Far::avoidance);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = 120;
  return scene;
}

/// 192 = 16 by 12, 5.5 m apart, each up to 1 m from its point; the targets are 60 m east and 15 m north of where each
/// one started, up to 1 m off: two people's targets are at least 1.5 m apart. Everybody stays at his target.
Scene target_locomotion() {
  Scene scene;
  scene.name = "target-locomotion";
  const double spacing = 5.5, width = 15 * spacing, height = 11 * spacing;
  scene.space.outline = rectangle(-30, -30, width + 90, height + 45);
  Goal goal;
  goal.id = "target", goal.offset = Vec2{60, 15}, goal.jitter = 1, goal.absorb = false;
  scene.crowd.goals = {goal};
  Body body = game_body();
  body.goal = route_to({"target"});
  scene.crowd.populations = {grid_of_people("walkers", {0, 0}, 16, 12, spacing, 1, body)};
  scene.crowd.model = game_model(Far::long_range);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = 90;
  return scene;
}

namespace {

/// The thesis's spacings are in the units of its solver, whose particles have radius 1 (4.2.3). With a radius of 0.5
/// nobody would overlap at either spacing, and its figure 6.7 shows that they do at 3.3.
Scene power_law(std::string name, double spacing, double seconds) {
  Body body = game_body();
  body.radius = {1, 1};
  Scene scene = passing(std::move(name), {24, 28, spacing, body}, {24, 28, spacing, body}, Far::off, seconds);
  scene.crowd.model = PowerLawModel{};
  return scene;
}

}  // namespace

Scene power_law_sparse() { return power_law("power-law-sparse", 4.5, 320); }
Scene power_law_dense() { return power_law("power-law-dense", 3.3, 240); }

}  // namespace inhabit::session
