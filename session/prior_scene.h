#pragma once
#include "annealing/arrange.h"
#include "scene/scene.h"

/// Learned priors as constraints of a scene: the one translation by which both ways of furnishing, and the check of
/// what they made, ask for the same.
namespace inhabit::session {
using namespace scene;

/// The scene with free space, views, carriers, wall and pair constraints where it does not say so itself. They are
/// wishes (`house_rules`): what was seen in other rooms need not fit into this one. Constraints that the scene has
/// stay.
Scene with_targets(const Scene& scene, const annealing::Targets& targets);

/// Adds zones along the curves that furniture keeps out of: a pathway constraint that may bend.
void add_path_zones(Scene& scene, std::span<const annealing::BezierCurve> paths, double width);

/// The shortest free way for pathways in the empty room, by annealing their control points alone.
std::vector<annealing::BezierCurve> empty_room_paths(const Scene& scene, std::uint64_t seed, double width);

}  // namespace inhabit::session
