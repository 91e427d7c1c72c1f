#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "crowd/world.h"

/// The ways of a disc round the reflex corners of a floor. The shortest way of a disc's middle consists of straight
/// pieces and arcs about such corners: the straight pieces touch the circles that they join (the reduced visibility
/// graph of the floor shrunk by a disc).
namespace inhabit::crowd {

/// A corner that sticks into the floor, and the circle on which people pass it.
struct Corner {
  Vec2 at;
  Vec2 normal;     ///< into the floor, of the wall that ends here (floor on its left)
  Vec2 middle;     ///< of the fan
  double fan = 0;  ///< angle from `normal`, clockwise, to the normal of the wall that begins here
  double radius =
      0;  ///< metres; at least a body's, at most the clearance asked for, nearly half the gap where that is less
  std::uint64_t blocked = 0;  ///< of 64 equal parts of the fan: no body fits there
};

/// A node is a corner passed in one sense: 2 * corner + 0 clockwise (corner on the right), + 1 counter-clockwise. The
/// `turn` of a point on its circle is the angle by which somebody there has turned round the fan in that sense.
constexpr std::uint32_t corner_of(std::uint32_t node) { return node / 2; }
constexpr double sense_of(std::uint32_t node) { return node % 2 != 0 ? 1.0 : -1.0; }

/// Circles of equal radii are touched within their fans. A wider one beside a narrower sticks out over the wall that
/// joins them, and is touched this much beside its fan at most, radians.
constexpr double kBesideFan = 0.8;

/// A straight way from circle to circle.
struct Tangent {
  std::uint32_t from = 0, to = 0;  ///< nodes
  double from_turn = 0, to_turn = 0, length = 0;
};

/// How a circle is reached from, or left for, a point.
struct Touch {
  Vec2 at;            ///< on the circle
  Vec2 direction;     ///< of the motion there
  double turn = 0;    ///< radians; may lie outside 0 … fan
  double length = 0;  ///< metres between the point and `at`
};

class Corners {
 public:
  Corners() = default;
  /// `body`: metres from walls that nobody's middle gets nearer than; `clearance`: metres to corners where there is
  /// room. Cost O(n^2) lines of sight for n corners.
  Corners(const World& world, double body, double clearance, int threads);

  std::span<const Corner> all() const { return corners_; }
  double body() const { return body_; }
  std::size_t nodes() const { return 2 * corners_.size(); }
  std::span<const Tangent> tangents() const { return tangents_; }
  /// Indices of the tangents that end at a node.
  std::span<const std::uint32_t> into(std::uint32_t node) const {
    return {into_.data() + first_into_[node], into_.data() + first_into_[node + 1]};
  }

  /// How to reach the circle of a node from p. From inside the circle: straight out, and on along it.
  Touch arrive(std::uint32_t node, Vec2 p) const;
  /// How to leave it for q. Nothing from inside the circle.
  std::optional<Touch> leave(std::uint32_t node, Vec2 q) const;
  /// The turn of the point of the circle that lies from its middle in the direction n.
  double turn_of(std::uint32_t node, Vec2 n) const;
  /// True when a body fits everywhere on the circle between two turns.
  bool arc_clear(std::uint32_t node, double from, double to) const;

  /// True when the straight way from a to b crosses no wall and enters no corner's circle except those of the nodes
  /// `from` and `to`. A circle that a is in may be left outwards, or anywhere; `no_circles`: walls alone count.
  enum class Leaving { outwards, anywhere, no_circles };
  bool clear(Vec2 a, Vec2 b, std::uint32_t from, std::uint32_t to, Leaving leaving = Leaving::outwards) const;
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// True inside a corner's circle.
  bool in_circle(Vec2 p) const;
  /// True on a floor.
  bool on_floor(Vec2 p) const;
  /// The point of the walls nearest to p. Requires: walls.
  Vec2 nearest_wall(Vec2 p) const;
  struct Wall {
    Vec2 a, b;
  };
  std::span<const Wall> walls() const { return walls_; }

 private:
  void find_corners(const World& world);
  double gap_at(std::uint32_t corner, double most) const;
  void fit_radii(double body, double clearance);
  void find_blocked(double body);
  void build_grid();
  std::vector<Tangent> tangents_from(std::uint32_t corner) const;
  template <class F>
  void for_each_near(Vec2 p, double reach, F&& f) const;
  template <class F>
  bool any_cell(Vec2 a, Vec2 b, F&& f) const;

  double body_ = 0;
  std::vector<Floor> floors_;
  std::vector<Wall> walls_;
  std::vector<Corner> corners_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> walls_of_;  ///< per corner: the wall that ends, that begins
  std::vector<Tangent> tangents_;
  std::vector<std::uint32_t> first_into_, into_;
  Vec2 low_;
  double cell_ = 1;
  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_, items_;  ///< per cell: walls, then corners (numbered after the walls)
};

}  // namespace inhabit::crowd
