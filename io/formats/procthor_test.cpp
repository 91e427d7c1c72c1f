#include "io/formats/procthor.h"

#include <doctest/doctest.h>

#include "core/test_data.h"
#include "io/file.h"
#include "io/format_table.h"
#include "io/formats/scene_json.h"

using namespace inhabit::io;
using namespace inhabit::scene;

namespace {

constexpr std::string_view kHouse = R"({"rooms": [{"id": "room|1", "roomType": "Bedroom", "floorPolygon":
    [{"x": 0, "y": 0, "z": 0}, {"x": 0, "y": 0, "z": 3}, {"x": 4, "y": 0, "z": 3}, {"x": 4, "y": 0, "z": 0}]}],
  "walls": [{"id": "w", "polygon": [{"x": 4, "y": 0, "z": 0}, {"x": 0, "y": 0, "z": 0}, {"x": 4, "y": 2.5, "z": 0}, {"x": 0, "y": 2.5, "z": 0}]}],
  "doors": [{"id": "door|1", "wall0": "w", "openable": true, "holePolygon": [{"x": 0.5, "y": 0, "z": 0}, {"x": 1.5, "y": 2, "z": 0}]}],
  "windows": [{"id": "window|1", "wall0": "w", "holePolygon": [{"x": 2, "y": 1, "z": 0}, {"x": 3, "y": 2, "z": 0}]}],
  "objects": [{"id": "a", "assetId": "Stand_1", "position": {"x": 0.25, "y": 0.4, "z": 1}, "rotation": {"x": 0, "y": 90, "z": 0},
    "children": [{"id": "b", "assetId": "Cup_1", "position": {"x": 0.25, "y": 0.85, "z": 1}, "rotation": {"x": 20, "y": 0, "z": 0}}]}]})";

Assets small_database() {
  return *read_procthor_assets(R"({"TVStand": [{"assetId": "Stand_1", "boundingBox": {"x": 1, "y": 0.8, "z": 0.5}}],
                                   "Cup": [{"assetId": "Cup_1", "boundingBox": {"x": 0.1, "y": 0.1, "z": 0}}]})");
}

}  // namespace

TEST_CASE("a house comes from Unity's axes into ours") {
  const auto scenes = read_procthor(kHouse, small_database());
  REQUIRE_MESSAGE(scenes.ok(), scenes.error().text());
  const Scene& s = (*scenes)[0];
  CHECK(s.name == "Bedroom");
  CHECK(s.space.outline == Ring{{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  CHECK(s.space.height == 2.5);
  CHECK(s.space.doors == std::vector{Door{"door|1", 0, 2.5, 1, 2}});  // measured from the wall's first corner at x = 4
  CHECK(s.space.windows == std::vector{Window{"window|1", 0, 1, 1, 1, 1}});
  REQUIRE(s.objects.size() == 2);
  CHECK(s.objects[0].kind == "tv_stand");
  CHECK(s.objects[0].size == Vec3{1, 0.5, 0.8});
  CHECK(s.objects[0].position == Vec3{0.25, 1, 0});
  CHECK(s.objects[0].angle == 0);  // its back at the wall x = 0, it looks along +x
  CHECK(s.objects[1].on == Ref{Ref::Kind::object, 0});
  CHECK(s.objects[1].angle == doctest::Approx(kPi / 2));
  CHECK(s.objects[1].extras.back().second == "[20, 0]");
}

TEST_CASE("a house that does not hold together is refused with its place") {
  const Assets assets = small_database();
  const auto error_with = [&](std::string_view from, std::string_view to) {
    std::string house(kHouse);
    house.replace(house.find(from), from.size(), to);
    return read_procthor(house, assets).error().text();
  };
  CHECK(error_with("\"assetId\": \"Cup_1\"", "\"assetId\": \"Cup_2\"") ==
        "/objects/0/children/0: the asset database does not know \"Cup_2\"");
  CHECK(error_with("\"wall0\": \"w\"", "\"wall0\": \"v\"") == "/doors/0: there is no wall \"v\"");
  CHECK(error_with("{\"x\": 0, \"y\": 0, \"z\": 3}", "{\"x\": 0, \"y\": 0}") ==
        "/rooms/0/floorPolygon/1: \"z\" is no number");
  CHECK(error_with("\"rooms\"", "\"rums\"") == "there are no rooms in it");
  CHECK(error_with("\"x\": 0.25", "\"x\": 1e9") == "/objects/0/position/x: 1e9 is outside [-100000, 100000]");
  CHECK(read_procthor_assets(R"({"Cup": [{"assetId": "a", "boundingBox": {"x": 1}}]})").error().where ==
        "/Cup/0/boundingBox");
}

TEST_CASE("a line of many houses is picked by its number") {
  std::string line(kHouse);
  std::erase(line, '\n');
  const std::string many = line + "\n\n" + line + "\n";
  CHECK(read_procthor(many, small_database())->size() == 2);
  CHECK(read_procthor(many, small_database(), 3)->size() == 1);
  CHECK(read_procthor(many, small_database(), 9).error().text() == "there is no line 9 in it");
  CHECK(read_procthor(line + "\n{\"rooms\": 1}\n", small_database()).error().where == "line 2");
}

TEST_CASE("all five hundred houses are read and survive as scene documents") {
  const auto houses = INHABIT_TEST_DATA("rooms/procthor_one_room/train.jsonl.gz");
  const auto database = INHABIT_TEST_DATA("rooms/procthor_db/asset-database.json");
  if (!houses || !database) return;
  const auto content = read_any(*houses, {.asset_database = *database, .line = 0});
  REQUIRE_MESSAGE(content.ok(), content.error().text());
  const auto* const scenes = &content->scenes;
  CHECK(scenes->size() == 500);
  std::size_t objects = 0, doors = 0, windows = 0, at_wall = 0, pieces = 0;
  for (const Scene& scene : *scenes) {
    objects += scene.objects.size(), doors += scene.space.doors.size(), windows += scene.space.windows.size();
    for (const Object& o : scene.objects) {
      if (o.kind != "bed" && o.kind != "dresser" && o.kind != "fridge") continue;
      const Vec2 back = o.position->xy() - (o.size.y / 2) * direction(*o.angle);
      ++pieces, at_wall += nearest_on_ring(scene.space.outline, back).distance < 0.15;
    }
    const auto again = read_scene(write_scene(scene));
    REQUIRE_MESSAGE(again.ok(), again.error().text());
    CHECK(*again == scene);
  }
  MESSAGE(objects, " objects, ", doors, " doors, ", windows, " windows; ", at_wall, " of ", pieces,
          " backs at the wall");
  CHECK(objects >= 4715);
  CHECK(doors == 500);
  CHECK(windows == 642);
  CHECK(at_wall == pieces);
}
