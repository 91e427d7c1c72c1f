#include "io/formats/scene_json.h"

#include <doctest/doctest.h>

#include "core/test_data.h"
#include "io/scene_examples.h"

using namespace inhabit::io;
using namespace inhabit::scene;

namespace {

/// The error of a scene that holds `rest` beside a room of 5 by 4 metres.
std::string error_of(const std::string& rest) {
  const auto scene = read_scene(R"({"space": {"outline": [[0, 0], [5, 0], [5, 4], [0, 4]]}, )" + rest + "}");
  return scene ? "" : scene.error().text();
}
std::string space_error(const std::string& rest) {
  const auto scene = read_scene(R"({"space": {"outline": [[0, 0], [5, 0], [5, 4], [0, 4]], )" + rest + "}}");
  return scene ? "" : scene.error().text();
}
std::string constraint_error(const std::string& constraint) {
  return error_of(
      R"("objects": [{"id": "lamp"}, {"id": "chair"}], "groups": [{"id": "both", "members": ["lamp", "chair"]}],
                     "constraints": [)" +
      constraint + "]");
}

}  // namespace

TEST_CASE("the document of the manual is read and writing it is stable") {
  const auto scene = read_scene(kFullScene);
  REQUIRE_MESSAGE(scene.ok(), scene.error().text());
  CHECK(scene->objects.size() == 6);
  CHECK(scene->objects[0].angle == doctest::Approx(kPi / 2));
  CHECK(scene->id_of(scene->groups[0].members[1]) == "chair-1");
}

TEST_CASE("reading what was written gives the same scene and the same bytes") {
  const auto scene = read_scene(kFullScene);
  REQUIRE(scene.ok());
  const std::string text = write_scene(*scene);
  const auto again = read_scene(text);
  REQUIRE_MESSAGE(again.ok(), again.error().text());
  CHECK(*again == *scene);
  CHECK(write_scene(*again) == text);
  CHECK(text.find("1.50e2") != std::string::npos);  // the user's own members keep their digits
  CHECK(text.find("12345678901234567890123") != std::string::npos);
  CHECK(text.find("\"angle\": 60.123456789}") != std::string::npos);
  CHECK(text.find("\"outline\": [[0, 0], [4.6, 0], [4.6, 3.4], [0, 3.4]]") != std::string::npos);
}

TEST_CASE("what equals a default is not written") {
  Scene scene;
  scene.space.outline = {{0, 0}, {1, 0}, {0, 1}};
  CHECK(write_scene(scene) ==
        "{\n  \"format\": \"inhabit-scene\",\n  \"version\": 1,\n  \"space\": {\"outline\": [[0, 0], [1, 0], [0, "
        "1]]}\n}\n");
}

TEST_CASE("a clockwise outline is turned round and doors and windows stay where they were") {
  const auto scene = read_scene(R"({"space": {"outline": [[0, 0], [0, 4], [5, 4], [5, 0]],
    "doors": [{"id": "d", "wall": 0, "from": 0.5, "width": 1, "hinge": "start"}],
    "windows": [{"id": "w", "wall": 3, "from": 1, "width": 2}]},
    "objects": [{"id": "a"}], "constraints": [{"type": "wall_distance", "members": ["a"], "wall": 1}]})");
  REQUIRE_MESSAGE(scene.ok(), scene.error().text());
  const Space& s = scene->space;
  CHECK(s.outline == Ring{{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  // The door ran from (0, 0.5) to (0, 1.5) with its hinge at (0, 0.5).
  CHECK(s.doors[0].wall == 3);
  CHECK(s.doors[0].from == 2.5);
  CHECK(s.doors[0].hinge == Door::Hinge::end);
  // The window ran from (4, 0) to (2, 0).
  CHECK(s.windows[0].wall == 0);
  CHECK(s.windows[0].from == 2);
  CHECK(*scene->constraints.of<WallDistance>()[0].wall == 2);
}

TEST_CASE("a door beyond its wall is refused by the document's own numbers, whichever way the outline runs") {
  const std::string doors = R"("doors": [{"id": "d", "wall": 0, "from": 10.5}])";
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [0, 4], [5, 4], [5, 0]], )" + doors + "}}").error().text() ==
        "/space/doors/0: from 10.5 m, 0.9 m wide, it ends beyond wall 0, which is 4 m long");
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [5, 0], [5, 4], [0, 4]], )" + doors + "}}").error().text() ==
        "/space/doors/0: from 10.5 m, 0.9 m wide, it ends beyond wall 0, which is 5 m long");
}

TEST_CASE("every error says where and what") {
  CHECK(error_of(R"("objects": [{"id": "a", "angle": 900}])") ==
        "/objects/0/angle: 900 is outside [-360, 360] degrees");
  CHECK(error_of(R"("objects": [{"id": "a", "positon": [0, 0, 0]}])") ==
        "/objects/0/positon: unknown key; did you mean \"position\"?");
  CHECK(error_of(R"("objects": [{"kind": "a"}])") == "/objects/0: \"id\" is missing");
  CHECK(error_of(R"("objects": [{"id": ""}])") == "/objects/0/id: is empty");
  CHECK(error_of(R"("objects": [{"id": "a", "size": [1, -1, 1]}])") ==
        "/objects/0/size/1: -1 is outside [0.0001, 10000] m");
  CHECK(error_of(R"("objects": [{"id": "a", "size": [1, 1]}])") == "/objects/0/size: has 2 numbers instead of 3");
  CHECK(error_of(R"("objects": [{"id": "a", "position": [2e6, 1, 0]}])") ==
        "/objects/0/position/0: 2e6 is outside [-1000000, 1000000] m");
  CHECK(error_of(R"("objects": [{"id": "a"}, {"id": "a"}])") ==
        "/objects/1/id: \"a\" is the id of something else before it");
  CHECK(error_of(R"("objects": [{"id": "a"}], "groups": [{"id": "a", "members": ["a"]}])") ==
        "/groups/0/id: \"a\" is the id of something else before it");
  CHECK(error_of(R"("objects": [{"id": "a", "fixed": true}])") == "/objects/0: \"a\" is fixed but has no position");
  CHECK(error_of(R"("objects": [{"id": "a", "on": "b"}, {"id": "b", "on": "a"}])")
            .ends_with("stands, through others, on itself"));
  CHECK(error_of(R"("objects": [{"id": "a", "size": [6.5, 0.1, 1]}])") ==
        "/objects/0/size: \"a\" is larger than the room in every orientation");
  CHECK(error_of(R"("objects": [{"id": "a", "size": [6.0, 0.1, 1]}])").empty());  // fits along the diagonal
  CHECK(error_of(R"("objects": [{"id": "a", "mount": "flor"}])") ==
        "/objects/0/mount: \"flor\" is none of: floor, wall, ceiling; did you mean \"floor\"?");
  CHECK(error_of(R"("objects": {})") == "/objects: is an object where a list belongs");
  CHECK(error_of(R"("groups": [{"id": "g", "members": ["h"]}, {"id": "h", "members": ["g"]}])")
            .ends_with("contains itself"));
  CHECK(error_of(
            R"("objects": [{"id": "a"}], "groups": [{"id": "g", "members": ["a"]}, {"id": "h", "members": ["a"]}])") ==
        "/groups/1/members/0: \"a\" is in group \"g\" already");
  CHECK(error_of(R"("objects": [{"id": "a"}], "groups": [{"id": "g", "members": ["a"], "curve": {}}])") ==
        "/groups/0/curve: a curve is either an arc or a segment");
  CHECK(error_of(R"("crowd": {"populations": [{"count": -1, "area": [[0, 0], [1, 0], [0, 1]]}]})") ==
        "/crowd/populations/0/count: -1 is outside [0, 10000000]");
  CHECK(error_of(R"("crowd": {"sources": [{"goal": "est", "area": [[0, 0], [1, 0], [0, 1]]}],
                              "goals": [{"id": "east", "area": [[0, 0], [1, 0], [0, 1]]}]})") ==
        "/crowd/sources/0/goal: no goal is called \"est\"; did you mean \"east\"?");
  CHECK(error_of(R"("seed": -1)") == "/seed: is no whole number from 0 to 18446744073709551615");
  CHECK(error_of(R"("seed": 18446744073709551616)") == "/seed: is no whole number from 0 to 18446744073709551615");
  CHECK(error_of(R"("version": 2)") == "/version: written by a newer inhabit; this one reads version 1");
  CHECK(error_of(R"("format": "scene")") == "/format: is not \"inhabit-scene\"");
  CHECK(read_scene("{}").error().text() == "\"space\" is missing");
  CHECK(read_scene("[]").error().text() == "a scene is an object, this is a list");
}

namespace {

constexpr const char* kGoals = R"("goals": [{"id": "east", "area": [[0, 0], [1, 0], [0, 1]]}])";
/// The error of a crowd with two goals and `rest`.
std::string crowd_error(const std::string& rest) {
  const std::string error = error_of(R"("crowd": {)" + rest + ", " + kGoals + "}");
  return error.starts_with("/crowd") ? error.substr(6) : error;
}
std::string goal_error(const std::string& rest) {
  const std::string error = error_of(R"("crowd": {"goals": [{"id": "g", )" + rest + "}]}");
  return error.starts_with("/crowd/goals/0") ? error.substr(14) : error;
}
const std::string kPopulation = R"("populations": [{"area": [[0, 0], [1, 0], [0, 1]], )";
const std::string kSource = R"("sources": [{"area": [[0, 0], [1, 0], [0, 1]], )";

}  // namespace

TEST_CASE("errors of people say where and what") {
  CHECK(crowd_error(kPopulation + R"("radius": 0.3}])") == "/populations/0: needs one of: count, spacing");
  CHECK(crowd_error(kPopulation + R"("spacing": 1}])") == "");
  CHECK(crowd_error(kPopulation + R"("count": 2, "jitter": 1}])") ==
        "/populations/0/jitter: means nothing without \"spacing\"");
  CHECK(crowd_error(kPopulation + R"("count": 2, "radius": [0.3, 0.2]}])") ==
        "/populations/0/radius: begins with the larger number");
  CHECK(crowd_error(kPopulation + R"("count": 2, "radius": [0.3, -1]}])") ==
        "/populations/0/radius/1: -1 is outside [0.01, 100] m");
  CHECK(crowd_error(kPopulation + R"("count": 2, "radius": "0.3"}])") ==
        "/populations/0/radius: is neither a number nor [low, high]");
  CHECK(crowd_error(kPopulation + R"("count": 2, "speed": {"deviation": -1}}])") ==
        "/populations/0/speed/deviation: -1 is outside [0, 100] m/s");
  CHECK(crowd_error(kSource + R"("rate": -2}])") == "/sources/0/rate: -2 is outside [0, 1000000] 1/s");
  CHECK(crowd_error(kSource + R"("from": 9, "until": 3}])") == "/sources/0/until: 3 s is before from, 9 s");
  CHECK(crowd_error(kSource + R"("goal": ["east", ["east", "wets"]]}])") ==
        "/sources/0/goal/1/1: no goal is called \"wets\"");
  CHECK(crowd_error(kSource + R"("goal": [[]]}])") == "/sources/0/goal/0: names no goal");
  CHECK(crowd_error(kSource + R"("goal": []}])") == "/sources/0/goal: names no goal");
  CHECK(crowd_error(kSource + R"("goal": 3}])") == "/sources/0/goal: is neither a goal's id nor a list of them");
  CHECK(crowd_error(R"("step": 2)") == "/step: 2 is outside [0.0001, 1] s");
  CHECK(crowd_error(R"("seconds": 0)") == "/seconds: 0 is outside [0.001, 10000000] s");
  CHECK(crowd_error(R"("planner": "feld")") ==
        "/planner: \"feld\" is none of: automatic, straight, paths, field; did you mean \"field\"?");
  CHECK(goal_error(R"("wait": 1)") == ": needs exactly one of: area, direction, offset");
  CHECK(goal_error(R"("offset": [1, 2], "direction": 90)") == ": needs exactly one of: area, direction, offset");
  CHECK(goal_error(R"("direction": 90, "aim": [[0, 0], [1, 0], [0, 1]])") == "/aim: means nothing without \"area\"");
  CHECK(goal_error(R"("direction": 90, "jitter": 1)") == "/jitter: means nothing without \"offset\"");
  CHECK(goal_error(R"("direction": 90)") == "");
}

TEST_CASE("errors of a crowd model say where and what") {
  CHECK(crowd_error(R"("model": {"type": "orka"})") == "/model/type: unknown model \"orka\"; did you mean \"orca\"?");
  CHECK(crowd_error(R"("model": {"preset": "game"})") == "/model: \"type\" is missing");
  CHECK(crowd_error(R"("model": {"type": "pbd", "preset": "games"})") ==
        "/model/preset: \"games\" is none of: game, pedestrian; did you mean \"game\"?");
  CHECK(crowd_error(R"("model": {"type": "orca", "horizont": 1})") ==
        "/model/horizont: unknown key; did you mean \"horizon\"?");
  CHECK(crowd_error(R"("model": {"type": "social-force", "sub_steps": 0})") ==
        "/model/sub_steps: 0 is outside [1, 1000]");
  CHECK(crowd_error(R"("model": {"type": "power-law", "strength": 2})") == "");
}

TEST_CASE("a preset gives the values that a model does not say and is written with what differs") {
  const auto read = [](const std::string& model) {
    const auto scene = read_scene(R"({"space": {"outline": [[0, 0], [5, 0], [5, 4]]}, "crowd": {"seconds": 9)" +
                                  (model.empty() ? "" : R"(, "model": )" + model) + "}}");
    REQUIRE_MESSAGE(scene.ok(), scene.error().text());
    return *scene;
  };
  using enum PbdModel::Preset;
  for (const auto preset : {game, pedestrian}) {
    PbdModel wanted = PbdModel::of_preset(preset);
    const std::string name = preset == game ? "game" : "pedestrian";
    CHECK(read(R"({"type": "pbd", "preset": ")" + name + "\"}").crowd.model == CrowdModel(wanted));
    wanted.iterations = 17;
    const Scene scene = read(R"({"type": "pbd", "preset": ")" + name + R"(", "iterations": 17})");
    CHECK(scene.crowd.model == CrowdModel(wanted));
    const std::string text = write_scene(scene);
    CHECK((preset == pedestrian ||
           text.find(R"({"type": "pbd", "preset": ")" + name + R"(", "iterations": 17})") != std::string::npos));
    CHECK(*read_scene(text) == scene);
  }
  CHECK(read(R"({"type": "pbd"})").crowd.model == Crowd{}.model);
  CHECK(read("").crowd.model == Crowd{}.model);
  CHECK(write_scene(read("")).find("model") == std::string::npos);
}

TEST_CASE("a radius is a number or a span and a goal is a route") {
  const auto scene = read_scene(kFullScene);
  REQUIRE(scene.ok());
  const Crowd& crowd = scene->crowd;
  CHECK(crowd.populations[0].radius == Span{0.5, 0.75});
  CHECK(crowd.sources[0].radius == Span{0.2, 0.2});
  CHECK(crowd.populations[0].goal.legs == std::vector<std::vector<std::string>>{{"east"}});
  CHECK(crowd.populations[1].goal.legs == std::vector<std::vector<std::string>>{{"shop"}, {"east", "shop"}, {"away"}});
  CHECK(*crowd.goals[2].direction == doctest::Approx(kPi / 2));
  const std::string text = write_scene(*scene);
  CHECK(text.find(R"("goal": ["shop", ["east", "shop"], "away"])") != std::string::npos);
  CHECK(text.find(R"("goal": "east")") != std::string::npos);
  CHECK(text.find(R"("radius": [0.5, 0.75])") != std::string::npos);
  CHECK(text.find(R"("radius": 0.2)") != std::string::npos);
}

TEST_CASE("errors of the space say where and what") {
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [1, 1], [1, 0], [0, 1]]}})")
            .error()
            .text()
            .starts_with("/space/outline: the outline touches or crosses itself near (0.5"));
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [1, 1]]}})").error().where == "/space/outline");
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [1, 1], [2, 2]]}})").error().where == "/space/outline");
  CHECK(space_error(R"("holes": [{"outline": [[6, 1], [7, 1], [7, 2]]}])") ==
        "/space/holes/0/outline: the hole lies outside the outline");
  CHECK(space_error(R"("holes": [{"outline": [[4, 1], [7, 1], [7, 2]]}])") ==
        "/space/holes/0/outline: the hole crosses the outline");
  CHECK(space_error(R"("holes": [{"outline": [[0, 1], [1, 1], [1, 2], [0, 2]]}])").empty());  // a pillar at a wall
  CHECK(space_error(R"("doors": [{"id": "d", "wall": 0, "from": 4.5, "width": 0.9}])") ==
        "/space/doors/0: from 4.5 m, 0.9 m wide, it ends beyond wall 0, which is 5 m long");
  CHECK(space_error(R"("doors": [{"id": "d", "wall": 4, "from": 0}])") ==
        "/space/doors/0/wall: there is no wall 4, the outline has walls 0 to 3");
  CHECK(space_error(R"("windows": [{"wall": 1.5, "from": 0}])") == "/space/windows/0/wall: 1.5 is no whole number");
}

TEST_CASE("errors of constraints say where and what") {
  CHECK(constraint_error(R"({"type": "distence", "between": ["lamp", "chair"]})") ==
        "/constraints/0/type: unknown constraint \"distence\"; did you mean \"distance\"?");
  CHECK(constraint_error(R"({"between": ["lamp", "chair"]})") == "/constraints/0: \"type\" is missing");
  CHECK(constraint_error(R"({"type": "distance", "between": ["lamp", "chiar"], "min": 1})") ==
        "/constraints/0/between/1: no object, group or door is called \"chiar\"; did you mean \"chair\"?");
  CHECK(constraint_error(R"({"type": "distance", "between": ["lamp", "lamp"], "min": 1})") ==
        "/constraints/0/between: names the same thing twice");
  CHECK(constraint_error(R"({"type": "distance", "between": ["lamp", "chair"]})") ==
        "/constraints/0: needs one of: distance, min, max");
  CHECK(constraint_error(R"({"type": "distance", "between": ["lamp", "chair"], "min": 2, "max": 1})") ==
        "/constraints/0/min: 2 is more than max, 1");
  CHECK(constraint_error(R"({"type": "align", "members": "lamp"})") ==
        "/constraints/0/members: \"lamp\" is no group; a list of ids names objects");
  CHECK(constraint_error(R"({"type": "align", "members": []})") == "/constraints/0/members: names nobody");
  CHECK(constraint_error(R"({"type": "align", "members": "both"})").empty());
  CHECK(constraint_error(R"({"type": "wall_distance", "members": "both", "wall": 9})") ==
        "/constraints/0/wall: there is no wall 9, the outline has walls 0 to 3");
  CHECK(constraint_error(R"({"type": "align", "members": "both", "stiffness": 2})") ==
        "/constraints/0/stiffness: 2 is outside [0, 1]");
}

TEST_CASE("hostile documents are refused with a place") {
  CHECK(read_scene("{\n  \"space\": }").error().where == "line 2, column 12");
  CHECK(read_scene("").error().where == "line 1, column 1");
  CHECK(read_scene(R"({"space": {"outline": [[0, 0], [1e400, 0], [0, 1]]}})").error().message.find("overflow") !=
        std::string::npos);
  CHECK_FALSE(read_scene(R"({"space": {"outline": [[0, 0], [NaN, 0], [0, 1]]}})").ok());
  CHECK(read_scene(R"({"space": {}, "a/b": {"c": 1, "d": 2, "c": 3}})").error().text() ==
        "/a~1b/c: the key \"c\" appears twice in one object");
  CHECK(read_scene(std::string(100000, '[')).error().message == "nested deeper than 64 levels");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"x-a\":";
  CHECK(read_scene(deep).error().message == "nested deeper than 64 levels");
  CHECK(read_scene("{\"name\": \"\xff\"}").error().message.find("UTF-8") != std::string::npos);
  CHECK(read_scene(std::string("{}\0{}", 5)).error().text() == "line 1, column 3: a zero byte");
  for (std::size_t size = 0; size < kFullScene.size(); size += 7)
    CHECK_FALSE(read_scene(kFullScene.substr(0, size)).ok());
}

TEST_CASE("a hundred thousand objects come back as they were, in so many bytes each") {
  constexpr int kObjects = inhabit::core::kSlowBuild ? 10000 : 100000;
  Scene scene;
  scene.space.outline = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  for (int i = 0; i < kObjects; ++i) {
    Object o;
    o.id = "object-" + std::to_string(i);
    o.kind = "chair", o.size = {0.45, 0.5, 0.9};
    o.position = Vec3{i % 1000 + 0.123456, i / 1000 + 0.654321, 0};
    o.angle = radians(i % 360), o.clearance.front = 0.4;
    scene.objects.push_back(std::move(o));
  }
  const std::string text = write_scene(scene);
  const auto again = read_scene(text);
  REQUIRE(again.ok());
  CHECK(*again == scene);
  // Some 195 bytes each as they are laid out, and no more because there are many.
  CHECK(text.size() < 210 * scene.objects.size());
}
