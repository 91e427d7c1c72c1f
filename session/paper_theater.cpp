#include <algorithm>
#include <cmath>
#include <string>

#include "session/paper_scenes.h"
#include "session/scene_builder.h"

/// Thesis A.1, TVCG 4.1.1. A theatre seat is 0.55 m wide and 0.6 m deep; rows are 0.9 m apart, as building codes ask
/// for.
namespace inhabit::session {
namespace {

constexpr Vec3 kSeat{0.55, 0.6, 0.9};
constexpr double kTierPitch = 0.9;
/// A seat's centre stays this far from the middle of a lane, which leaves a corridor of 1.25 m.
constexpr double kLaneClearance = 0.9;
constexpr double kLaneWidth = 2 * kLaneClearance - kSeat.x;
/// 15 degrees: steeper lanes would leave the hall through its side walls before they reach the last tier.
constexpr double kLaneAngle = radians(15);

/// The stage stands at the middle of the front wall and looks into the hall. It is fixed: the papers place it there by
/// hand, and tiers of given radii fit into the hall round no other point.
Ref add_stage(Scene& scene, double hall_width, double width, double depth) {
  Object stage;
  stage.id = stage.kind = "stage";
  stage.size = {width, depth, 1};
  stage.position = Vec3{hall_width / 2, depth / 2, 0};
  stage.angle = kPi / 2;
  stage.fixed = true;
  const Ref ref = add_object(scene, std::move(stage));
  stand_at_wall(scene, {ref}, 0, 0);
  return ref;
}

void add_lane(Scene& scene, Ref stage, double angle, const std::vector<Ref>& seats) {
  TrafficLane lane;
  lane.from = stage;
  lane.angle = angle;
  lane.clearance = kLaneClearance;
  lane.members = list_of(seats);
  scene.constraints.add(std::move(lane));
}

/// Two doors in the side walls near the front, where an audience enters.
void add_hall_doors(Space& space) {
  for (const int wall : {1, 3}) {
    Door door;
    door.id = wall == 1 ? "door-right" : "door-left";
    door.wall = wall;
    door.width = 1.2;
    door.from = wall == 1 ? 0.2 : space.outline[2].y - 0.2 - door.width;
    door.swing = Door::Swing::out;
    space.doors.push_back(door);
  }
}

/// The arc of radius r about the stage that a seat's centre can reach between walls `width` apart.
double available_arc(double r, double width) {
  const double half = std::max(0.0, width / 2 - std::hypot(kSeat.x, kSeat.y) / 2);
  return 2 * r * std::asin(std::min(1.0, half / r));
}

/// Seats that fill 65 % of the tier's arc, the two lanes counted as filled.
double tier_capacity(double r, double width) {
  return std::max(0.5, (0.65 * available_arc(r, width) - 2 * kLaneWidth) / kSeat.x);
}

struct Hall {
  double width = 0, depth = 0, stage_width = 0, stage_depth = 0;
  std::vector<double> radii;
  std::vector<int> seats;  ///< per tier
};

/// 200 seats make 14 tiers from 4 m to 15.7 m; everything grows with the square root of the number of seats, and the
/// hall is as wide as the fill asks for.
Hall plan_hall(int seats) {
  const double scale = std::sqrt(seats / 200.0);
  Hall hall;
  hall.stage_width = std::max(3.0, 6 * scale);
  hall.stage_depth = std::max(1.5, 2 * scale);
  const double first = std::max(2.6, 4 * scale);
  const int tiers = std::clamp(static_cast<int>(std::lround(14 * scale)), 1, seats);
  for (int t = 0; t < tiers; ++t) hall.radii.push_back(first + kTierPitch * t);

  const auto capacity = [&](double width) {
    double sum = 0;
    for (const double r : hall.radii) sum += tier_capacity(r, width);
    return sum;
  };
  double low = hall.stage_width + 1, high = 2 * hall.radii.back() + 2;
  for (int i = 0; i < 60; ++i) (capacity((low + high) / 2) < seats ? low : high) = (low + high) / 2;
  // Whole centimetres, so that the file is readable.
  hall.width = std::ceil(100 * high) / 100;
  hall.depth = std::ceil(100 * (hall.stage_depth / 2 + hall.radii.back() + kSeat.y / 2 + 0.6)) / 100;

  // Rounding the running sum keeps both the total and every tier within one seat of its share.
  const double total = capacity(hall.width);
  double running = 0;
  int given = 0;
  for (const double r : hall.radii) {
    running += tier_capacity(r, hall.width);
    const int upto = static_cast<int>(std::lround(seats * running / total));
    hall.seats.push_back(upto - given);
    given = upto;
  }
  return hall;
}

}  // namespace

Scene theater_1(int seats) {
  const Hall hall = plan_hall(seats);
  Scene scene;
  scene.name = "theater-1";
  scene.space = rectangular_space(hall.width, hall.depth, 8);
  add_hall_doors(scene.space);
  const auto n = static_cast<std::size_t>(seats);
  scene.objects.reserve(n + 1);
  const Ref stage = add_stage(scene, hall.width, hall.stage_width, hall.stage_depth);

  std::vector<Ref> everyone;
  everyone.reserve(n);
  for (std::size_t t = 0; t < hall.radii.size(); ++t) {
    std::vector<Ref> tier;
    // 0.2 m to pass before the knees; the rows leave 0.3 m.
    for (int s = 0; s < hall.seats[t]; ++s)
      tier.push_back(
          add_object(scene, numbered("seat", everyone.size() + tier.size() + 1), "seat", kSeat, {.front = 0.2}));
    if (tier.empty()) continue;
    everyone.insert(everyone.end(), tier.begin(), tier.end());
    gather_round(scene, stage, tier, hall.radii[t], true);
    FocalSymmetry symmetry;
    symmetry.focal = stage;
    symmetry.members = list_of(tier);
    scene.constraints.add(std::move(symmetry));
    look_at(scene, std::move(tier), stage);
  }
  add_lane(scene, stage, kLaneAngle, everyone);
  add_lane(scene, stage, -kLaneAngle, everyone);
  return scene;
}

namespace {

/// Neighbours' centres, 7 cm between seats.
constexpr double kSpacing = 0.62;

struct Tier {
  Curve curve;
  int seats = 0;
  Vec2 centre;  ///< of mass, when the seats are evenly spread about the curve's middle
};

/// A tier's length: its seats, and room for the pathways that cut it.
double tier_length(int seats, int pathways) { return (seats - 1) * kSpacing + pathways * kLaneWidth + 0.2; }

/// Nine tiers of 12, 14 … 28 seats, 5 m to 13 m from the stage: 180.
std::vector<Tier> arc_tiers(Vec2 stage, int pathways) {
  std::vector<Tier> tiers;
  for (int t = 0; t < 9; ++t) {
    Tier tier;
    tier.seats = 12 + 2 * t;
    const double r = 5 + t, half = tier_length(tier.seats, pathways) / (2 * r);
    tier.curve.kind = Curve::Kind::arc;
    tier.curve.center = stage;
    tier.curve.start = stage + r * direction(kPi / 2 - half);
    tier.curve.end = stage + r * direction(kPi / 2 + half);
    // The mean of points at angles j * step about the middle: r times the mean of their cosines.
    double mean = 0;
    for (int s = 0; s < tier.seats; ++s) mean += sin_cos((s - (tier.seats - 1) / 2.0) * kSpacing / r).cos;
    tier.centre = stage + Vec2{0, r * mean / tier.seats};
    tiers.push_back(tier);
  }
  return tiers;
}

/// 12 straight rows of 14 seats (168), or with two pathways 7 wide rows of 35 (245), 1 m apart.
std::vector<Tier> segment_tiers(Vec2 stage, int pathways) {
  std::vector<Tier> tiers;
  const int rows = pathways == 2 ? 7 : 12, seats = pathways == 2 ? 35 : 14;
  const double half = tier_length(seats, pathways) / 2;
  for (int t = 0; t < rows; ++t) {
    Tier tier;
    tier.seats = seats;
    tier.centre = stage + Vec2{0, 4.0 + t};
    tier.curve.start = tier.centre - Vec2{half, 0};
    tier.curve.end = tier.centre + Vec2{half, 0};
    tiers.push_back(tier);
  }
  return tiers;
}

}  // namespace

Scene theater_2(TheaterCurve curve, int pathways) {
  const bool arc = curve == TheaterCurve::arc;
  Scene scene;
  scene.name = std::string("theater-2-") + (arc ? "arc-" : "segment-") + std::to_string(pathways);
  // The outermost seats and a metre of aisle along the walls.
  const double width = arc ? 21 : (pathways == 2 ? 27 : 12), depth = arc ? 16.5 : (pathways == 2 ? 13 : 18);
  scene.space = rectangular_space(width, depth, 8);
  add_hall_doors(scene.space);
  const Ref stage = add_stage(scene, width, 6, 2);
  const Vec2 centre = scene.objects[stage.index].position->xy();

  std::vector<Ref> everyone;
  const std::vector<Tier> tiers = arc ? arc_tiers(centre, pathways) : segment_tiers(centre, pathways);
  for (std::size_t t = 0; t < tiers.size(); ++t) {
    Group group;
    group.id = numbered("tier", t + 1);
    for (int s = 0; s < tiers[t].seats; ++s)
      group.members.push_back(
          add_object(scene, numbered("seat", everyone.size() + group.members.size() + 1), "seat", kSeat));
    group.curve = tiers[t].curve;
    group.spacing = kSpacing;
    const std::vector<Ref> seats = group.members;
    everyone.insert(everyone.end(), seats.begin(), seats.end());
    add_group(scene, std::move(group));
    centre_at(scene, seats, tiers[t].centre);
    // Seats of a straight row look straight ahead; turned to the stage they would not fit side by side.
    if (arc)
      look_at(scene, seats, stage);
    else
      run_parallel(scene, seats, stage, kPi);
  }
  if (pathways == 1) add_lane(scene, stage, 0, everyone);
  if (pathways == 2)
    for (const double side : {1.0, -1.0}) add_lane(scene, stage, side * (arc ? kLaneAngle : 2 * kLaneAngle), everyone);
  Collision off;
  off.mode = 2;
  scene.constraints.add(off);
  return scene;
}

}  // namespace inhabit::session
