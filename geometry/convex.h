#pragma once
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace inhabit::geometry {

/// How to part a box from a convex, counter-clockwise ring: like separation() of two boxes; normal points from the ring
/// to the box. Requires: at least three corners.
Separation separation(const Box& box, std::span<const Vec2> convex);

/// The ring cut into convex, counter-clockwise parts: itself when it is convex, otherwise triangles of its constrained
/// Delaunay triangulation, joined where the union stays convex. Requires: a simple ring.
std::vector<Ring> convex_parts(std::span<const Vec2> ring);

bool is_convex(std::span<const Vec2> ring);

/// The smallest convex ring round the points, counter-clockwise, without corners that do not turn (Andrew's monotone
/// chain). Fewer than three corners when all points lie on a line.
Ring convex_hull(std::vector<Vec2> points);

/// The ring counter-clockwise.
Ring counter_clockwise(Ring ring);

}  // namespace inhabit::geometry
