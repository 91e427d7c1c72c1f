#pragma once
#include <optional>

#include "geometry/polygon.h"

namespace inhabit::crowd {
using namespace geometry;

/// The relative velocities that lead to a collision within tau: a cone with its tip cut off.
///
///   VO = { v | exists t in [0, tau] : t v in S + D(0, r) }                                     [vandenBerg11
///   sec. 4.1, 5.4]
///
/// where S is the segment ab, seen from the agent (for another agent a = b, the way to its centre) and D the disc of
/// the radii's sum. Its border is smooth: the near side of (S + D) / tau, the cut-off, and two tangents from the
/// origin, the legs. Requires: the origin is farther than r from S, and not on the right of ab.
struct VelocityObstacle {
  Vec2 a, b;
  double r = 0, tau = 1;
  /// What is at the right end a and at the left end b: nothing more (the VO ends with a leg); another segment that the
  /// agent faces, so that this end is no way out; or one that turns towards the agent: the cut-off line goes on.
  enum class End { free, closed, corner } right = End::free, left = End::free;
};

/// A point of a border and the unit normal there, outwards.
struct BorderPoint {
  Vec2 point, normal;
};

/// The point of the border that is nearest to v, inside or outside; of two equally near legs the right one. Nothing
/// when v is past an end that is closed: the next segment's business.
std::optional<BorderPoint> nearest_border(const VelocityObstacle& obstacle, Vec2 v);

/// The same for another agent: S is the point x.
BorderPoint nearest_border(Vec2 x, double r, double tau, Vec2 v);

}  // namespace inhabit::crowd
