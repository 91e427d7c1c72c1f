#pragma once
#include "render/frame.h"
#include "scene/scene.h"

namespace inhabit::render {

/// The outer face of walls of a thickness: every side moved outward, corners mitred up to three times the thickness and
/// cut off beyond. Of a counter-clockwise ring; repeated and straight corners are kept. Sides near each other may
/// cross.
Ring outward_offset(std::span<const Vec2> ring, double thickness);

/// A door on the ground: its jambs on the wall's inner face, the unit vector into the room, and where its leaf turns.
struct DoorPlace {
  Vec2 start, end, inward, hinge,
      jamb;      ///< the leaf turns about `hinge` from `jamb` (closed) to hinge + width · opening
  Vec2 opening;  ///< unit vector of the open leaf
};
/// Nothing when the door's wall does not exist or has no length.
std::optional<DoorPlace> door_place(const scene::Space& space, const scene::Door& door);
/// The quarter disc that the leaf sweeps, as a closed path on the page.
Path swing_zone(const DoorPlace& door, const Frame& frame);

struct WallStyle {
  double thickness = 0.1;  ///< metres
  double line = 1;         ///< width of fine lines, points
  bool door_zones = false;
  std::span<const std::string> blocked_doors;  ///< ids, drawn as problems
};
/// Floor, walls, holes.
void draw_walls(Drawing& drawing, const Frame& frame, const scene::Space& space, const WallStyle& style);
/// Doors and windows, over the walls and the furniture.
void draw_openings(Drawing& drawing, const Frame& frame, const scene::Space& space, const WallStyle& style);

}  // namespace inhabit::render
