#include "session/emergence.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "session/crowd_builder.h"

using namespace inhabit;
using namespace inhabit::session;

namespace {

/// Two groups of 5 x 4 on the same rows, heading through each other to 25 m from the middle.
Scene two_groups(double spacing) {
  Scene scene;
  scene.name = "two";
  scene.space.outline = rectangle(-30, -10, 30, 10);
  scene.crowd.goals = {area_goal("west", rectangle(-30, -10, -25, 10)), area_goal("east", rectangle(25, -10, 30, 10))};
  Body body = game_body();
  body.radius = {0.25, 0.25}, body.speed.deviation = 0;
  body.goal = route_to({"east"});
  scene.crowd.populations.push_back(grid_of_people("from-west", {-15, -5}, 5, 4, spacing, 0, body));
  body.goal = route_to({"west"});
  scene.crowd.populations.push_back(grid_of_people("from-east", {5, -5}, 5, 4, spacing, 0, body));
  scene.crowd.model = game_model(Far::long_range);
  scene.crowd.seconds = 120;
  return scene;
}

}  // namespace

TEST_CASE("an emergent run ends with the last arrival and looks once a second") {
  int looks = 0;
  std::size_t most = 0;
  const auto run = emergent_run(two_groups(2), {}, [&](const crowd::Simulation& s) {
    ++looks;
    most = std::max(most, s.agents().size());
  });
  REQUIRE(run.ok());
  CHECK(run->all());
  CHECK(run->people == 40);
  CHECK(most == 40);
  // The last have 40 m to walk at 1.4 m/s, from rest and round each other.
  CHECK(run->last > 40 / 1.4);
  CHECK(run->last < 40);
  CHECK(looks == 1 + static_cast<int>(run->last + 1e-9));
  SimulateJob brief;
  brief.seconds = 5;
  const auto cut = emergent_run(two_groups(2), brief, {});
  REQUIRE(cut.ok());
  CHECK_FALSE(cut->all());
  CHECK(cut->last == doctest::Approx(5));
}

TEST_CASE("groups on the same rows have no lanes at the start and groups on rows of their own have") {
  Scene scene = two_groups(2);
  const auto at_start = [&] {
    std::optional<LaneMoment> first;
    SimulateJob brief;
    brief.seconds = 0.5;
    REQUIRE(emergent_run(scene, brief, [&](const crowd::Simulation& s) {
              if (!first) first = lane_moment(s, 1);
            }).ok());
    return *first;
  };
  const LaneMoment mixed = at_start();
  CHECK(mixed.narrow == doctest::Approx(0));
  CHECK(mixed.apart == doctest::Approx(20));
  for (Vec2& p : scene.crowd.populations[1].area) p.y += 1;
  const LaneMoment lanes = at_start();
  CHECK(lanes.narrow == doctest::Approx(1));
  // Bands of 2 m either way mix the rows, which are 1 m apart: inner ones 2 to 1, the outer two 1 to 1.
  CHECK(lanes.wide < 0.2);
  CHECK(lanes.narrow_chance < 0.5);
}

TEST_CASE("a jam is measured by rings before the opening and people behind the wall do not count") {
  Scene scene;
  scene.name = "jam";
  scene.space.outline = rectangle(-20, -20, 20, 20);
  scene.crowd.goals = {area_goal("east", rectangle(19, -20, 20, 20))};
  Body body = game_body();
  body.goal = route_to({"east"});
  scene.crowd.populations = {grid_of_people("before", {-2.5, 0}, 1, 1, 1, 0, body),
                             grid_of_people("behind", {3, 0}, 1, 1, 1, 0, body)};
  std::optional<JamMoment> jam;
  SimulateJob brief;
  brief.seconds = 0.5;
  REQUIRE(emergent_run(scene, brief, [&](const crowd::Simulation& s) {
            if (!jam) jam = jam_moment(s, 4);
          }).ok());
  CHECK(jam->before == 1);
  CHECK_FALSE(jam->arch.has_value());
  CHECK(jam->speed[2] == 0);
  CHECK_FALSE(crowd::known(jam->speed[1]));
  CHECK(jam->cover[1] == 0);
  // A disc of 0.5 m in the half ring from 2 to 3 m.
  CHECK(jam->cover[2] == doctest::Approx(0.25 / (0.5 * (9 - 4))));
}
