#include "io/formats/geojson.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "core/test_data.h"
#include "io/file.h"
#include "io/formats/scene_json.h"

using namespace inhabit::io;
using namespace inhabit::scene;

TEST_CASE("a bare polygon in metres becomes a space") {
  const auto scenes =
      read_geojson(R"({"type": "Polygon", "coordinates": [[[0, 0], [500, 0], [500, 4], [0, 4], [0, 0]]]})");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  CHECK((*scenes)[0].space.outline == Ring{{0, 0}, {500, 0}, {500, 4}, {0, 4}});
}

TEST_CASE("longitude and latitude are projected to metres about the middle") {
  // At 56.46 degrees north an arc second is 30.93 m along the meridian and 17.12 m along the parallel (GRS80 radii).
  const auto scenes =
      read_geojson(R"({"type": "Feature", "properties": {"name": "hall"}, "geometry": {"type": "Polygon",
      "coordinates": [[[-2.978, 56.46], [-2.977722222222222, 56.46], [-2.977722222222222, 56.460277777777778], [-2.978, 56.460277777777778], [-2.978, 56.46]]]}})");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  const Scene& scene = (*scenes)[0];
  CHECK(scene.name == "hall");
  const Vec2 size = bounds(scene.space.outline).size();
  CHECK(size.x == doctest::Approx(17.12).epsilon(1e-3));
  CHECK(size.y == doctest::Approx(30.93).epsilon(1e-3));
  CHECK(scene.extras[0].first == "x-origin");
}

TEST_CASE("doors and windows of an indoor map belong to the rooms that they touch") {
  const auto scenes =
      read_geojson(R"({"type": "FeatureCollection", "crs": {"properties": {"name": "local"}}, "features": [
    {"type": "Feature", "properties": {"type": "room", "name": "A"}, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]}},
    {"type": "Feature", "properties": {"type": "room", "name": "B"}, "geometry": {"type": "Polygon", "coordinates": [[[4.2, 0], [8, 0], [8, 3], [4.2, 3], [4.2, 0]]]}},
    {"type": "Feature", "properties": {"type": "door"}, "geometry": {"type": "Polygon", "coordinates": [[[4, 1], [4.2, 1], [4.2, 2], [4, 2], [4, 1]]]}},
    {"type": "Feature", "properties": {"type": "window"}, "geometry": {"type": "Polygon", "coordinates": [[[1, 3], [2, 3], [2, 3.1], [1, 3.1], [1, 3]]]}},
    {"type": "Feature", "properties": {"type": "pathway"}, "geometry": {"type": "LineString", "coordinates": [[1, 1], [2, 2]]}}]})");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  REQUIRE(scenes->size() == 2);
  const Space &a = (*scenes)[0].space, &b = (*scenes)[1].space;
  CHECK(a.doors == std::vector{Door{"door-1", 1, 1, 1}});
  CHECK(b.doors == std::vector{Door{"door-1", 3, 1, 1}});
  CHECK(a.windows == std::vector{Window{"window-1", 2, 2, 1}});
  CHECK(b.windows.empty());
}

TEST_CASE("rooms that nobody drew are what the walls leave of the building") {
  const auto scenes =
      read_geojson(R"({"type": "FeatureCollection", "crs": {"properties": {"name": "local"}}, "features": [
    {"type": "Feature", "properties": {"type": "building_outline"}, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 3], [0, 3], [0, 0]]]}},
    {"type": "Feature", "properties": {"type": "wall"}, "geometry": {"type": "Polygon", "coordinates": [[[4, 0], [4.2, 0], [4.2, 1], [4, 1], [4, 0]]]}},
    {"type": "Feature", "properties": {"type": "wall"}, "geometry": {"type": "Polygon", "coordinates": [[[4, 2], [4.2, 2], [4.2, 3], [4, 3], [4, 2]]]}},
    {"type": "Feature", "properties": {"type": "door"}, "geometry": {"type": "Polygon", "coordinates": [[[4, 0.9], [4.2, 0.9], [4.2, 2.1], [4, 2.1], [4, 0.9]]]}}]})");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  REQUIRE(scenes->size() == 2);
  CHECK(signed_area((*scenes)[0].space.outline) == doctest::Approx(12));
  CHECK((*scenes)[0].space.walls() == 4);
  CHECK((*scenes)[0].space.doors.size() == 1);
  CHECK((*scenes)[1].space.doors[0].width == doctest::Approx(1.2));
}

TEST_CASE("what is no GeoJSON is refused with its place") {
  CHECK(read_geojson("{}").error().text() == "\"type\" is missing");
  CHECK(read_geojson(R"({"type": "Polygn"})").error().text() ==
        "/type: unknown type \"Polygn\"; did you mean \"Polygon\"?");
  CHECK(read_geojson(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1]]]})").error().where ==
        "/coordinates/0");
  CHECK(read_geojson(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, "x"]]]})").error().where ==
        "/coordinates/0/1/1");
  CHECK(read_geojson(R"({"type": "Polygon", "coordinates": [[[0, 0], [1e300, 0], [0, 1], [0, 0]]]})").error().where ==
        "/coordinates/0/1/0");
  CHECK(read_geojson(R"({"type": "FeatureCollection", "features": []})").error().text() == "there is no polygon in it");
  CHECK_FALSE(read_geojson(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [2, 2], [0, 0]]]})").ok());
}

TEST_CASE("every floor of a real office building is read and survives as scene documents") {
  const auto folder = INHABIT_TEST_DATA("floorplans/wrld_westport_house");
  if (!folder) return;
  int floors = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".geojson") || name.ends_with("-paths.geojson")) continue;
    ++floors;
    const auto text = read_file(entry.path());
    REQUIRE(text.ok());
    const auto scenes = read_geojson(*text);
    REQUIRE_MESSAGE(scenes.ok(), name, ": ", scenes.error().text());
    std::size_t doors = 0, windows = 0, with_door = 0;
    double area = 0;
    for (const Scene& scene : *scenes) {
      doors += scene.space.doors.size(), windows += scene.space.windows.size(), with_door += !scene.space.doors.empty();
      area += signed_area(scene.space.outline);
      const auto again = read_scene(write_scene(scene));
      REQUIRE_MESSAGE(again.ok(), name, ": ", again.error().text());
      CHECK(*again == scene);
    }
    MESSAGE(name, ": ", scenes->size(), " rooms, ", with_door, " with a door, ", doors, " doors, ", windows,
            " windows, ", area, " square metres");
  }
  CHECK(floors == 8);
}
