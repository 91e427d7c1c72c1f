#include "io/formats/sweethome3d.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "core/rng.h"
#include "io/formats/sweethome3d_plan.h"

using namespace inhabit;
using namespace inhabit::io;

namespace {

std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The real homes, sorted; none where the data is absent.
std::vector<std::filesystem::path> home_files() {
  const char* elsewhere = std::getenv("INHABIT_DATA");
  const std::filesystem::path data = elsewhere != nullptr
                                         ? std::filesystem::path(elsewhere)
                                         : std::filesystem::path(INHABIT_SOURCE_DIR) / "../shared/data";
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(data / "rooms/sweethome3d", none)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) MESSAGE("skipped: no homes of Sweet Home 3D; set INHABIT_DATA");
  return files;
}

struct Seen {
  std::string name;
  geometry::Vec2 p;
  double angle = 0, elevation = 0;
};
void flatten(const std::vector<sh3d::Piece>& pieces, std::vector<Seen>& out) {
  for (const sh3d::Piece& p : pieces) {
    if (p.type != sh3d::Piece::Type::group) out.push_back({p.name, p.p, p.angle, p.elevation});
    flatten(p.children, out);
  }
}
std::vector<Seen> pieces_of(const std::string& xml) {
  std::vector<Seen> out;
  const auto plan = sh3d::read_plan(xml);
  REQUIRE(plan.ok());
  flatten(plan->pieces, out);
  return out;
}

const std::string kHome = R"(<?xml version='1.0'?>
<home version='6400' name='t' wallHeight='250'>
  <odd thing='kept &amp; unread'><inner/></odd>
  <pieceOfFurniture name='Bed' x='100' y='150' angle='0' width='90' depth='200' height='50' model='0/bed.obj' strange='1'/>
  <pieceOfFurniture name='Lamp' x='380' y='20' elevation='50' width='20' depth='20' height='30'/>
  <pieceOfFurniture name='Bedside table' x='380' y='20' width='40' depth='40' height='50'/>
  <furnitureGroup name='Dinner' x='300' y='200' angle='0'>
    <pieceOfFurniture name='Table' x='300' y='200' width='80' depth='80' height='75'/>
    <furnitureGroup name='Chairs'>
      <pieceOfFurniture name='Chair' x='300' y='260' angle='3.1415927' width='40' depth='40' height='90'/>
      <pieceOfFurniture name='Chair' x='300' y='140' width='40' depth='40' height='90' visible='false'/>
    </furnitureGroup>
  </furnitureGroup>
  <doorOrWindow name='Door' x='200' y='304' angle='3.1415927' width='90' depth='8' height='210' movable='false'>
    <sash xAxis='0' yAxis='0.5' width='1' startAngle='0' endAngle='-1.5707964'/>
  </doorOrWindow>
  <doorOrWindow name='Window' x='-4' y='150' angle='-1.5707964' width='120' depth='8' height='120' elevation='90'/>
  <wall id='w0' xStart='-4' yStart='-4' xEnd='404' yEnd='-4' thickness='8'/>
  <wall id='w1' xStart='404' yStart='-4' xEnd='404' yEnd='304' thickness='8'/>
  <wall id='w2' xStart='404' yStart='304' xEnd='-4' yEnd='304' thickness='8'/>
  <wall id='w3' xStart='-4' yStart='304' xEnd='-4' yEnd='-4' thickness='8'/>
  <room name='Den'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/><point x='0' y='300'/></room>
</home>
)";

const scene::Object& object(const scene::Scene& scene, const std::string& id) {
  const auto found =
      std::find_if(scene.objects.begin(), scene.objects.end(), [&](const auto& o) { return o.id == id; });
  REQUIRE_MESSAGE(found != scene.objects.end(), id);
  return *found;
}

}  // namespace

TEST_CASE("a home of one room becomes a scene in our frame") {
  const auto home = open_sh3d(kHome);
  REQUIRE_MESSAGE(home.ok(), home.error().text());
  const auto read = read_rooms(*home);
  REQUIRE(read.ok());
  REQUIRE(read->scenes.size() == 1);
  const scene::Scene& scene = read->scenes[0];
  CHECK(scene.name == "Den");
  CHECK(read->pieces == 8);
  CHECK(read->hidden.size() == 1);
  CHECK(read->outside.empty());
  CHECK(geometry::signed_area(scene.space.outline) == doctest::Approx(12));
  CHECK(scene.space.height == 2.5);
  const scene::Object& bed = object(scene, "bed-1");
  CHECK(bed.position->x == 1.0);
  CHECK(bed.position->y == -1.5);
  CHECK(bed.size == geometry::Vec3{0.9, 2.0, 0.5});
  // Angle 0 on the plan: the front faces down the screen.
  CHECK(*bed.angle == doctest::Approx(-kPi / 2));
}

TEST_CASE("the front of a piece is its plus depth side turned clockwise on the screen") {
  for (const double a : {0.0, 0.5, 1.5707964, 3.0, -2.0}) {
    const geometry::Vec2 plan_front{-std::sin(a), std::cos(a)};
    const geometry::Vec2 ours = geometry::direction(sh3d::turn_angle(a));
    CHECK(ours.x == doctest::Approx(plan_front.x));
    CHECK(ours.y == doctest::Approx(-plan_front.y));
    CHECK(std::abs(wrap_angle(sh3d::turn_angle(sh3d::turn_angle(a)) - a)) < 1e-12);
  }
}

TEST_CASE("doors know their wall and their swing and windows their sill") {
  const auto home = open_sh3d(kHome);
  const auto read = read_rooms(*home);
  const scene::Space& space = read->scenes[0].space;
  REQUIRE(space.doors.size() == 1);
  const scene::Door& door = space.doors[0];
  const geometry::Vec2 a = space.wall_start(static_cast<std::size_t>(door.wall)),
                       b = space.wall_end(static_cast<std::size_t>(door.wall));
  CHECK(a.y == doctest::Approx(-3));
  CHECK(b.y == doctest::Approx(-3));
  CHECK(door.from == doctest::Approx(1.55));
  CHECK(door.width == doctest::Approx(0.9));
  // Turned by half a turn, the front (where the leaf opens to) looks up the screen, into the room.
  CHECK(door.swing == scene::Door::Swing::in);
  const geometry::Vec2 hinge = door.hinge == scene::Door::Hinge::start
                                   ? a + door.from * geometry::unit(b - a)
                                   : a + (door.from + door.width) * geometry::unit(b - a);
  CHECK(hinge.x == doctest::Approx(2.45));
  REQUIRE(space.windows.size() == 1);
  CHECK(space.windows[0].sill == doctest::Approx(0.9));
  CHECK(space.windows[0].width == doctest::Approx(1.2));
}

TEST_CASE("things on others and groups in groups keep their relations") {
  const auto home = open_sh3d(kHome);
  const auto read = read_rooms(*home);
  const scene::Scene& scene = read->scenes[0];
  const auto lamp =
      std::find_if(scene.objects.begin(), scene.objects.end(), [](const auto& o) { return o.name == "Lamp"; });
  REQUIRE(lamp != scene.objects.end());
  CHECK(scene.id_of(lamp->on) == "bedside-table-1");
  REQUIRE(scene.groups.size() == 2);
  CHECK(scene.groups[0].id == "chairs-1");
  CHECK(scene.groups[1].id == "dinner-1");
  CHECK(scene.groups[1].rigid);
  REQUIRE(scene.groups[1].members.size() == 2);
  CHECK(scene.groups[1].members[1].kind == scene::Ref::Kind::group);
}

TEST_CASE("writing replaces what moved and keeps every other byte") {
  const auto home = open_sh3d(kHome);
  auto scenes = rooms(*home);
  REQUIRE(scenes.ok());
  for (scene::Object& o : (*scenes)[0].objects) {
    if (o.id == "bed-1") o.position->x += 0.25;
  }
  const auto file = write_sh3d(*home, *scenes);
  REQUIRE_MESSAGE(file.ok(), file.error().text());
  CHECK(file->moved == 1);
  std::string expected = kHome;
  expected.replace(expected.find("x='100'"), 7, "x='125'");
  CHECK(file->xml == expected);
  // The archive holds no model, and Sweet Home 3D would refuse the reference.
  CHECK(file->warnings.size() == 1);
  const auto again = open_sh3d(file->bytes);
  REQUIRE_MESSAGE(again.ok(), again.error().text());
  CHECK(again->xml.find("model=") == std::string::npos);
  CHECK(again->xml.find("strange='1'") != std::string::npos);
  CHECK(again->xml.find("<odd thing='kept &amp; unread'><inner/></odd>") != std::string::npos);
}

TEST_CASE("a group that was moved takes its invisible members along") {
  const auto home = open_sh3d(kHome);
  auto scenes = rooms(*home);
  for (scene::Object& o : (*scenes)[0].objects) {
    if (o.name != "Table" && o.name != "Chair") continue;
    // Half a turn about the table and one metre to the left.
    const geometry::Vec2 p{2 * 3.0 - o.position->x - 1, 2 * -2.0 - o.position->y};
    o.position = geometry::Vec3{p.x, p.y, 0};
    o.angle = wrap_angle(*o.angle + kPi);
  }
  const auto file = write_sh3d(*home, *scenes);
  REQUIRE(file.ok());
  const std::vector<Seen> now = pieces_of(file->xml);
  CHECK(now[3].p.x == doctest::Approx(200));
  CHECK(now[4].p.y == doctest::Approx(140));
  CHECK(now[5].p.x == doctest::Approx(200));
  CHECK(now[5].p.y == doctest::Approx(260));
}

TEST_CASE("objects that are new to a home are added as boxes") {
  const auto home = open_sh3d(kHome);
  auto scenes = rooms(*home);
  scene::Object extra;
  extra.id = "shelf-9";
  extra.name = "Bob's <shelf>";
  extra.position = geometry::Vec3{2, -2, 0};
  extra.angle = 0;
  (*scenes)[0].objects.push_back(extra);
  const auto file = write_sh3d(*home, *scenes);
  REQUIRE(file.ok());
  CHECK(file->added == 1);
  const std::vector<Seen> now = pieces_of(file->xml);
  REQUIRE(now.size() == 9);
  CHECK(now.back().name == "Bob's <shelf>");
}

TEST_CASE("a scene of another home is refused by name") {
  const auto home = open_sh3d(kHome);
  auto scenes = rooms(*home);
  (*scenes)[0].objects[0].extras = {{"x-sh3d", R"({"piece":"77"})"}};
  const auto file = write_sh3d(*home, *scenes);
  REQUIRE_FALSE(file.ok());
  CHECK(file.error().where == (*scenes)[0].objects[0].id);
}

TEST_CASE("a scene that never was a home is written and read back the same") {
  scene::Scene scene;
  scene.name = "L-shaped";
  scene.space.outline = {{0, 0}, {5, 0}, {5, 3}, {2, 3}, {2, 5}, {0, 5}};
  scene.space.holes.push_back({"pillar", {{3, 1}, {3.4, 1}, {3.4, 1.4}, {3, 1.4}}, {}});
  int wall = 0;
  for (const auto swing : {scene::Door::Swing::in, scene::Door::Swing::out}) {
    for (const auto hinge : {scene::Door::Hinge::start, scene::Door::Hinge::end})
      scene.space.doors.push_back({"d", wall++, 0.5, 0.9, 2.1, swing, hinge});
  }
  scene.space.windows.push_back({"w", 4, 0.25, 1.5, 0.9, 1.2});
  for (int i = 0; i < 8; ++i) {
    scene::Object o;
    o.id = "chair-" + std::to_string(i);
    o.kind = "chair";
    o.position = geometry::Vec3{0.5 + 0.2 * i, 1, 0.1 * i};
    o.angle = wrap_angle(i * 0.9);
    scene.objects.push_back(o);
  }
  const auto file = write_sh3d_new(scene);
  REQUIRE_MESSAGE(file.ok(), file.error().text());
  CHECK(file->warnings.empty());
  const auto home = open_sh3d(file->bytes);
  REQUIRE_MESSAGE(home.ok(), home.error().text());
  const auto read = read_rooms(*home);
  REQUIRE(read.ok());
  REQUIRE(read->scenes.size() == 1);
  const scene::Space& space = read->scenes[0].space;
  CHECK(space.outline.size() == 6);
  CHECK(geometry::signed_area(space.outline) == doctest::Approx(19).epsilon(1e-3));
  REQUIRE(space.holes.size() == 1);
  CHECK(geometry::signed_area(space.holes[0].outline) == doctest::Approx(0.16).epsilon(1e-2));
  REQUIRE(space.doors.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const geometry::Vec2 was = scene.space.wall_start(i),
                         now = space.wall_start(static_cast<std::size_t>(space.doors[i].wall));
    CHECK(geometry::length(was - now) < 2e-3);
    CHECK(space.doors[i].from == doctest::Approx(0.5).epsilon(1e-2));
    CHECK(space.doors[i].swing == scene.space.doors[i].swing);
    CHECK(space.doors[i].hinge == scene.space.doors[i].hinge);
  }
  REQUIRE(space.windows.size() == 1);
  REQUIRE(read->scenes[0].objects.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) {
    const scene::Object &was = scene.objects[i], &now = read->scenes[0].objects[i];
    CHECK(now.kind == "chair");
    CHECK(std::abs(now.position->x - was.position->x) < 1e-6);
    CHECK(std::abs(wrap_angle(*now.angle - *was.angle)) < 1e-6);
  }
}

TEST_CASE("all real homes are read and every piece is accounted for") {
  std::size_t scenes = 0, pieces = 0, openings = 0;
  for (const auto& path : home_files()) {
    CAPTURE(path.filename().string());
    const auto home = open_sh3d(slurp(path));
    REQUIRE_MESSAGE(home.ok(), home.error().text());
    const auto read = read_rooms(*home);
    REQUIRE(read.ok());
    std::set<std::string> origins;
    for (const scene::Scene& scene : read->scenes) {
      CHECK_FALSE(geometry::why_not_simple(scene.space.outline).has_value());
      CHECK(geometry::signed_area(scene.space.outline) > 0.5);
      std::set<std::string> ids;
      for (const auto& o : scene.objects) {
        CHECK(ids.insert(o.id).second);
        CHECK(origins.insert(o.extras.at(0).second).second);
      }
      for (const auto& d : scene.space.doors) origins.insert(d.extras.at(0).second);
      for (const auto& w : scene.space.windows) origins.insert(w.extras.at(0).second);
    }
    CHECK(origins.size() + read->outside.size() + read->hidden.size() == read->pieces);
    // What stands outside is stairs, roofs and the posts of a terrace: 18 of 744.
    CHECK(read->outside.size() <= 11);
    scenes += read->scenes.size();
    pieces += read->pieces;
    for (std::size_t at = 0; (at = home->xml.find("<doorOrWindow", at)) != std::string::npos; ++at) ++openings;
  }
  if (scenes == 0) return;
  CHECK(scenes == 63);
  CHECK(pieces == 744);
  CHECK(openings == 129);
}

TEST_CASE("backs of real furniture stand at walls more often than fronts") {
  std::size_t back = 0, front = 0;
  for (const auto& path : home_files()) {
    const auto home = open_sh3d(slurp(path));
    const auto scenes = rooms(*home);
    for (const scene::Scene& scene : *scenes) {
      for (const scene::Object& o : scene.objects) {
        if (o.kind != "wardrobe" && o.kind != "toilet" && o.kind != "bookcase" && o.kind != "upper cabinet") continue;
        const geometry::Vec2 half = 0.5 * o.size.y * geometry::direction(*o.angle), p = o.position->xy();
        const double b = geometry::nearest_on_ring(scene.space.outline, p - half).distance;
        const double f = geometry::nearest_on_ring(scene.space.outline, p + half).distance;
        ++(b < f ? back : front);
      }
    }
  }
  if (back + front > 0) CHECK_MESSAGE(back >= 30 * front, back << " backs and " << front << " fronts");
  MESSAGE(back << " backs nearer to a wall and " << front << " fronts");
}

TEST_CASE("real homes written unchanged keep every pose") {
  for (const auto& path : home_files()) {
    const auto home = open_sh3d(slurp(path));
    const auto scenes = rooms(*home);
    const auto file = write_sh3d(*home, *scenes);
    REQUIRE_MESSAGE(file.ok(), file.error().text());
    CHECK(file->moved == 0);
    CHECK(file->xml == home->xml);
    const auto again = open_sh3d(file->bytes);
    REQUIRE_MESSAGE(again.ok(), again.error().text());
    const auto before = pieces_of(home->xml), after = pieces_of(again->xml);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      CHECK(geometry::length(before[i].p - after[i].p) < 1e-3);
      CHECK(before[i].angle == after[i].angle);
    }
    // Written once more, the archive comes back as it is.
    const auto twice = write_sh3d(*again, *rooms(*again));
    CHECK(twice->bytes == file->bytes);
  }
}

TEST_CASE("real homes with everything moved come back where the scenes have it") {
  Rng rng(11);
  for (const auto& path : home_files()) {
    const auto home = open_sh3d(slurp(path));
    auto scenes = rooms(*home);
    std::size_t expected = 0;
    for (scene::Scene& scene : *scenes) {
      for (scene::Object& o : scene.objects) {
        o.position->x += rng.uniform(0.01, 1);
        o.position->y -= rng.uniform(0.01, 1);
        o.angle = wrap_angle(*o.angle + rng.uniform(0.1, 6));
        ++expected;
      }
    }
    const auto file = write_sh3d(*home, *scenes);
    REQUIRE(file.ok());
    CHECK(file->moved == expected);
    const auto plan = sh3d::read_plan(file->xml);
    REQUIRE(plan.ok());
    for (const scene::Scene& scene : *scenes) {
      for (const scene::Object& o : scene.objects) {
        std::string path_of = o.extras.at(0).second;
        path_of = path_of.substr(10, path_of.size() - 12);
        const std::vector<sh3d::Piece>* level = &plan->pieces;
        const sh3d::Piece* piece = nullptr;
        for (std::size_t at = 0; at <= path_of.size(); at = path_of.find('/', at) + 1) {
          piece = &level->at(static_cast<std::size_t>(std::stoi(path_of.substr(at))));
          level = &piece->children;
          if (path_of.find('/', at) == std::string::npos) break;
        }
        CHECK(geometry::length(sh3d::metres(piece->p) - o.position->xy()) < 1e-5);
        CHECK(std::abs(wrap_angle(sh3d::turn_angle(piece->angle) - *o.angle)) < 1e-6);
      }
    }
  }
}
