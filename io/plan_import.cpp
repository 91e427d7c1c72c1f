#include "io/plan_import.h"

#include <algorithm>

#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// Farther from the origin than any building is large: a national grid.
constexpr double kGrid = 1e5;
constexpr double kFarthest = 1e8;
constexpr double kNarrowestOpening = 0.4;

Ring tidied(Ring ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (signed_area(ring) < 0) std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

Scene scene_of(Area area, std::string_view name) {
  Scene scene;
  scene.name = name;
  scene.space.outline = std::move(area.outline);
  for (Ring& ring : area.holes)
    scene.space.holes.push_back({"hole-" + std::to_string(scene.space.holes.size() + 1), std::move(ring), {}});
  return scene;
}

/// The part of wall k that the opening covers, if it is one in this wall.
struct Fit {
  std::size_t wall = 0;
  double from = 0, width = 0;
};
std::optional<Fit> fit_to_wall(const Space& space, std::size_t k, const Ring& outline, double reach) {
  const Vec2 a = space.wall_start(k), along = unit(space.wall_end(k) - a);
  const double wall = length(space.wall_end(k) - a);
  double low = 1e300, high = -1e300, near = 1e300, far = -1e300;
  for (const Vec2 p : outline) {
    const double t = dot(p - a, along), s = cross(along, p - a);
    low = std::min(low, t), high = std::max(high, t), near = std::min(near, s), far = std::max(far, s);
  }
  const bool thin = far - near < high - low, touches = near <= reach && far >= -reach;
  low = std::max(low, 0.0), high = std::min(high, wall);
  if (!thin || !touches || high - low < kNarrowestOpening) return std::nullopt;
  return Fit{k, low, high - low};
}

}  // namespace

std::string json_text(std::string_view text) {
  std::string out;
  append_quoted(out, text);
  return out;
}

Area tidied(Area area) {
  area.outline = tidied(std::move(area.outline));
  for (Ring& hole : area.holes) hole = tidied(std::move(hole));
  return area;
}

bool is_clean(const Area& area) {
  if (why_not_simple(area.outline)) return false;
  return std::ranges::all_of(
      area.holes, [&](const Ring& hole) { return !why_not_simple(hole) && area_outside(hole, area.outline) < 1e-6; });
}

Result<std::vector<Scene>> scenes_of(std::vector<Area> areas, std::string_view name) {
  Bounds all;
  for (const Area& area : areas) {
    for (const Vec2 p : area.outline) all.add(p);
    for (const Ring& hole : area.holes) {
      for (const Vec2 p : hole) all.add(p);
    }
  }
  if (areas.empty()) return invalid("", "there is no polygon in it");
  const auto beyond = [&](double limit) {
    return all.min.x < -limit || all.min.y < -limit || all.max.x > limit || all.max.y > limit;
  };
  const Vec2 size = all.size();
  if (beyond(kFarthest) || !(size.x < kGrid) || !(size.y < kGrid))
    return invalid("", "the plan is larger than 100 km: these are no metres");
  const Vec2 origin = beyond(kGrid) ? Vec2{std::floor(all.min.x), std::floor(all.min.y)} : Vec2{};
  std::vector<Scene> scenes;
  for (Area& area : areas) {
    const auto move = [&](Ring& ring) {
      for (Vec2& p : ring) p -= origin;
    };
    move(area.outline);
    for (Ring& hole : area.holes) move(hole);
    area = tidied(std::move(area));
    if (is_clean(area)) {
      scenes.push_back(scene_of(std::move(area), name));
      continue;
    }
    for (Area& part : difference({area}, {}, 1e-6)) {
      if (!is_clean(part)) continue;
      scenes.push_back(scene_of(std::move(part), name));
      scenes.back().extras.emplace_back("x-repaired", "true");
    }
  }
  if (scenes.empty()) return invalid("", "no polygon in it encloses an area");
  if (origin != Vec2{}) {
    for (Scene& scene : scenes)
      scene.extras.emplace_back("x-origin",
                                std::string("[") + number_text(origin.x) + ", " + number_text(origin.y) + "]");
  }
  return scenes;
}

std::size_t add_openings(Space& space, const std::vector<DrawnOpening>& openings, double reach) {
  std::size_t added = 0;
  for (const DrawnOpening& opening : openings) {
    std::optional<Fit> best;
    for (std::size_t k = 0; k < space.walls(); ++k) {
      const std::optional<Fit> fit = fit_to_wall(space, k, opening.outline, reach);
      if (fit && (!best || fit->width > best->width)) best = fit;
    }
    if (!best) continue;
    ++added;
    const std::string number = std::to_string((opening.window ? space.windows.size() : space.doors.size()) + 1);
    const int wall = static_cast<int>(best->wall);
    if (opening.window) {
      Window window{"window-" + number, wall, best->from, best->width};
      space.windows.push_back(std::move(window));
    } else {
      Door door{"door-" + number, wall, best->from, best->width};
      space.doors.push_back(std::move(door));
    }
  }
  return added;
}

}  // namespace inhabit::io
