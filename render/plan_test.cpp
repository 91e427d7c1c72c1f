#include "render/plan.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "core/test_data.h"
#include "render/pen.h"
#include "render/walls.h"

using namespace inhabit;
using namespace inhabit::render;

namespace {

scene::Object object(std::string id, std::string kind, Vec3 size, std::optional<Vec3> at, double angle = 0) {
  scene::Object o;
  o.id = std::move(id), o.kind = std::move(kind), o.size = size, o.position = at;
  if (at) o.angle = angle;
  return o;
}

scene::Scene room(double width, double depth) {
  scene::Scene s;
  s.name = "room & <board>";
  s.space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  return s;
}

scene::Scene bedroom() {
  scene::Scene s = room(4.6, 3.4);
  s.space.doors.push_back({"door", 0, 0.4, 0.9, 2.1, scene::Door::Swing::in, scene::Door::Hinge::start, {}});
  s.space.windows.push_back({"window", 2, 1, 1.4, 0.9, 1.2, {}});
  s.objects = {object("bed-1", "bed", {1.4, 2, 0.5}, Vec3{0.9, 2.3, 0}, -1.5708),
               object("lamp", "floor_lamp", {0.3, 0.3, 1.6}, Vec3{4.3, 2.2, 0}),
               object("shelf", "bookcase", {1, 0.3, 1.8}, Vec3{4.4, 1, 0}, 3.1416),
               object("rack", "coat rack", {0.4, 0.4, 1.7}, {})};
  s.objects[0].name = "double bed";
  s.objects[2].clearance.front = 0.5;
  s.objects[2].view = scene::View{2, 1};
  return s;
}

std::string svg(const Drawing& d) {
  auto bytes = encode(d, Format::svg);
  REQUIRE(bytes.ok());
  return *bytes;
}

/// True when every element that is opened is closed again, in order.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return false;
    if (tag[0] == '?' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

}  // namespace

TEST_CASE("a plan holds its labels and measures and is the same every time") {
  const scene::Scene s = bedroom();
  for (const Format format : {Format::svg, Format::png, Format::pdf})
    CHECK(*encode(draw_plan(s), format) == *encode(draw_plan(s), format));
  const std::string text = svg(draw_plan(s));
  CHECK(well_formed(text));
  for (const char* label :
       {">double bed<", ">bookcase<", ">not placed<", ">4.60 m<", ">3.40 m<", "room &amp; &lt;board&gt;"})
    CHECK_MESSAGE(text.find(label) != std::string::npos, label);
  PlanOptions ids;
  ids.ids = true;
  CHECK(svg(draw_plan(s, ids)).find(">bed-1<") != std::string::npos);
  PlanOptions bare;
  bare.labels = PlanOptions::Labels::none;
  bare.title = bare.dimensions = bare.scale_bar = false;
  CHECK(svg(draw_plan(s, bare)).find(">double bed<") == std::string::npos);
}

TEST_CASE("problems of a report are shown") {
  const scene::Scene s = bedroom();
  layout::CheckReport report;
  report.overlaps = {{"bed-1", "lamp", 0.123}, {"bed-1", "nobody", 1}};
  report.outside = {{"shelf", 0.05}, {"rack", std::numeric_limits<double>::infinity()}};
  report.blocked_doors = {{"door", 0.4}};
  report.clearances = {{"shelf", "front", 0.5}};
  PlanOptions options;
  options.clearances = options.views = options.door_zones = true;
  options.report = &report;
  const std::string text = svg(draw_plan(s, options));
  CHECK(well_formed(text));
  CHECK(text.find("not feasible") != std::string::npos);
  CHECK(text.find("5 cm outside") != std::string::npos);
  CHECK(text.find("1 outside the room") != std::string::npos);
}

TEST_CASE("many of a kind are counted in the legend instead of labelled") {
  scene::Scene s = room(30, 20);
  for (int i = 0; i < 200; ++i)
    s.objects.push_back(
        object("seat-" + std::to_string(i), "seat", {0.5, 0.5, 0.9}, Vec3{1.0 + i % 20, 1.0 + i / 20, 0}));
  s.objects.push_back(object("stage", "stage", {8, 3, 1}, Vec3{15, 16, 0}));
  const std::string text = svg(draw_plan(s));
  CHECK(text.find(">seat<") == std::string::npos);
  CHECK(text.find(">seat × 200<") != std::string::npos);
  CHECK(text.find(">stage<") != std::string::npos);
}

TEST_CASE("degenerate scenes are drawn all the same") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<scene::Scene> scenes = {{},         room(5, 4),   room(0.05, 0.02), room(300, 200), room(60, 0.8),
                                      room(0, 0), room(kNan, 3)};
  scenes.push_back(bedroom());
  scenes.back().objects[0].position = Vec3{kNan, 0, 0};
  scenes.back().objects[1].size = {kNan, -1, 1e300};
  scenes.back().objects[2].position = Vec3{1e7, 1e7, 0};
  scenes.back().objects[3].size = {0, 0, 0};
  scenes.push_back(bedroom());
  scenes.back().space.outline.clear();
  scenes.push_back(bedroom());
  scenes.back().space.doors[0].wall = 99;
  scenes.back().space.windows[0].wall = -1;
  scenes.back().space.holes.push_back({"nothing", {}, {}});
  scenes.push_back(room(5, 4));
  for (int i = 0; i < 500; ++i) scenes.back().objects.push_back(object(std::to_string(i), "chair", {0.5, 0.5, 1}, {}));
  for (const scene::Scene& s : scenes) {
    const Drawing d = draw_plan(s);
    CHECK(d.size.x < 3000);
    CHECK(d.size.y < 3000);
    CHECK(well_formed(svg(d)));
    CHECK(svg(d).find("nan") == std::string::npos);
    CHECK(encode(d, Format::png, {.png_long_side = 200}).ok());
  }
}

TEST_CASE("a hundred thousand seats are drawn hundreds to an item") {
  constexpr int kSeats = core::kSlowBuild ? 10000 : 100000;
  scene::Scene s = room(400, 300);
  const auto points = [](const Drawing& drawing) {
    std::size_t count = 0;
    for (const auto& item : drawing.items)
      if (const Shape* shape = std::get_if<Shape>(&item)) count += shape->path.points.size();
    return count;
  };
  const Drawing empty = draw_plan(s);
  for (int i = 0; i < kSeats; ++i)
    s.objects.push_back(
        object(std::to_string(i), "seat", {0.5, 0.5, 0.9}, Vec3{5 + i % 400 * 0.95, 5 + i / 400 * 1.1, 0}, 1.57));
  const Drawing d = draw_plan(s);
  CHECK(d.items.size() <= empty.items.size() + kSeats / 100);
  CHECK(points(d) >= points(empty) + 4 * kSeats);
  CHECK(points(d) <= points(empty) + 100 * kSeats);
  CHECK(encode(d, Format::png).ok());
}

TEST_CASE("walls of a room that is not convex lie outside it at their thickness") {
  const Ring corner = {{0, 0}, {7, 0}, {7, 3}, {4, 3}, {4, 6}, {0, 6}};
  const Ring outer = outward_offset(corner, 0.25);
  const Ring expected = {{-0.25, -0.25}, {7.25, -0.25}, {7.25, 3.25}, {4.25, 3.25}, {4.25, 6.25}, {-0.25, 6.25}};
  REQUIRE(outer.size() == expected.size());
  for (std::size_t i = 0; i < outer.size(); ++i) CHECK(length(outer[i] - expected[i]) < 1e-12);
  core::Rng rng(11);
  for (int k = 0; k < 300; ++k) {
    // A star: its corners at any distance from the middle.
    Ring star;
    const int n = 3 + static_cast<int>(rng.index(9));
    for (int i = 0; i < n; ++i) star.push_back(rng.uniform(2, 6) * direction(2 * core::kPi * i / n));
    const double t = rng.uniform(0.02, 0.3);
    for (const Vec2 p : outward_offset(star, t)) {
      CHECK(std::isfinite(p.x));
      if (n > 4) CHECK(nearest_on_ring(star, p).distance <= 3.001 * t * (n > 4 ? 2 : 1));
    }
    CHECK(signed_area(outward_offset(star, t)) > signed_area(star));
  }
}

TEST_CASE("a sharp corner is cut off and repeated corners do no harm") {
  const Ring needle = {{0, 0}, {10, 0}, {0, 0.2}};
  for (const Vec2 p : outward_offset(needle, 0.1)) CHECK(p.x < 10.2);
  const Ring twice = {{0, 0}, {0, 0}, {4, 0}, {4, 3}, {0, 3}};
  CHECK(outward_offset(twice, 0.1).size() == 4);
  CHECK(outward_offset({}, 0.1).empty());
}

TEST_CASE("kinds are found by their words and the last word counts") {
  CHECK(symbol_row("Office-Chair").kind == "office chair");
  CHECK(symbol_row("officeChair_2").kind == "office chair");
  CHECK(symbol_row("chairs").kind == "chair");
  CHECK(symbol_row("table lamp").kind == "lamp");
  CHECK(symbol_row("single_bed").kind == "bed");
  CHECK(symbol_row("embedded").kind.empty());
  CHECK(symbol_row("").kind.empty());
}

TEST_CASE("every symbol can be drawn at every size") {
  for (const char* kind :
       {"bed",         "crib",     "sofa",     "chair",   "office chair", "stool",     "bench",  "seat",     "table",
        "round table", "desk",     "wardrobe", "dresser", "bookcase",     "coat rack", "tv",     "plant",    "lamp",
        "rug",         "toilet",   "sink",     "bathtub", "shower",       "stove",     "fridge", "washer",   "grill",
        "trash can",   "carousel", "stage",    "piano",   "pool table",   "book",      "laptop", "keyboard", "pencil",
        "plate",       "mug",      "picture",  "notepad", "parasol",      "door",      "zither"}) {
    for (const double size : {0.0, 0.004, 0.3, 2.0, 40.0}) {
      scene::Scene s = room(50, 50);
      s.objects.push_back(object("it", kind, {size, 0.6 * size, size}, Vec3{25, 25, 0}, 0.7));
      const std::string text = svg(draw_plan(s));
      CHECK(text.find("nan") == std::string::npos);
      CHECK(text.find("inf") == std::string::npos);
    }
  }
}
