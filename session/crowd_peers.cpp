#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"

namespace inhabit::session {
namespace {

/// Everybody wants 1.4 m/s and can do 2: what all compared programs were given. Their people start with the velocity
/// that they like.
Body peers_body() {
  Body body = game_body();
  body.speed = {1.4, 0, 2};
  return body;
}

struct Jam {
  int people, columns, rows;
  double width, seconds;
};
constexpr Jam kJams[] = {{480, 20, 24, 6, 60}, {3600, 60, 60, 12, 60}, {100048, 296, 338, 48, 30}};
constexpr double kCorridor = 20, kJamSpacing = 1.5, kJamJitter = 0.1, kFront = 5;

}  // namespace

/// One block, its front row 5 m before the wall at x = 0, in a hall that reaches 40 m beyond it on every side: nobody
/// is pushed that far. Behind the corridor a hall of 120 m, since who walks at 2 m/s for a minute is 115 m beyond the
/// wall. While somebody is before the wall, he heads for the nearest point of a line half a metre behind it, 0.75 m
/// shorter at either end than the corridor is wide; then straight on.
///
/// The peers' people walk from the start and on for ever. The thesis's stand at first, arrive 5 m behind the corridor,
/// walk at 1.4 +- 0.1 m/s and look at contacts only; it prints neither the width of its corridor nor how its people
/// stand, so they do as the peers'.
Scene bottleneck(BottleneckOf whose, int people) {
  const bool thesis = whose == BottleneckOf::thesis;
  const Jam* jam = kJams;
  while (jam->people != people) ++jam;
  Scene scene;
  scene.name = (thesis ? "bottleneck-" : "peers-bottleneck-") + std::to_string(people);
  const double half = jam->width / 2, depth = (jam->columns - 1) * kJamSpacing;
  const double left = -kFront - depth - 40, top = jam->rows * kJamSpacing / 2 + 40, right = kCorridor + 120;
  scene.space.outline = {{left, -top},      {0, -top},     {0, -half},   {kCorridor, -half},
                         {kCorridor, -top}, {right, -top}, {right, top}, {kCorridor, top},
                         {kCorridor, half}, {0, half},     {0, top},     {left, top}};
  Goal mouth = area_goal("mouth", rectangle(0, -half, kCorridor, half));
  mouth.aim = rectangle(0.5, 0.75 - half, 0.51, half - 0.75);
  scene.crowd.goals = {mouth,
                       thesis ? area_goal("out", rectangle(kCorridor + 5, -top, right, top)) : direction_goal("on", 0)};
  Body body = thesis ? game_body() : peers_body();
  body.goal = route_to({"mouth", thesis ? "out" : "on"});
  scene.crowd.populations = {grid_of_people("crowd", {-kFront - depth, -(jam->rows - 1) * kJamSpacing / 2},
                                            jam->columns, jam->rows, kJamSpacing, kJamJitter, body)};
  scene.crowd.populations[0].walking = !thesis;
  scene.crowd.model = game_model(thesis ? Far::off : Far::long_range);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = jam->seconds;
  return scene;
}

/// Front rows 6 m apart; 30 s, in which nobody who walks at 2 m/s comes within 10 m of the outline.
Scene peers_passing(int people) {
  const int columns = people == 1600 ? 20 : people == 10032 ? 38 : 40, rows = people / columns / 2;
  const double spacing = 3, jitter = 0.25, front = 3;
  const double depth = (columns - 1) * spacing, side = (rows - 1) * spacing / 2;
  Scene scene;
  scene.name = "peers-passing-" + std::to_string(people);
  scene.space.outline = rectangle(-front - depth - 70, -side - 70, front + depth + 70, side + 70);
  scene.crowd.goals = {direction_goal("east", 0), direction_goal("west", 180)};
  Body body = peers_body();
  body.goal = route_to({"east"});
  scene.crowd.populations.push_back(
      grid_of_people("from-west", {-front - depth, -side}, columns, rows, spacing, jitter, body));
  body.goal = route_to({"west"});
  scene.crowd.populations.push_back(grid_of_people("from-east", {front, -side}, columns, rows, spacing, jitter, body));
  for (Population& block : scene.crowd.populations) block.walking = true;
  scene.crowd.model = game_model(Far::long_range);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = 30;
  return scene;
}

/// Everybody heads for the centre of a lattice with 5 cm to spare, 10 s.
Scene peers_crush() {
  const double spacing = 1.05, x = 295 * spacing / 2, y = 337 * spacing / 2;
  Scene scene;
  scene.name = "peers-crush";
  scene.space.outline = rectangle(-x - 30, -y - 30, x + 30, y + 30);
  Goal centre = area_goal("centre", rectangle(-0.01, -0.01, 0.01, 0.01));
  centre.absorb = false;
  scene.crowd.goals = {centre};
  Body body = peers_body();
  body.goal = route_to({"centre"});
  scene.crowd.populations = {grid_of_people("crowd", {-x, -y}, 296, 338, spacing, 0.02, body)};
  scene.crowd.populations[0].walking = true;
  scene.crowd.model = game_model(Far::long_range);
  scene.crowd.planner = Planner::straight;
  scene.crowd.seconds = 10;
  return scene;
}

}  // namespace inhabit::session
