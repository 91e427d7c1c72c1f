#pragma once
#include <vector>

#include "geometry/convex.h"
#include "scene/scene.h"

/// The border of a space as the solver meets it: walls to be pushed back by, and solid holes.
namespace inhabit::scene {

struct Wall {
  Vec2 a, b;
  Vec2 along;   ///< unit, from a to b
  Vec2 normal;  ///< unit, into the room
  double length = 0;
  double angle = 0;     ///< of the normal, radians
  bool reflex = false;  ///< corner a is a reflex one
};

struct WallPoint {
  Vec2 point;
  double distance = 0;  ///< signed: negative outside
  std::uint32_t wall = 0;
};

class Room {
 public:
  Room(const Ring& outline, const std::vector<Ring>& holes);
  explicit Room(const Space& space);

  const std::vector<Wall>& walls() const { return walls_; }
  bool convex() const { return convex_; }
  Vec2 center() const { return center_; }
  double area() const { return area_; }
  const Bounds& extent() const { return bounds_; }
  const Ring& outline() const { return outline_; }
  /// Inside the outline and outside every hole.
  bool contains(Vec2 p) const;
  /// The nearest point of the walls, or of wall `only`; ties go to the first wall.
  WallPoint nearest_wall(Vec2 p, std::optional<int> only = {}) const;

  /// How far the box has to move along `normal` to satisfy one wall, reflex corner or hole: the papers' boundary
  /// constraint (TVCG 3.3.7). Calls f(normal, depth) for every one violated, in wall order; f may move the box, which
  /// it is given by reference, between the calls.
  template <class F>
  void for_each_violation(const Box& box, F&& f) const {
    if (convex_) {
      // In no direction does a box reach farther than its halves together.
      const double most = box.half_depth + box.half_width;
      for (const Wall& w : walls_) {
        const double distance = dot(box.center - w.a, w.normal);
        if (distance >= most) continue;
        const double depth = box.extent(w.normal) - distance;
        if (depth > 0) f(w.normal, depth);
      }
    } else {
      concave_violations(box, f);
    }
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      const double reach = box.radius() + hole_radius_[h];
      const Vec2 d = box.center - hole_center_[h];
      if (dot(d, d) >= reach * reach) continue;
      const Separation s = separation(box, holes_[h]);
      if (s.depth > 0) f(s.normal, s.depth);
    }
  }

 private:
  template <class F>
  void concave_violations(const Box& box, F&& f) const;
  /// The push that frees the box of wall k that cuts it; depth 0 when it does not.
  Separation wall_push(const Box& box, std::size_t k) const;

  Ring outline_;
  std::vector<Wall> walls_;
  std::vector<Ring> holes_;  ///< convex parts
  std::vector<Vec2> hole_center_;
  std::vector<double> hole_radius_;
  std::vector<Ring> hole_rings_;
  bool convex_ = true;
  Vec2 center_;
  double area_ = 0;
  Bounds bounds_;
};

template <class F>
void Room::concave_violations(const Box& box, F&& f) const {
  const double r = box.radius();
  bool cut = false;
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const Wall& w = walls_[k];
    const double t = dot(box.center - w.a, w.along);
    if (t < -r || t > w.length + r || std::abs(dot(box.center - w.a, w.normal)) > r) continue;
    const Separation s = wall_push(box, k);
    if (s.depth > 0) cut = true, f(s.normal, s.depth);
  }
  if (!cut && !geometry::contains(outline_, box.center)) {
    // Wholly outside: back over the nearest wall.
    const Nearest n = nearest_on_ring(outline_, box.center);
    const Wall& w = walls_[n.side];
    f(w.normal, n.distance + box.extent(w.normal));
  }
}

/// A door in its wall: the jamb nearer to the wall's first corner, the direction along the wall and into the room.
struct DoorFrame {
  Vec2 jamb, along, inward;
};
/// Nothing when the room has no such wall.
std::optional<DoorFrame> frame(const Space& space, const Door& door);

}  // namespace inhabit::scene
