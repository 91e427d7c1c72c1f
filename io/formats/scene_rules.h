#pragma once
#include "scene/scene.h"

/// What must hold between the parts of a scene, beyond the form of each; `where` is a JSON pointer.
namespace inhabit::io {
using namespace scene;

/// Doors and windows are within their walls, holes within the outline. Requires: simple, counter-clockwise rings.
/// `turned`: the outline was clockwise and doors and windows still have the walls' numbers of before; errors use them.
Status check_space(const Space& space, bool turned);
/// Nothing stands on itself, what is fixed has a position, and all else fits into the room in some orientation.
Status check_objects(const Scene& scene);
/// No group contains itself and nothing is in two groups.
Status check_groups(const Scene& scene);
/// No two populations, sources or goals share a name; no source ends before it begins.
Status check_crowd(const Crowd& crowd);

/// Numbers doors' and windows' walls anew after the outline's corners 1 … n-1 were put in reverse order. Requires: they
/// are within their walls.
void turn_walls(Space& space);
/// The number that wall `wall` of `walls` gets by that.
inline int turned_wall(int wall, std::size_t walls) { return static_cast<int>(walls) - 1 - wall; }

}  // namespace inhabit::io
