#pragma once
#include <vector>

#include "geometry/polygon.h"

/// How far a box stands outside a floor that may have reflex corners and holes.
namespace inhabit::geometry {

/// The closed floor inside `outline` and outside the interiors of `holes`, with the bounds of each ring.
/// Made by make_floor; the outline is simple and every hole lies inside it.
struct Floor {
  Ring outline;
  std::vector<Ring> holes;
  Bounds outline_bounds;
  std::vector<Bounds> hole_bounds;
};

Floor make_floor(Ring outline, std::vector<Ring> holes);

/// Square metres without the holes.
double area(const Floor& floor);

/// True on the floor and on its border.
bool contains(const Floor& floor, Vec2 p);

/// Distance from p to the floor, metres; 0 on it.
double outside_distance(const Floor& floor, Vec2 p);

/// How deep the segment ab pokes into the box: the largest distance from one of its points inside the box to the box's
/// border. 0 when the segment misses the box or only touches it.
double poke_depth(const Box& box, Vec2 a, Vec2 b);

/// How far the box is from standing on the floor, metres: the larger of
///   max |p - floor| over the box's four corners and its centre, and
///   max |q - border of the box| over the points q of the floor's border that lie inside the box.
/// The first says how far the box sticks out through a wall, the second how deep a reflex corner, a pillar or the edge
/// of a partition sticks into the box, be it wholly inside. 0 exactly when the box lies on the closed floor: a box that
/// does not is either crossed by the floor's border or, centre and all, outside. Cost: one bounds test per side when
/// the box is far from all of them, and one point location.
double outside_depth(const Floor& floor, const Box& box);

/// The axis-parallel bounds of an oriented box.
Bounds bounds(const Box& box);

inline bool meet(const Bounds& a, const Bounds& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace inhabit::geometry
