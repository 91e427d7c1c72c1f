#include "io/formats/sweethome3d_new.h"

#include <algorithm>
#include <cmath>

#include "io/formats/sweethome3d_edit.h"
#include "io/formats/sweethome3d_plan.h"

namespace inhabit::io {
namespace sh3d {
namespace {

constexpr double kThickness = 0.075;  // metres, Sweet Home 3D's own default wall

/// ` name='value'`.
std::string attribute(std::string_view name, std::string_view value) {
  return std::string(" ").append(name).append("='").append(value).append("'");
}
std::string number(std::string_view name, double value) { return attribute(name, float_text(value)); }
std::string place(std::string_view x, std::string_view y, Vec2 p) {
  const Vec2 c = centimetres(p);
  return number(x, c.x) + number(y, c.y);
}

/// The ring moved to its right by `width`, corners mitred (at most fourfold).
Ring moved_out(const Ring& ring, double width) {
  Ring out;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 before = -perp(unit(ring[k] - ring[(k + n - 1) % n])), after = -perp(unit(ring[(k + 1) % n] - ring[k]));
    const double share = std::max(0.25, (1 + dot(before, after)) / 2);
    out.push_back(ring[k] + (width / (2 * share)) * (before + after));
  }
  return out;
}

std::string wall_elements(const Ring& ring, double thickness, double height, const std::string& prefix) {
  const Ring line = moved_out(ring, thickness / 2);
  const std::size_t n = line.size();
  std::string out;
  for (std::size_t k = 0; k < n; ++k) {
    const auto id = [&](std::size_t i) { return prefix + std::to_string(i % n); };
    out += "  <wall";
    out += attribute("id", id(k)) + attribute("wallAtStart", id(k + n - 1)) + attribute("wallAtEnd", id(k + 1));
    out += place("xStart", "yStart", line[k]) + place("xEnd", "yEnd", line[(k + 1) % n]);
    out += number("height", height * 100) + number("thickness", thickness * 100) + "/>\n";
  }
  return out;
}

/// A door or window in the wall behind side `wall`, its front to the room.
std::string opening_tag(const scene::Space& space, int wall, double from, double width, double sill, double height,
                        std::string_view name) {
  const Vec2 a = space.wall_start(static_cast<std::size_t>(wall)), b = space.wall_end(static_cast<std::size_t>(wall));
  const Vec2 s = unit(b - a), inward = perp(s);
  const Vec2 center = a + (from + width / 2) * s - (kThickness / 2) * inward;
  std::string out("  <doorOrWindow");
  out += attribute("name", name) + place("x", "y", center) + number("elevation", sill * 100);
  out +=
      number("angle", turn_angle(angle_of(inward))) + number("width", width * 100) + number("depth", kThickness * 100);
  return out += number("height", height * 100) + attribute("movable", "false");
}

std::string door_element(const scene::Space& space, const scene::Door& door) {
  std::string out = opening_tag(space, door.wall, door.from, door.width, 0, door.height, "Door");
  if (door.swing == scene::Door::Swing::none) return out += "/>\n";
  // Seen with the front down, the wall runs from right to left: the jamb at its end is the left one, xAxis 0.
  const bool left = door.hinge == scene::Door::Hinge::end, in = door.swing == scene::Door::Swing::in;
  const double start = left ? 0 : kPi, quarter = left == in ? -kPi / 2 : kPi / 2;
  out += ">\n    <sash";
  out += number("xAxis", left ? 0 : 1) + number("yAxis", 0.5) + number("width", 1);
  return out += number("startAngle", start) + number("endAngle", start + quarter) + "/>\n  </doorOrWindow>\n";
}

}  // namespace

std::string box_element(const scene::Object& o, const std::string& level) {
  const std::string& name = !o.name.empty() ? o.name : !o.kind.empty() ? o.kind : o.id;
  std::string out("  <pieceOfFurniture");
  if (!level.empty()) out += attribute("level", escaped(level));
  out +=
      attribute("name", escaped(name)) + place("x", "y", o.position->xy()) + number("elevation", o.position->z * 100);
  double angle = turn_angle(*o.angle);
  if (angle < 0) angle += 2 * kPi;
  out += number("angle", angle);
  // Sweet Home 3D wants no size below a millimetre.
  out += number("width", std::max(0.1, o.size.x * 100)) + number("depth", std::max(0.1, o.size.y * 100));
  out += number("height", std::max(0.1, o.size.z * 100));
  if (o.fixed) out += attribute("movable", "false");
  return out += "/>\n";
}

}  // namespace sh3d

Result<Sh3dFile> write_sh3d_new(const scene::Scene& scene) {
  using namespace sh3d;
  const scene::Space& space = scene.space;
  std::string xml("<?xml version='1.0'?>\n<home version='6400'");
  xml += attribute("name", escaped(scene.name)) + attribute("camera", "topCamera");
  xml += number("wallHeight", space.height * 100) + ">\n";
  std::vector<std::string> warnings;
  for (const scene::Object& o : scene.objects) {
    if (o.position && o.angle) {
      xml += box_element(o, "");
    } else {
      warnings.push_back(o.id + " has no place in the scene and was left out");
    }
  }
  for (const scene::Door& door : space.doors) xml += door_element(space, door);
  for (const scene::Window& w : space.windows)
    xml += opening_tag(space, w.wall, w.from, w.width, w.sill, w.height, "Window") + "/>\n";
  xml += wall_elements(space.outline, kThickness, space.height, "wall");
  for (std::size_t i = 0; i < space.holes.size(); ++i) {
    Ring ring = space.holes[i].outline;
    std::reverse(ring.begin(), ring.end());
    xml += wall_elements(ring, 0.05, space.height, "hole" + std::to_string(i) + "-");
  }
  xml += "  <room";
  xml += attribute("name", escaped(scene.name)) + attribute("areaVisible", "true") + ">\n";
  for (const Vec2 p : space.outline) xml += "    <point" + place("x", "y", p) + "/>\n";
  xml += "  </room>\n</home>\n";
  auto file = packed("", xml, {});
  if (!file) return file.error();
  file->added = scene.objects.size() - warnings.size();
  file->warnings = std::move(warnings);
  return file;
}

}  // namespace inhabit::io
