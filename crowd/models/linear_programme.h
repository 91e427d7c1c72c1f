#pragma once
#include <span>
#include <vector>

#include "geometry/vec2.h"

/// Linear programmes in the plane, the n-body part of ORCA [vandenBerg11 sec. 5].
namespace inhabit::crowd {
using namespace geometry;

/// The points v with n.v >= c; n is a unit vector.
struct HalfPlane {
  Vec2 n;
  double c = 0;
};

/// How far v is outside (negative: inside), in the units of v.
inline double violation(const HalfPlane& h, Vec2 v) { return h.c - dot(h.n, v); }

/// Solves the programmes of one agent after the other; keeps its memory between them.
class LinearProgramme {
 public:
  /// The v nearest to `wish` among those in every half plane and with |v| <= longest         [vandenBerg11 sec. 5.1]
  /// When there is none: the v that the worst of the half planes from `hard` on is violated least, by the
  /// three-dimensional programme of section 5.3, among those in the first `hard` ones; when those alone contradict
  /// each other, they are treated like the others. Half planes are taken in the order given (the paper shuffles them):
  /// the cost is O(n^2) at worst, the result depends on the order by rounding alone.
  Vec2 solve(std::span<const HalfPlane> planes, std::size_t hard, Vec2 wish, double longest);

 private:
  Vec2 least_violation(std::span<const HalfPlane> planes, std::size_t hard, Vec2 v, double longest);
  std::vector<HalfPlane> projected_;
};

/// The point of the disc |v| <= longest in all half planes that is nearest to `wish`, or, when `direction`, farthest in
/// the direction of the unit vector `wish`. Returns whether there is one; if not, v is the optimum of the half planes
/// before the first that leaves nothing.
struct PlaneOptimum {
  Vec2 v;
  bool feasible = true;
};
PlaneOptimum optimum(std::span<const HalfPlane> planes, Vec2 wish, double longest, bool direction);

}  // namespace inhabit::crowd
