#include "render/walls.h"

#include <algorithm>

namespace inhabit::render {

Ring outward_offset(std::span<const Vec2> ring, double thickness) {
  constexpr double kMitre = 3;
  Ring sides, corners;  // outward normals and the corners where two different ones meet
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 d = ring[(i + 1) % ring.size()] - ring[i];
    if (d == Vec2{}) continue;
    sides.push_back(-perp(unit(d)));
    corners.push_back(ring[i]);
  }
  Ring out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 before = sides[(i + sides.size() - 1) % sides.size()], after = sides[i];
    const Vec2 sum = before + after;
    const double square = dot(sum, sum);  // 4 cos² of half the turn; the mitre reaches 2 / |sum| thicknesses far
    const bool convex = cross(before, after) > 0;
    if (square * kMitre * kMitre >= 4 || (!convex && square > 1e-6)) {
      out.push_back(corners[i] + (2 * thickness / square) * sum);
    } else {
      out.push_back(corners[i] + thickness * before);
      out.push_back(corners[i] + thickness * after);
    }
  }
  return out;
}

namespace {

/// Start, direction and inward normal of a wall.
struct WallLine {
  Vec2 start, along, inward;
  double length = 0;
};

std::optional<WallLine> wall_line(const scene::Space& space, int wall) {
  if (wall < 0 || static_cast<std::size_t>(wall) >= space.walls()) return {};
  const auto k = static_cast<std::size_t>(wall);
  const Vec2 d = space.wall_end(k) - space.wall_start(k);
  if (!(length(d) > 0)) return {};
  return WallLine{space.wall_start(k), unit(d), perp(unit(d)), length(d)};
}

/// The opening's rectangle through the wall, a little thicker than it so that no sliver of the wall is left.
Ring through_wall(Vec2 a, Vec2 b, Vec2 inward, double thickness, double slack) {
  return {a + slack * inward, b + slack * inward, b - (thickness + slack) * inward, a - (thickness + slack) * inward};
}

void hatch(Drawing& drawing, const Ring& ring, double step, double width) {
  // Lines at 45 degrees, each cut where it crosses the ring.
  const Bounds b = bounds(ring);
  Path lines;
  const double reach = b.size().x + b.size().y;
  for (double t = step; t < reach && lines.verbs.size() < 4000; t += step) {
    const Vec2 p{b.min.x + t, b.min.y}, d{-1, 1};
    std::vector<double> cuts;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], e = ring[(i + 1) % ring.size()] - a;
      const double c = cross(d, e);
      if (c == 0) continue;
      const double on_side = cross(a - p, d) / c;
      if (on_side >= 0 && on_side < 1) cuts.push_back(cross(a - p, e) / c);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) lines.segment(p + cuts[i] * d, p + cuts[i + 1] * d);
  }
  stroke(drawing, std::move(lines), ink::kPillar, width);
}

void draw_hole(Drawing& drawing, const Frame& frame, const Ring& outline, const WallStyle& style) {
  const Ring ring = frame.page(outline);
  const Vec2 size = bounds(ring).size();
  // A pillar is solid; a courtyard or a shaft is hatched.
  if (std::min(size.x, size.y) < 60) {
    fill(drawing, Path{}.polygon(ring), ink::kWall);
    return;
  }
  fill(drawing, Path{}.polygon(ring), rgb(0xe6e6e4));
  hatch(drawing, ring, 9, 0.5 * style.line);
  stroke(drawing, Path{}.polygon(ring), ink::kWall, 2.2 * style.line);
}

void draw_leaf(Drawing& drawing, const Frame& frame, const DoorPlace& place, double width, const WallStyle& style,
               Color color) {
  const double leaf = std::min(0.045, 0.06 * width);
  const Vec2 along = unit(place.jamb - place.hinge), tip = place.hinge + width * place.opening;
  Path arc;
  const Vec2 c = frame.page(place.hinge), a = frame.page(place.jamb) - c, b = frame.page(tip) - c;
  arc.arc(c, a, b, 0, kPi / 2);
  add(drawing, std::move(arc),
      {.stroke = color, .width = 0.7 * style.line, .dash = 3.2 * style.line, .gap = 2 * style.line});
  const Ring panel = {place.hinge, tip, tip + leaf * along, place.hinge + leaf * along};
  add(drawing, Path{}.polygon(frame.page(panel)), {.fill = rgb(0xffffff), .stroke = color, .width = 0.9 * style.line});
}

void draw_door(Drawing& drawing, const Frame& frame, const scene::Space& space, const scene::Door& door,
               const WallStyle& style) {
  auto place = door_place(space, door);
  if (!place) return;
  const bool blocked = std::ranges::find(style.blocked_doors, door.id) != style.blocked_doors.end();
  const Color color = blocked ? ink::kProblem : ink::kWall;
  const double slack = 0.6 / frame.scale;
  const Ring gap = through_wall(place->start, place->end, place->inward, style.thickness, slack);
  fill(drawing, Path{}.polygon(frame.page(gap)), ink::kFloor);
  const Vec2 out = -style.thickness * place->inward;
  Path sills;
  sills.segment(frame.page(place->start), frame.page(place->end));
  sills.segment(frame.page(place->start + out), frame.page(place->end + out));
  stroke(drawing, std::move(sills), rgb(0x9aa0a8), 0.6 * style.line);
  Path jambs;
  jambs.segment(frame.page(place->start), frame.page(place->start + out));
  jambs.segment(frame.page(place->end), frame.page(place->end + out));
  stroke(drawing, std::move(jambs), ink::kWall, 0.8 * style.line);
  // A leaf that opens outward hangs on the wall's outer face.
  if (door.swing == scene::Door::Swing::out) place->hinge += out, place->jamb += out;
  if ((style.door_zones || blocked) && door.swing != scene::Door::Swing::none)
    fill(drawing, swing_zone(*place, frame), blocked ? rgb(0xc62f2f, 0.13) : rgb(0x6f87a6, 0.14));
  if (door.swing != scene::Door::Swing::none) draw_leaf(drawing, frame, *place, door.width, style, color);
}

void draw_window(Drawing& drawing, const Frame& frame, const scene::Space& space, const scene::Window& window,
                 const WallStyle& style) {
  const auto wall = wall_line(space, window.wall);
  if (!wall) return;
  const Vec2 a = wall->start + window.from * wall->along, b = a + window.width * wall->along;
  const double slack = 0.3 / frame.scale;
  fill(drawing, Path{}.polygon(frame.page(through_wall(a, b, wall->inward, style.thickness, slack))), ink::kFloor);
  const auto line = [&](double depth) {
    const Vec2 out = -depth * style.thickness * wall->inward;
    return std::array{frame.page(a + out), frame.page(b + out)};
  };
  Path faces, panes;
  for (const double depth : {0.0, 1.0}) faces.polyline(line(depth));
  for (const double depth : {0.38, 0.62}) panes.polyline(line(depth));
  faces.segment(line(0)[0], line(1)[0]).segment(line(0)[1], line(1)[1]);
  stroke(drawing, std::move(faces), ink::kWall, 0.9 * style.line);
  stroke(drawing, std::move(panes), rgb(0x6f93b5), 0.8 * style.line);
}

}  // namespace

std::optional<DoorPlace> door_place(const scene::Space& space, const scene::Door& door) {
  const auto wall = wall_line(space, door.wall);
  if (!wall) return {};
  DoorPlace place;
  place.start = wall->start + door.from * wall->along;
  place.end = place.start + door.width * wall->along;
  place.inward = wall->inward;
  const bool at_start = door.hinge == scene::Door::Hinge::start;
  place.hinge = at_start ? place.start : place.end;
  place.jamb = at_start ? place.end : place.start;
  place.opening = door.swing == scene::Door::Swing::out ? -wall->inward : wall->inward;
  return place;
}

Path swing_zone(const DoorPlace& door, const Frame& frame) {
  const double width = length(door.jamb - door.hinge);
  const Vec2 c = frame.page(door.hinge);
  Path path;
  path.move(c).arc(c, frame.page(door.jamb) - c, frame.page(door.hinge + width * door.opening) - c, 0, kPi / 2);
  return path.close();
}

void draw_walls(Drawing& drawing, const Frame& frame, const scene::Space& space, const WallStyle& style) {
  const Ring inner = frame.page(space.outline);
  fill(drawing, Path{}.polygon(frame.page(outward_offset(space.outline, style.thickness))), ink::kWall);
  // The floor goes over the walls: where they stand close to each other, the room still has its outline.
  fill(drawing, Path{}.polygon(inner), ink::kFloor);
  for (const scene::Hole& hole : space.holes)
    if (hole.outline.size() >= 3) draw_hole(drawing, frame, hole.outline, style);
}

void draw_openings(Drawing& drawing, const Frame& frame, const scene::Space& space, const WallStyle& style) {
  for (const scene::Window& window : space.windows) draw_window(drawing, frame, space, window, style);
  for (const scene::Door& door : space.doors) draw_door(drawing, frame, space, door, style);
}

}  // namespace inhabit::render
