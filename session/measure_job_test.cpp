#include "session/measure_job.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

using namespace inhabit;
using namespace inhabit::session;

namespace {

/// Two files of people at 1.25 m/s through a corridor 2 m wide, 20 m long, a person every second in each; 10 frames a
/// second.
scene::Trajectories corridor() {
  scene::Trajectories t;
  t.frame_rate = 10, t.name = "corridor";
  t.walkable = {{Ring{{-1, 0}, {21, 0}, {21, 2}, {-1, 2}}, {}}};
  for (int frame = 0; frame < 400; ++frame)
    for (int p = 0; p < 40; ++p) {
      const double x = 1.25 * (frame / 10.0 - p / 2) + 0.123;
      if (x >= 0 && x <= 20) t.fixes.push_back({frame, p, x, p % 2 ? 0.5 : 1.5});
    }
  return t;
}

}  // namespace

TEST_CASE("a corridor of regular walkers is measured as it was made") {
  const auto t = corridor();
  const Result<MeasureReport> r = measure_job(t, {.area = Ring{{8, 0}, {12, 0}, {12, 2}, {8, 2}}, .field = true});
  REQUIRE(r.ok());
  CHECK(r->presence.people == 40);
  CHECK(r->place.line.length() == doctest::Approx(2).epsilon(1e-9));
  CHECK(r->place.width == doctest::Approx(2).epsilon(1e-6));
  CHECK(r->place.area.size == doctest::Approx(8));
  CHECK(r->flow.forward + r->flow.backward == 40);
  CHECK(r->flow.forward == 40);
  // Two people every second but for the last pair: 39 people in 19 s.
  CHECK(r->flow.flow == doctest::Approx(39 / 19.0).epsilon(1e-9));
  // Everybody holds 1.25 m² in the middle of the flow: the whole of the area for some of the time.
  double most = 0;
  for (const crowd::AreaRow& row : r->voronoi) most = std::max(most, row.density);
  CHECK(most == doctest::Approx(0.8).epsilon(1e-9));
  CHECK(median(r->speeds) == doctest::Approx(1.25).epsilon(1e-9));
  CHECK(r->overlaps.pairs == 0);
  CHECK(r->walls.touching == 0);
  CHECK(!crowd::known(crowd::mean_order(r->lanes)));
  for (const crowd::PathRow& path : r->paths) CHECK(path.detour() == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("what is measured leaves as text and JSON and rows and plots") {
  const auto t = corridor();
  const Result<MeasureReport> r = measure_job(t, {.field = true});
  REQUIRE(r.ok());
  const std::string text = measure_text(*r);
  CHECK(text.find("--area gives another") != std::string::npos);
  CHECK(text.find("specific flow") != std::string::npos);
  const auto json = nlohmann::json::parse(measure_json(*r));
  CHECK(json["people"] == 40);
  CHECK(json["place"]["area_given"] == false);
  CHECK(json["lane_order"].is_null());
  const auto rows = measure_csv(*r);
  CHECK(rows.size() == 7);
  for (const auto& [name, bytes] : rows) CHECK(std::count(bytes.begin(), bytes.end(), '\n') > 1);
  const auto plots = measure_plots(t, *r, "svg");
  REQUIRE(plots.ok());
  CHECK(plots->size() == 7);
  CHECK(!measure_plots(t, *r, "gif").ok());
}

TEST_CASE("threads change nothing in a report") {
  const auto t = corridor();
  const auto one = measure_job(t, {.field = true, .threads = 1}), four = measure_job(t, {.field = true, .threads = 4});
  CHECK(measure_json(*one) == measure_json(*four));
  CHECK(measure_csv(*one) == measure_csv(*four));
}

TEST_CASE("a span of time is kept to and an empty one is refused") {
  const auto t = corridor();
  const auto r = measure_job(t, {.from = 5, .until = 10});
  REQUIRE(r.ok());
  CHECK(r->from == 5);
  CHECK(r->until == 10);
  const auto none = measure_job(t, {.from = 100});
  REQUIRE(!none.ok());
  CHECK(none.error().text().find("from 0.00 to 3") != std::string::npos);
  CHECK(!measure_job({}, {}).ok());
}

TEST_CASE("places are read and refused with a reason") {
  CHECK(parse_area("0,0,2,1")->size() == 4);
  CHECK(parse_area("POLYGON ((0 0, 2 0, 1 1, 0 0))")->size() == 3);
  CHECK(!parse_area("0,0,2").ok());
  CHECK(!parse_area("0,0,0,1").ok());
  CHECK(!parse_area("0,0,nan,1").ok());
  CHECK(!parse_area("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))").ok());
  CHECK(parse_line("0, 1, 2, 3")->b == Vec2{2, 3});
  CHECK(!parse_line("1,1,1,1").ok());
  CHECK(!parse_line("x").ok());
  const auto t = corridor();
  CHECK(!measure_job(t, {.area = Ring{{50, 50}, {51, 50}, {51, 51}}}).ok());
}

TEST_CASE("without walls the ground is what people walked on") {
  auto t = corridor();
  t.walkable.clear();
  const auto r = measure_job(t, {});
  REQUIRE(r.ok());
  CHECK(!r->place.walls);
  CHECK(r->place.cut_off == 1);
  CHECK(r->ground.front().size() == doctest::Approx(20.6 * 1.6).epsilon(0.05));
  CHECK(!r->remarks.empty());
}

TEST_CASE("somebody who stands still is measured or refused without harm") {
  scene::Trajectories t;
  for (int frame = 0; frame < 10; ++frame) t.fixes.push_back({frame, 1, 2, 3});
  const auto r = measure_job(t, {});
  REQUIRE(r.ok());
  CHECK(r->flow.times.empty());
  CHECK(!measure_text(*r).empty());
  CHECK(!measure_json(*r).empty());
  CHECK(measure_plots(t, *r, "svg").ok());
}

TEST_CASE("the floor of a scene is what its holes and furniture leave") {
  Document document;
  scene::Scene scene;
  scene.space.outline = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  scene.space.holes = {{"pillar", {{5, 3}, {5.5, 3}, {5.5, 3.5}, {5, 3.5}}, {}}};
  scene::Object table;
  table.size = {2, 1, 0.7}, table.position = Vec3{2, 2, 0}, table.angle = 0;
  scene::Object rug = table, lamp = table, unplaced = table;
  rug.size.z = 0.02, lamp.position->z = 2.2, unplaced.position.reset();
  scene.objects = {table, rug, lamp, unplaced};
  document.scenes = {scene};
  const auto areas = walkable_of(document);
  REQUIRE(areas.ok());
  CHECK(areas->front().size() == doctest::Approx(24 - 0.25 - 2).epsilon(1e-9));
}
