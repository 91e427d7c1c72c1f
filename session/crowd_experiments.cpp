#include <array>
#include <cmath>

#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"

/// Experiments in laboratories, by the geometry that was published with the recordings, and with as many people, who
/// enter from the time of the recording's first entry to that of its last one, evenly. Coordinates are the recordings',
/// so that both can be measured at the same places.
namespace inhabit::session {
namespace {

Body heading_for(const std::string& goal) {
  Body body = pedestrian_body();
  body.goal = route_to({goal});
  return body;
}

}  // namespace

/// Wuppertal 2018 (ped.2018.1), run 040: 75 people in a corridor 5.6 m wide before an entrance of 0.5 m; in the first
/// frame they stand between x = -2.6 and 2.2 and up to y = 6. The barriers are the published ones. The recording takes
/// 66 s.
Scene experiment_bottleneck_040() {
  Scene scene = room_to_walk("experiment-bottleneck-040", rectangle(-3.5, -2, 3.5, 8), 90);
  scene.space.holes = {{"left-barrier",
                        {{-3.05, -0.3},
                         {-0.7, -0.3},
                         {-0.7, -1.1},
                         {-0.25, -1.1},
                         {-0.25, -0.15},
                         {-0.4, 0},
                         {-2.8, 0},
                         {-2.8, 6.7},
                         {-3.05, 6.7}},
                        {}},
                       {"right-barrier",
                        {{0.7, -1.1},
                         {0.7, -0.3},
                         {3.05, -0.3},
                         {3.05, 6.7},
                         {2.8, 6.7},
                         {2.8, 0},
                         {0.4, 0},
                         {0.25, -0.15},
                         {0.25, -1.1}},
                        {}}};
  scene.crowd.goals = {area_goal("inside", rectangle(-3.5, -2, 3.5, -1.4))};
  scene.crowd.populations = {people_in("crowd", rectangle(-2.6, 0.1, 2.2, 6), 75, heading_for("inside"))};
  return scene;
}

/// Hermes 2009, one-way corridor 1.8 m wide, 8 m long, walked towards -y; people come in at y = 8 through an entrance
/// of the width in the name, which lies about the corridor's middle line; one has an exit of 1.2 m instead.
Scene experiment_unidirectional(int entrance) {
  struct Run {
    int entrance, exit, people;
    double first, last, seconds;
  };
  static constexpr std::array kRuns = {Run{50, 180, 61, 2.6875, 53.1, 80}, Run{100, 180, 121, 0.9375, 47.9, 75},
                                       Run{145, 180, 175, 5.4375, 62.5, 100}, Run{180, 120, 170, 3.75, 58.9, 105}};
  const Run* run = kRuns.data();
  while (run->entrance != entrance) ++run;
  const auto centimetres = [](int c) { return std::string(c < 100 ? "0" : "") + std::to_string(c); };
  Ring ring = {{1.8, -4}, {1.8, 4}, {2.8, 4}, {2.8, 8.6}, {-1, 8.6}, {-1, 4}, {0, 4}, {0, -4}};
  if (run->exit < 180) {
    // Two cheeks 0.2 m thick at the corridor's end.
    const double a = neat(0.9 - run->exit / 200.0), b = neat(0.9 + run->exit / 200.0);
    ring.insert(ring.begin(), {{b, -4}, {b, -3.8}, {1.8, -3.8}}), ring.erase(ring.begin() + 3);
    ring.back() = {0, -3.8}, ring.insert(ring.end(), {{a, -3.8}, {a, -4}});
  }
  ring.insert(ring.end(), {{-1, -4}, {-1, -6.5}, {2.8, -6.5}, {2.8, -4}});
  Scene scene =
      room_to_walk("experiment-unidirectional-" + centimetres(run->entrance) + "-180-" + centimetres(run->exit),
                   std::move(ring), run->seconds);
  scene.crowd.goals = {area_goal("end", rectangle(-1, -6.5, 2.8, -5.9))};
  const double half = std::max(0.25, run->entrance / 200.0);
  scene.crowd.sources = {inflow("entrance", rectangle(0.9 - half, 7, 0.9 + half, 8), run->people, run->first, run->last,
                                heading_for("end"))};
  return scene;
}

/// BaSiGo 2013, one-way corridor 5 m wide, walked towards -x.
Scene experiment_unidirectional_500() {
  Scene scene = room_to_walk("experiment-unidirectional-500", rectangle(-6, 0, 7, 5), 95);
  scene.crowd.goals = {area_goal("end", rectangle(-6, 0, -5.4, 5))};
  scene.crowd.sources = {inflow("entrance", rectangle(4.6, 0.4, 6.6, 4.6), 148, 3.9, 74.4, heading_for("end"))};
  return scene;
}

/// Hermes 2009, two-way corridor 3.6 m wide. People come in by the entrances in the middle of both ends and leave to
/// the sides of the other end. The recording says no more of the places beyond |y| = 4 m than where people were: these
/// are our reading.
Scene experiment_bidirectional(int entrance) {
  struct Run {
    int entrance, up, down;
    double up_first, up_last, down_first, down_last;
  };
  const Run run =
      entrance == 50 ? Run{50, 61, 57, 6.75, 56.75, 5.25, 52.0625} : Run{90, 105, 109, 6.625, 60.875, 6.375, 60.9375};
  Scene scene = room_to_walk("experiment-bidirectional-0" + std::to_string(entrance),
                             {{3.6, -4},
                              {3.6, 4},
                              {5.1, 4},
                              {5.1, 8},
                              {-1.5, 8},
                              {-1.5, 4},
                              {0, 4},
                              {0, -4},
                              {-1.5, -4},
                              {-1.5, -8},
                              {5.1, -8},
                              {5.1, -4}},
                             90);
  scene.crowd.goals = {
      area_goal("north-west", rectangle(-1.5, 4.5, -0.7, 7)), area_goal("north-east", rectangle(4.3, 4.5, 5.1, 7)),
      area_goal("south-west", rectangle(-1.5, -7, -0.7, -4.5)), area_goal("south-east", rectangle(4.3, -7, 5.1, -4.5))};
  Body up = pedestrian_body(), down = pedestrian_body();
  up.goal.legs = {{"north-west", "north-east"}}, down.goal.legs = {{"south-west", "south-east"}};
  const double half = std::max(0.25, entrance / 200.0);
  scene.crowd.sources = {
      inflow("south", rectangle(1.8 - half, -8, 1.8 + half, -6.8), run.up, run.up_first, run.up_last, up),
      inflow("north", rectangle(1.8 - half, 6.8, 1.8 + half, 8), run.down, run.down_first, run.down_last, down)};
  return scene;
}

/// Hermes 2009, a corridor 3 m wide that turns by 90 degrees to the right; people come from +x and leave towards +y.
/// 1.5 m longer than the published area at its beginning, so that those who come in have room.
Scene experiment_corner() {
  Scene scene = room_to_walk("experiment-corner", {{-3, -3}, {6.5, -3}, {6.5, 0}, {0, 0}, {0, 5}, {-3, 5}}, 75);
  scene.crowd.goals = {area_goal("end", rectangle(-3, 4.2, 0, 5))};
  scene.crowd.sources = {inflow("entrance", rectangle(4, -2.8, 6.3, -0.2), 137, 3.3125, 46.3, heading_for("end"))};
  return scene;
}

/// Hermes 2009, run KO 240-050-240: two streams of 67 meet and leave together, all corridors 2.4 m wide. The arms are
/// 1.5 m longer than the published area.
Scene experiment_t_junction() {
  Scene scene =
      room_to_walk("experiment-t-junction",
                   {{-6.5, -2.4}, {5.5, -2.4}, {5.5, 0}, {0, 0}, {0, 5}, {-2.4, 5}, {-2.4, 0}, {-6.5, 0}}, 90);
  scene.crowd.goals = {area_goal("end", rectangle(-2.4, 4.2, 0, 5))};
  scene.crowd.sources = {inflow("left", rectangle(-6.3, -2.2, -4.6, -0.2), 67, 6.9375, 62.0625, heading_for("end")),
                         inflow("right", rectangle(3.6, -2.2, 5.3, -0.2), 67, 5.5625, 59.625, heading_for("end"))};
  return scene;
}

/// People one behind the other in a ring of two straight parts and two half circles, counter-clockwise, 0.5 m wide:
/// narrower than two bodies of 0.3 m, as the experiments' corridors were for people, so that nobody can overtake. Four:
/// CroMa 2021 (ped.2021.5), straight parts of 2.3 m, radius 1.65 m. 14, 20 and 30: Subaih 2019 (ped.2018.5), straight
/// parts of 3.14 m; the ring's length does not come with the data: N times 2.74 m over the mean number in the 2.74 m in
/// the middle of the straight part is 17.7 to 18.9 m, and a radius of 1.87 m makes it 18.03 m.
Scene experiment_single_file(int people) {
  const double straight = people == 4 ? 2.3 : 3.14, radius = people == 4 ? 1.65 : 1.87, half_width = 0.25;
  const auto millimetres = [](double x) { return std::round(1000 * x) / 1000; };
  const auto oval = [&](double r) {
    Ring ring;
    constexpr int kCorners = 24;  // of a half circle
    for (int k = 0; k <= kCorners; ++k) {
      const Vec2 d = direction(kPi * k / kCorners - kPi / 2);
      ring.push_back({millimetres(straight / 2 + r * d.x), millimetres(r * d.y)});
    }
    for (int k = 0; k <= kCorners; ++k)
      ring.push_back({-ring[static_cast<std::size_t>(k)].x, -ring[static_cast<std::size_t>(k)].y});
    return ring;
  };
  Scene scene = room_to_walk("experiment-single-file-" + std::string(people < 10 ? "0" : "") + std::to_string(people),
                             oval(radius + half_width), 120);
  scene.space.holes = {{"middle", oval(radius - half_width), {}}};
  // Way points across the corridor, 2 cm short of its bent walls, in the order of walking; between two of them the
  // corridor bends once.
  const double inner = neat(radius - half_width + 0.02), outer = neat(radius + half_width - 0.02), s = straight / 2;
  scene.crowd.goals = {area_goal("south", rectangle(-0.2, -outer, 0.2, -inner)),
                       area_goal("east", rectangle(s + inner, -0.2, s + outer, 0.2)),
                       area_goal("north", rectangle(-0.2, inner, 0.2, outer)),
                       area_goal("west", rectangle(-s - outer, -0.2, -s - inner, 0.2))};
  // A quarter of the people in each quadrant, each on a way round that begins at the next way point.
  const Ring quadrants[] = {rectangle(0, -outer, s + outer, 0), rectangle(0, 0, s + outer, outer),
                            rectangle(-s - outer, 0, 0, outer), rectangle(-s - outer, -outer, 0, 0)};
  constexpr int kLaps = 20;  // more than anybody walks in two minutes
  for (int q = 0; q < 4; ++q) {
    Body body = pedestrian_body();
    for (int leg = 0; leg < 4 * kLaps; ++leg)
      body.goal.legs.push_back({scene.crowd.goals[static_cast<std::size_t>((q + 1 + leg) % 4)].id});
    const int count = (people + 3 - q) / 4;
    scene.crowd.populations.push_back(people_in("quarter-" + std::to_string(q + 1), quadrants[q], count, body));
  }
  return scene;
}

}  // namespace inhabit::session
