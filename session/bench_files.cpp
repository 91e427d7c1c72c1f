#include <cmath>

#include "io/formats/scene_json.h"
#include "layout/check.h"
#include "render/plan.h"
#include "session/bench.h"

namespace inhabit::session {
using namespace scene;
namespace {

/// A hall with so many seats in rows, each in its place.
Scene rows_of_seats(int count) {
  Scene scene;
  scene.name = "rows";
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double side = 2 + columns;
  scene.space.outline = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  scene.space.doors.push_back({.id = "door", .wall = 0, .from = 0.2});
  for (int i = 0; i < count; ++i) {
    Object seat;
    seat.id = "seat-" + std::to_string(i + 1);
    seat.kind = "seat", seat.size = {0.5, 0.5, 0.9};
    seat.position = Vec3{1.5 + i % columns, 1.5 + i / columns, 0};
    seat.angle = kPi / 2;
    seat.clearance.front = 0.3;
    scene.objects.push_back(std::move(seat));
  }
  return scene;
}

double milliseconds(const std::function<void()>& work) {
  const double begin = processor_milliseconds();
  work();
  return processor_milliseconds() - begin;
}

}  // namespace

/// What happens to a scene besides furnishing it. Times for each object show whether they grow with their number.
Result<BenchGroup> bench_files(const BenchOptions& options) {
  Table table{"files", "Writing, reading, checking and drawing rows of seats", {}, {}, {}};
  table.columns = {{"objects", 0},  {"bytes", 0},   {"write ms", 1}, {"read ms", 1},
                   {"check ms", 1}, {"draw ms", 1}, {"PNG ms", 1},   {"us per object", 1}};
  for (const int count : {1000, 10000, 100000}) {
    if (options.cancel && options.cancel->requested()) break;
    const Scene scene = rows_of_seats(count);
    std::string text, error;
    render::Drawing drawing;
    const double write = milliseconds([&] { text = io::write_scene(scene); });
    const double read = milliseconds([&] {
      if (const Result<Scene> again = io::read_scene(text); !again) error = again.error().text();
    });
    const double check = milliseconds([&] { layout::check(scene, {.threads = 1}); });
    const double draw = milliseconds([&] { drawing = render::draw_plan(scene); });
    const double encode = milliseconds([&] {
      if (const Result<std::string> png = render::encode(drawing, render::Format::png); !png)
        error = png.error().text();
    });
    if (!error.empty()) return invalid("", error);
    table.rows.push_back({static_cast<double>(count), static_cast<double>(text.size()), write, read, check, draw,
                          encode, 1000 * (write + read + check + draw + encode) / count});
  }
  return BenchGroup{{std::move(table)}, {}};
}

}  // namespace inhabit::session
