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

/// Objects without a position are not there. `reach`: how far models ask about walls, metres.
Result<World> make_world(const scene::Scene& scene, double reach);

}  // namespace inhabit::crowd
