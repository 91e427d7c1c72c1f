#include "session/crowd_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "geometry/containment.h"
#include "io/file.h"
#include "io/formats/scene_json.h"
#include "session/crowd_builder.h"
#include "session/document.h"

using namespace inhabit;
using namespace inhabit::session;

namespace {

Scene scene_of(std::string_view name) {
  const CrowdScene* scene = find_crowd_scene(name);
  REQUIRE_MESSAGE(scene, name);
  return scene->build();
}

/// Centres of the square cells of a population's grid that are in its area: crowd/placement.h.
int grid_points(const Population& people) {
  const Bounds box = bounds(people.area);
  const auto cells = [&](double l) { return static_cast<int>(std::floor(l / *people.spacing + 1e-6)); };
  int count = 0;
  for (int row = 0; row < cells(box.size().y); ++row)
    for (int column = 0; column < cells(box.size().x); ++column)
      count += contains(people.area, box.min + *people.spacing * Vec2{column + 0.5, row + 0.5});
  return count;
}

}  // namespace

TEST_CASE("every scene with people is a file that its builder writes and reading gives back") {
  for (const CrowdScene& crowd : crowd_scenes()) {
    CAPTURE(crowd.name);
    const Scene scene = crowd.build();
    CHECK(scene.name == crowd.name);
    const std::string text = io::write_scene(scene);
    const auto again = io::read_scene(text);
    REQUIRE_MESSAGE(again.ok(), again.error().text());
    CHECK(*again == scene);
    const std::filesystem::path path =
        std::filesystem::path(INHABIT_SOURCE_DIR) / "scenes" / (std::string(crowd.name) + ".json");
    if (std::getenv("INHABIT_UPDATE_DOCS") != nullptr) std::ofstream(path, std::ios::binary) << text;
    const Result<std::string> bytes = io::read_file(path);
    REQUIRE(bytes.ok());
    CHECK_MESSAGE(*bytes == text, "out of date; run the tests once with INHABIT_UPDATE_DOCS=1");
    const Result<Document> builtin = open_document(std::string(crowd.name));
    CHECK_MESSAGE(builtin.ok(), "build anew: files in scenes/ are embedded");
    if (builtin) CHECK(builtin->scenes.front() == scene);
  }
}

TEST_CASE("everybody starts and wants to go to the floor and grids have as many points as people") {
  for (const CrowdScene& crowd : crowd_scenes()) {
    CAPTURE(crowd.name);
    const Scene scene = crowd.build();
    std::vector<Ring> holes;
    for (const Hole& hole : scene.space.holes) holes.push_back(hole.outline);
    const Floor floor = make_floor(scene.space.outline, holes);
    for (const Population& people : scene.crowd.populations) {
      CAPTURE(people.id);
      CHECK_FALSE(people.goal.empty());
      if (scene.space.holes.empty())
        for (const Vec2 corner : people.area) CHECK(outside_distance(floor, corner) < 1e-9);
      if (people.spacing) {
        CHECK(grid_points(people) == people.count);
        // Nobody touches anybody at first.
        CHECK(*people.spacing - 2 * people.jitter >= 2 * people.radius.high - 1e-9);
      } else {
        // Hexagons hold 0.9069 of the plane.
        const double discs = *people.count * kPi * people.radius.high * people.radius.high;
        if (scene.space.holes.empty()) CHECK(discs < 0.8 * signed_area(people.area));
      }
    }
    for (const Source& source : scene.crowd.sources)
      for (const Vec2 corner : source.area) CHECK(outside_distance(floor, corner) < 1e-9);
    for (const Goal& goal : scene.crowd.goals)
      for (const Vec2 corner : goal.area) CHECK(outside_distance(floor, corner) < 1e-9);
  }
}

TEST_CASE("the thesis's scenes have the published numbers of people") {
  const auto people = [](std::string_view name) { return people_asked(scene_of(name).crowd); };
  CHECK(people("sparse-passing") == 1600);
  CHECK(people("dense-passing") == 1600);
  CHECK(people("dense-passing-10k") == 10032);
  CHECK(people("bears-and-rabbits") == 1152);
  CHECK(people("dense-ellipsoid") == 1920);
  CHECK(people("proximal") == 100);
  CHECK(people("target-locomotion") == 192);
  CHECK(people("power-law-sparse") == 1344);
  CHECK(people("power-law-dense") == 1344);
  for (const int count : {480, 3600, 100048}) {
    CHECK(people("bottleneck-" + std::to_string(count)) == count);
    CHECK(people("peers-bottleneck-" + std::to_string(count)) == count);
  }
  for (const int count : {1600, 10032, 100000}) CHECK(people("peers-passing-" + std::to_string(count)) == count);
  CHECK(people("peers-crush") == 100048);
}

TEST_CASE("the peers' people start walking and the thesis's at rest") {
  for (const CrowdScene& crowd : crowd_scenes()) {
    CAPTURE(crowd.name);
    const Scene scene = crowd.build();
    for (const Population& people : scene.crowd.populations) CHECK(people.walking == crowd.name.starts_with("peers-"));
  }
}

TEST_CASE("the peers' rows stand where the others' stood") {
  const Scene jam = scene_of("peers-bottleneck-3600");
  // Cell centres: the front row is 5 m before the wall, a block of 60 rows lies about the corridor's middle.
  const Bounds block = bounds(jam.crowd.populations[0].area);
  CHECK(block.max.x - 0.75 == doctest::Approx(-5));
  CHECK(block.center().y == doctest::Approx(0));
  CHECK(bounds(jam.crowd.goals[0].aim).min.x == 0.5);
  CHECK(bounds(jam.crowd.goals[0].aim).max.y == doctest::Approx(12 / 2.0 - 0.75));
  const Scene passing = scene_of("peers-passing-1600");
  const Bounds west = bounds(passing.crowd.populations[0].area), east = bounds(passing.crowd.populations[1].area);
  CHECK(east.min.x + 1.5 - (west.max.x - 1.5) == doctest::Approx(6));
}

TEST_CASE("the experiments let in as many people as were recorded, in the recorded time") {
  for (const CrowdScene& crowd : crowd_scenes()) {
    const Scene scene = crowd.build();
    for (const Source& source : scene.crowd.sources) {
      CAPTURE(crowd.name);
      const double last = source.from + (*source.count - 1) / source.rate;
      CHECK(last < scene.crowd.seconds);
      CHECK(last > 40);  // every recording lets people in for 43 s or more
    }
  }
  CHECK(people_asked(scene_of("experiment-corner").crowd) == 137);
  CHECK(people_asked(scene_of("experiment-t-junction").crowd) == 134);
  CHECK(people_asked(scene_of("experiment-bidirectional-090").crowd) == 214);
  for (const int count : {4, 14, 20, 30}) CHECK(people_asked(experiment_single_file(count).crowd) == count);
}
