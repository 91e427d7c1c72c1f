#pragma once
#include <span>

#include "annealing/cells.h"
#include "annealing/furniture.h"
#include "geometry/containment.h"

/// Where everything is: the state phi of Yu et al. 4.1, with the pathways' control points and who carries whom.
namespace inhabit::annealing {

/// An oriented box between two heights.
struct Solid {
  Box box;
  double low = 0, high = 0;
};
/// Both z ranges share more than a millimetre, as `check` counts it.
inline bool share_height(const Solid& a, const Solid& b) {
  return std::min(a.high, b.high) - std::max(a.low, b.low) > 1e-3;
}

/// A set of numbers that is emptied at no cost.
class Stamps {
 public:
  explicit Stamps(std::size_t n = 0) : at_(n) {}
  void clear() { ++now_; }
  /// False when it was in already.
  bool insert(std::size_t i) {
    if (at_[i] == now_) return false;
    at_[i] = now_;
    return true;
  }
  bool contains(std::size_t i) const { return at_[i] == now_; }

 private:
  std::vector<std::uint64_t> at_;
  std::uint64_t now_ = 1;
};

using ControlPoints = std::array<Vec2, 2>;  ///< P1 and P2 of the Bezier curve

class Arrangement {
 public:
  /// Everything at its given place; what has none at the room's centre. Keeps a reference to the furniture.
  explicit Arrangement(const Furniture& furniture);

  const Furniture& furniture() const { return *f_; }
  const Solid& body(std::uint32_t i) const { return bodies_[i]; }
  double angle(std::uint32_t i) const { return angles_[i]; }
  Vec2 position(std::uint32_t i) const { return bodies_[i].box.center; }
  std::uint32_t carrier(std::uint32_t i) const { return carrier_[i]; }
  const Solid& space(std::uint32_t s) const { return spaces_[s]; }
  const ControlPoints& points(std::uint32_t path) const { return points_[path]; }

  /// Everything that a move touches: these items and all that they carry, at most two families that change places, or
  /// one pathway. Between touch() and settle() or undo() the places may be changed.
  void touch(std::uint32_t item);
  void touch_path(std::uint32_t path);
  bool touched(std::uint32_t item) const { return moving_.contains(item); }
  std::span<const std::uint32_t> touched_items() const { return touched_; }
  /// How many of the touched items belong to the first of two families.
  std::size_t first_family() const { return first_family_; }
  std::uint32_t touched_path() const { return touched_path_; }

  /// Moves a touched item with all that it carries.
  void place(std::uint32_t item, Vec2 p, double angle);
  /// Puts a carried item on another carrier; its base goes with it. Its place is changed by place().
  void carry(std::uint32_t item, std::uint32_t carrier);
  void set_points(std::uint32_t path, const ControlPoints& points);

  void settle();  ///< the changes stay
  void undo();    ///< the changes are taken back, to the bit

  /// Calls f(item) once for each item, none of the touched ones, whose box may meet `box`.
  template <class F>
  void for_bodies_near(const Box& box, F&& f) const {
    near_.clear();
    body_cells_.visit(body_cells_.range(geometry::bounds(box)), [&](std::uint32_t i) {
      if (!moving_.contains(i) && near_.insert(i)) f(i);
    });
  }
  /// Calls f(space) once for each space, none of the touched ones, that may meet `box`.
  template <class F>
  void for_spaces_near(const Box& box, F&& f) const {
    near_spaces_.clear();
    space_cells_.visit(space_cells_.range(geometry::bounds(box)), [&](std::uint32_t s) {
      if (!touches_space(s) && near_spaces_.insert(s)) f(s);
    });
  }

  /// What an annealer keeps of the best state.
  struct Snapshot {
    std::vector<Vec2> positions;
    std::vector<double> angles;
    std::vector<std::uint32_t> carriers;
    std::vector<ControlPoints> points;
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
  };
  Snapshot snapshot() const;
  void restore(const Snapshot& s);

 private:
  bool touches_space(std::uint32_t s) const;
  void collect(std::uint32_t item);
  void set(std::uint32_t item, Vec2 p, double angle, Vec2 front);
  void place_spaces(std::uint32_t item);
  void place_path(std::uint32_t path);
  void set_base(std::uint32_t item, double low);
  void adopt(std::uint32_t item, std::uint32_t carrier);

  const Furniture* f_;
  std::vector<Solid> bodies_, spaces_;
  std::vector<double> angles_;
  std::vector<std::uint32_t> carrier_;
  std::vector<std::vector<std::uint32_t>> carried_;  ///< by each item, sorted
  std::vector<ControlPoints> points_;
  Cells body_cells_, space_cells_;
  std::vector<Cells::Range> body_range_, space_range_;

  struct Undo {
    Solid body;
    double angle = 0;
    std::uint32_t carrier = kNobody;
  };
  std::vector<std::uint32_t> touched_;
  std::size_t first_family_ = 0;
  std::uint32_t touched_path_ = kNobody;
  Stamps moving_;
  std::vector<Undo> undo_;
  std::vector<Solid> undo_spaces_;
  ControlPoints undo_points_{};
  mutable Stamps near_, near_spaces_;
};

using BezierCurve = std::array<Vec2, 4>;
/// The rectangles along a pathway, of equal steps in the curve's parameter.
std::array<Box, kPathParts> path_boxes(const BezierCurve& curve, double width);

}  // namespace inhabit::annealing
