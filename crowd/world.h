#pragma once
#include <string>
#include <vector>

#include "crowd/walls.h"
#include "scene/scene.h"

/// What of a scene stands still while people walk.
namespace inhabit::crowd {

/// People bump into what stands between these heights above the floor, metres.
constexpr double kStepHeight = 0.15, kBodyHeight = 1.8;

/// Outline, holes and furniture of a scene as floor that people can walk on.
struct World {
  Vec2 origin;                ///< what agents' floats are relative to: the middle of the outline
  std::vector<Floor> floors;  ///< in the scene's coordinates, largest first
  Walls walls;                ///< relative to the origin

  Vec2 to_scene(float x, float y) const { return origin + Vec2{x, y}; }
};

/// The floor is the outline without the holes and without the footprint of every object that stands, lies or hangs
/// between kStepHeight and kBodyHeight; rugs and whatever else is walked on are floor, and objects without a position
/// are not there. Walls are closed, doors included, but for the doors that somebody uses: where the area of a goal or a
/// source reaches through a door, a doorway as wide as the door and as deep as that area is floor too. `reach`: how far
/// models ask about walls, metres. Errors: no floor is left.
Result<World> make_world(const scene::Scene& scene, double reach);

}  // namespace inhabit::crowd
