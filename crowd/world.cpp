#include "crowd/world.h"

#include <algorithm>

#include "geometry/overlay.h"
#include "scene/kind.h"

namespace inhabit::crowd {
namespace {

/// Corners that turn by less than this much are dropped, metres: far below a person, far above rounding.
constexpr double kTolerance = 1e-4;
/// Leftovers on which not even a child's foot stands, square metres.
constexpr double kSmallestFloor = 0.02;
/// How far out of a door an area is looked for, and how deep a doorway may be, metres.
constexpr double kThreshold = 1, kDeepestDoorway = 20;
/// Doorways begin so far inside the wall that their union with the room has no seam, metres.
constexpr double kSeam = 0.01;

bool in_the_way(const scene::Object& object) {
  if (!object.position) return false;
  const scene::KindRow* kind = scene::find_kind(object.kind);
  if (kind && kind->trait == scene::KindTrait::flat) return false;
  const double base = object.position->z, top = base + object.size.z;
  return base < kBodyHeight && top > kStepHeight;
}

Ring footprint(const scene::Object& object) {
  const auto corners = make_box({object.position->xy(), object.angle.value_or(0)}, object.size).corners();
  return {corners.begin(), corners.end()};
}

/// A rectangle from `start` along the unit vector `along`, `width` long, and from `inner` to `outer` to the right of
/// it.
Ring strip(Vec2 start, Vec2 along, double width, double inner, double outer) {
  const Vec2 out = -perp(along), end = start + width * along;
  return {start + outer * out, end + outer * out, end + inner * out, start + inner * out};
}

/// The floor of a door's opening, as deep as the areas that lie in it reach; empty when none does.
Ring doorway(const scene::Space& space, const scene::Door& door, const std::vector<const Ring*>& areas) {
  const auto wall = static_cast<std::size_t>(door.wall);
  if (door.wall < 0 || wall >= space.walls()) return {};
  const Vec2 along = unit(space.wall_end(wall) - space.wall_start(wall));
  const Vec2 jamb = space.wall_start(wall) + door.from * along, out = -perp(along);
  const Ring front = strip(jamb, along, door.width, 0, kThreshold);
  double depth = 0;
  for (const Ring* area : areas) {
    if (!overlap_deeper(*area, std::span(&front, 1), kSeam)) continue;
    for (const Vec2 corner : *area) depth = std::max(depth, dot(corner - jamb, out));
  }
  return depth > 0 ? strip(jamb, along, door.width, -kSeam, std::min(depth, kDeepestDoorway)) : Ring{};
}

}  // namespace

Result<World> make_world(const scene::Scene& scene, double reach) {
  const scene::Space& space = scene.space;
  if (space.outline.size() < 3) return invalid("/space/outline", "people need a floor of at least three corners");

  std::vector<Area> floor = {{space.outline, {}}};
  std::vector<const Ring*> used;
  for (const scene::Goal& goal : scene.crowd.goals) used.push_back(&goal.area);
  for (const scene::Source& source : scene.crowd.sources) used.push_back(&source.area);
  std::erase_if(used, [](const Ring* ring) { return ring->size() < 3; });
  for (const scene::Door& door : space.doors)
    if (Ring way = doorway(space, door, used); !way.empty()) floor.push_back({std::move(way), {}});

  std::vector<Ring> taken;
  for (const scene::Hole& hole : space.holes) taken.push_back(hole.outline);
  for (const scene::Object& object : scene.objects)
    if (in_the_way(object)) taken.push_back(footprint(object));

  World world;
  world.origin = bounds(space.outline).center();
  for (Area& area : difference(floor, taken, kTolerance))
    if (area.size() >= kSmallestFloor)
      world.floors.push_back(make_floor(std::move(area.outline), std::move(area.holes)));
  if (world.floors.empty()) return invalid("/space", "holes and furniture leave no floor to walk on");
  world.walls = Walls(world.floors, world.origin, reach);
  return world;
}

}  // namespace inhabit::crowd
