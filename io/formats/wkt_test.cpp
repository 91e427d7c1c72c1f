#include "io/formats/wkt.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "core/test_data.h"
#include "io/file.h"
#include "io/formats/scene_json.h"

using namespace inhabit::io;
using namespace inhabit::scene;

TEST_CASE("a polygon with a hole becomes a space corner for corner") {
  const auto scenes = read_wkt("POLYGON ((0 0, 0 4, 2 4, 5 4, 5 0, 0 0), (1 1, 2 1, 2 2, 1 1))");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  REQUIRE(scenes->size() == 1);
  CHECK((*scenes)[0].space.outline == Ring{{0, 0}, {5, 0}, {5, 4}, {2, 4}, {0, 4}});
  CHECK((*scenes)[0].space.holes[0].outline == Ring{{1, 1}, {2, 1}, {2, 2}});
  CHECK((*scenes)[0].extras.empty());
}

TEST_CASE("collections give a scene per polygon and name what is no area") {
  const auto scenes = read_wkt(
      "SRID=25832;GEOMETRYCOLLECTION(MULTIPOLYGON Z(((0 0 1,1 0 1,0 1 1,0 0 1)),((5 5 1,6 5 1,5 6 1,5 5 1))),POINT(1 "
      "2),"
      "LINESTRING EMPTY,GEOMETRYCOLLECTION(polygon((9 9,10 9,9 10,9 9))),POLYGON EMPTY)");
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  CHECK(scenes->size() == 3);
  CHECK((*scenes)[0].extras == Extras{{"x-dropped", R"(["POINT", "LINESTRING"])"}});
}

TEST_CASE("a plan in a national grid is moved to the origin by whole metres") {
  const auto scenes =
      read_wkt("POLYGON((395131.5 5268347.25, 395141.5 5268347.25, 395141.5 5268357.25, 395131.5 5268347.25))");
  REQUIRE(scenes.ok());
  CHECK((*scenes)[0].space.outline == Ring{{0.5, 0.25}, {10.5, 0.25}, {10.5, 10.25}});
  CHECK((*scenes)[0].extras == Extras{{"x-origin", "[395131, 5268347]"}});
}

TEST_CASE("an outline that crosses itself is repaired and says so") {
  const auto scenes = read_wkt("POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))");
  REQUIRE(scenes.ok());
  CHECK(scenes->size() == 2);
  CHECK((*scenes)[0].extras[0].first == "x-repaired");
}

TEST_CASE("malformed text is refused with line and column") {
  CHECK(read_wkt("").error().text() ==
        "line 1, column 1: a geometry belongs here, such as POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))");
  CHECK(read_wkt("POLIGON((0 0))").error().text() == "line 1, column 1: unknown geometry; did you mean \"POLYGON\"?");
  CHECK(read_wkt("POLYGON((0 0,\n 1 a").error().text() == "line 2, column 4: a number belongs here");
  CHECK(read_wkt("POLYGON((0 0, 1 0, 0 1, 0 0)").error().message == "\")\" is missing");
  CHECK(read_wkt("POLYGON((0 0, 1 0, 0 1))").error().message ==
        "a ring has four corners or more and ends where it starts");
  CHECK_FALSE(read_wkt("POLYGON((0 0, nan 0, 0 1, 0 0))").ok());
  CHECK_FALSE(read_wkt("POLYGON((0 0, 1e400 0, 0 1, 0 0))").ok());
  CHECK_FALSE(read_wkt("POLYGON((0 0, 1e300 0, 0 1, 0 0))").ok());
  CHECK_FALSE(read_wkt("POLYGON((0 0, 1 1, 2 2, 0 0))").ok());
  CHECK_FALSE(read_wkt("POINT(1 2)").ok());
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "GEOMETRYCOLLECTION(";
  CHECK(read_wkt(deep).error().message == "nested deeper than 32 levels");
}

TEST_CASE("every walkable area of real buildings is read and survives as a scene document") {
  const auto folder = INHABIT_TEST_DATA("floorplans/jupedsim_wkt");
  if (!folder) return;
  int plans = 0, repaired = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder)) {
    if (entry.path().extension() != ".wkt") continue;
    ++plans;
    const auto text = read_file(entry.path());
    REQUIRE(text.ok());
    const auto scenes = read_wkt(*text);
    REQUIRE_MESSAGE(scenes.ok(), entry.path().filename().string(), ": ", scenes.error().text());
    for (const Scene& scene : *scenes) {
      for (const auto& extra : scene.extras) repaired += extra.first == "x-repaired";
      const auto again = read_scene(write_scene(scene));
      REQUIRE_MESSAGE(again.ok(), entry.path().filename().string(), ": ", again.error().text());
      CHECK(*again == scene);
    }
  }
  MESSAGE(plans, " plans, ", repaired, " scenes from repaired polygons");
  CHECK(plans == 18);
}
