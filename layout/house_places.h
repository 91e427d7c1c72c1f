#pragma once
#include <vector>

#include "scene/scene.h"

/// Where people put one thing relative to another.
namespace inhabit::layout {
using namespace scene;

/// A place beside a thing, in its frame: `at` is (to the front, to the left) of its centre, `turn` the heading there.
struct Place {
  Vec2 at;
  double turn = 0;
};

/// Which sides of a table people sit at.
enum class Sides { front, around };

/// `count` seats of one size at `gap` from the edge of a table, looking at it: one on its longer side, two opposite
/// each other, more along the long sides first, then at the ends. Fewer when no more have room.
std::vector<Place> seats(const Vec3& table, const Vec3& seat, Sides sides, std::size_t count, double gap);

/// Both sides of the back end: of a bed's head, of a sofa.
std::vector<Place> flanks(const Vec3& thing, const Vec3& beside);

/// Before both ends of a sofa, looking across its front at each other.
std::vector<Place> wings(const Vec3& sofa, const Vec3& chair);

/// In front of its middle, so far away.
Place before(const Vec3& thing, const Vec3& other, double gap);

}  // namespace inhabit::layout
