#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.h"
#include "geometry/overlay.h"
#include "io/formats/sweethome3d_scene.h"
#include "scene/kind.h"

namespace inhabit::io::sh3d {
namespace {

constexpr double kSliver = 0.01;        // metres: a polygon this little under a wall follows its face
constexpr double kSmallestRoom = 1e-3;  // square metres

/// Our ring of plan points: counter-clockwise, without corners nearer than 0.1 mm to the one before.
Ring tidy(const Ring& points) {
  Ring ring;
  for (const Vec2 p : points) {
    const Vec2 q = metres(p);
    if (ring.empty() || length(q - ring.back()) > 1e-4) ring.push_back(q);
  }
  while (ring.size() > 1 && length(ring.front() - ring.back()) <= 1e-4) ring.pop_back();
  if (ring.size() >= 3 && signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// The wall seen from above, metres. Round walls are offset at every point of their centre line.
Ring footprint(const Wall& wall) {
  const Ring line = center_line(wall);
  const double half = wall.thickness / 200;
  Ring left, right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 before = line[i > 0 ? i - 1 : 0], after = line[std::min(i + 1, line.size() - 1)];
    const Vec2 n = perp(unit(metres(after) - metres(before)));
    left.push_back(metres(line[i]) + half * n);
    right.push_back(metres(line[i]) - half * n);
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

bool apart(const Bounds& a, const Bounds& b) {
  return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y;
}

std::vector<Ring> walls_at(const Plan& plan, const Room& room, const Ring& polygon) {
  std::vector<Ring> walls;
  const Bounds here = bounds(polygon);
  for (const Wall& wall : plan.walls) {
    if (wall.level != room.level || wall.thickness <= 0 || length(wall.end - wall.start) < 1e-3) continue;
    Ring ring = footprint(wall);
    if (!apart(bounds(ring), here)) walls.push_back(std::move(ring));
  }
  return walls;
}

/// The room's polygon, cut back to the wall faces where it reaches under walls.
void set_outline(const Plan& plan, RoomDraft& draft, std::vector<std::string>& warnings) {
  scene::Space& space = draft.scene.space;
  const std::string name = std::string("room \"").append(draft.scene.name).append("\"");
  space.outline = draft.polygon;
  const std::vector<Ring> walls = walls_at(plan, *draft.room, draft.polygon);
  if (overlap_deeper(draft.polygon, walls, kSliver)) {
    const std::vector<Area> areas = smooth_difference(draft.polygon, walls, kSliver);
    double total = 0;
    for (const Area& area : areas) total += area.size();
    if (!areas.empty() && areas[0].size() >= 0.8 * total) {
      space.outline = areas[0].outline;
      for (const Ring& hole : areas[0].holes) {
        if (signed_area(hole) > kSmallestRoom) space.holes.push_back({draft.ids.next("wall"), hole, {}});
      }
    } else {
      warnings.push_back(name + " is divided by walls; its polygon is used as drawn");
    }
  }
  const auto why = why_not_simple(space.outline);
  if (!why) return;
  const std::vector<Area> repaired = smooth_difference(space.outline, {}, kSliver / 2);
  space.holes.clear();
  if (!repaired.empty() && repaired[0].size() > kSmallestRoom && !why_not_simple(repaired[0].outline)) {
    space.outline = repaired[0].outline;
    warnings.push_back(name + ": " + *why + "; its largest part is used");
  } else {
    space.outline.clear();
    warnings.push_back(name + " is left out: " + *why);
  }
}

/// Where an opening meets one side of an outline.
struct Fit {
  std::size_t side = 0;
  double from = 0, width = 0, score = 1e300;
};

std::optional<Fit> fit_opening(const Piece& piece, const Ring& outline) {
  // The wall's share of the box: an open leaf belongs to the box, too.
  const double thickness = piece.wall_thickness * piece.depth / 100;
  const double v = (piece.wall_distance + piece.wall_thickness / 2 - 0.5) * piece.depth;
  const Vec2 across{std::cos(piece.angle), std::sin(piece.angle)};
  const Vec2 q = metres(piece.p + v * perp(across)), u{across.x, -across.y};
  const double width = piece.width / 100;
  std::optional<Fit> best;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 d = outline[(k + 1) % outline.size()] - outline[k];
    const double l = length(d);
    if (l < 1e-6) continue;
    const Vec2 s = (1 / l) * d;
    const double along = dot(q - outline[k], s), off = std::abs(cross(s, q - outline[k]));
    if (std::abs(dot(u, s)) < std::cos(radians(20)) || off > std::abs(thickness) / 2 + 0.3) continue;
    const double from = std::max(0.0, along - width / 2), to = std::min(l, along + width / 2);
    const double shared = to - from;
    if (shared < std::max(0.1, 0.5 * std::min(width, l))) continue;
    const double score = off + (width - shared);
    if (!best || score < best->score) best = Fit{k, from, shared, score};
  }
  return best;
}

/// Which way the leaf swings, and on which jamb, seen from the room of `outline`.
void set_swing(const Piece& piece, const Ring& outline, scene::Door& door) {
  door.swing = scene::Door::Swing::none;
  const auto widest = std::max_element(piece.sashes.begin(), piece.sashes.end(),
                                       [](const Sash& a, const Sash& b) { return a.width < b.width; });
  if (widest == piece.sashes.end() || std::abs(widest->end - widest->start) < radians(20)) return;
  const double mirror = piece.mirrored ? -1 : 1;
  const Vec2 turn{std::cos(piece.angle), std::sin(piece.angle)};
  // Angles of a sash are counter-clockwise on the screen, so that y = -sin in the y-down frame of the piece.
  const Vec2 axis{mirror * (widest->x_axis - 0.5) * piece.width, (widest->y_axis - 0.5) * piece.depth};
  const Vec2 leaf = widest->width * piece.width * Vec2{mirror * std::cos(widest->end), -std::sin(widest->end)};
  const Vec2 hinge = metres(piece.p + rotate(axis, turn)), tip = metres(piece.p + rotate(axis + leaf, turn));
  const std::size_t k = static_cast<std::size_t>(door.wall);
  const Vec2 a = outline[k], s = unit(outline[(k + 1) % outline.size()] - a);
  door.swing = cross(s, tip - hinge) > 0 ? scene::Door::Swing::in : scene::Door::Swing::out;
  door.hinge = dot(hinge - a, s) < door.from + door.width / 2 ? scene::Door::Hinge::start : scene::Door::Hinge::end;
}

scene::Extras origin_of(const Piece& piece) {
  return {{std::string(kOriginKey), std::string("{\"piece\":\"").append(piece.path).append("\"}")}};
}

}  // namespace

std::string Ids::next(std::string_view name) {
  const std::string stem = name.empty() ? std::string("thing") : std::string(name);
  return stem + "-" + std::to_string(++given_[stem]);
}

bool is_door(const Piece& opening) {
  std::string words(" ");
  words.append(scene::words_of(opening.catalog_id, ' '))
      .append(" ")
      .append(scene::words_of(opening.name, ' '))
      .append(" ");
  if (words.find("door ") != std::string::npos || words.find(" doors ") != std::string::npos) return true;
  // A window down to the floor and as high as a person is walked through, unless it cannot be opened.
  return words.find(" fixed ") == std::string::npos && opening.elevation <= 20 && opening.height >= 180;
}

std::string describe(const Piece& piece) {
  const std::string name = piece.name.empty() ? piece.catalog_id : piece.name;
  std::string text("\"");
  text.append(name)
      .append("\" at (")
      .append(fixed(piece.p.x, 0))
      .append(", ")
      .append(fixed(piece.p.y, 0))
      .append(") cm");
  return piece.level.empty() ? text : text.append(" on ").append(piece.level);
}

std::vector<RoomDraft> draft_rooms(const Plan& plan, std::vector<std::string>& warnings) {
  std::vector<RoomDraft> drafts;
  std::map<std::string, int> names;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    RoomDraft draft;
    draft.room = &plan.rooms[i];
    draft.scene.name = draft.room->name.empty() ? std::string("room ").append(std::to_string(i + 1)) : draft.room->name;
    const int same = ++names[draft.scene.name];
    if (same > 1) draft.scene.name += std::string(" (").append(std::to_string(same)).append(")");
    draft.scene.extras.emplace_back(kOriginKey, std::string("{\"room\":").append(std::to_string(i)).append("}"));
    draft.scene.space.height = plan.wall_height / 100;
    for (const Level& level : plan.levels) {
      if (level.id == draft.room->level) draft.scene.space.height = level.height / 100;
    }
    draft.polygon = tidy(draft.room->points);
    draft.area = draft.polygon.size() < 3 ? 0 : signed_area(draft.polygon);
    set_outline(plan, draft, warnings);
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

bool place_opening(const Piece& opening, std::vector<RoomDraft>& rooms) {
  bool placed = false;
  for (RoomDraft& draft : rooms) {
    scene::Space& space = draft.scene.space;
    if (draft.room->level != opening.level || space.outline.empty()) continue;
    const auto fit = fit_opening(opening, space.outline);
    if (!fit) continue;
    placed = true;
    if (is_door(opening)) {
      scene::Door door{draft.ids.next("door"), static_cast<int>(fit->side), fit->from, fit->width,
                       opening.height / 100};
      set_swing(opening, space.outline, door);
      door.extras = origin_of(opening);
      space.doors.push_back(std::move(door));
    } else {
      space.windows.push_back({draft.ids.next("window"), static_cast<int>(fit->side), fit->from, fit->width,
                               std::max(0.0, opening.elevation / 100), opening.height / 100, origin_of(opening)});
    }
  }
  return placed;
}

}  // namespace inhabit::io::sh3d
