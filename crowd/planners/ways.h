#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "crowd/planners/corners.h"
#include "crowd/planners/place.h"

/// The shortest ways to one goal, or to the nearest of several, from everywhere: what each corner costs from there on.
namespace inhabit::crowd {

class Ways {
 public:
  static constexpr std::uint32_t kNone = Corners::kNone;

  /// Requires: `corners` outlives the ways; the places are areas.
  Ways(const Corners& corners, const std::vector<const Place*>& places);

  /// What somebody heads for: a node's circle, or (from corners.nodes() on) a landing, a way straight to the goal.
  struct Choice {
    std::uint32_t target = kNone;
    double length = std::numeric_limits<double>::infinity();  ///< metres to the goal
  };
  /// The shortest way from p. `before`: the choice so far, kept while it is not longer by more than a hundredth.
  /// Infinite when there is no way. Cost: a few lines of sight, and a bound for every corner.
  Choice choose(Vec2 p, std::uint32_t before = kNone) const;

  /// The next bit of the way.
  struct Step {
    Vec2 direction;  ///< unit vector
    Vec2 towards;    ///< as far as that direction goes
    std::uint32_t target =
        kNone;  ///< what is headed for now: the next one after a corner is passed; kNone: choose anew
  };
  /// A target that was chosen from p itself is headed for; one from before may have been passed since, and the next may
  /// then be out of sight.
  Step step(Vec2 p, std::uint32_t target, bool chosen_now) const;
  /// True while the way to a target from p is in sight.
  bool in_sight(Vec2 p, std::uint32_t target, Vec2 towards) const;

  /// What is left from a node's circle at a turn; infinite when no way goes on from there.
  double left(std::uint32_t node, double turn) const;

 private:
  /// The border of the aims as far as it is on the floor, a body away from walls, and outside the corners' circles.
  struct Piece {
    Vec2 a, b;
  };
  /// Where a circle is left, best first among those not yet passed.
  struct Exit {
    double turn = 0;
    double cost = 0;  ///< from turn 0 on to the goal, metres; the smallest from here on
    std::uint32_t to = kNone;
    double leaves = 0;  ///< turn of the exit that `cost` and `to` are of
  };
  struct Landing {
    Vec2 at;
    double length = std::numeric_limits<double>::infinity();
  };

  void find_pieces(const std::vector<const Place*>& places, bool areas, double body);
  void search();
  const Exit* exit_after(std::uint32_t node, double turn) const;
  Landing landing(Vec2 p, std::uint32_t index) const;
  Choice choose(Vec2 p, std::uint32_t before, Corners::Leaving leaving) const;

  const Corners* corners_;
  std::vector<Piece> pieces_;
  std::vector<double> least_;  ///< per node: added to the distance from its corner, no way over it is shorter
  std::vector<std::uint32_t> first_exit_;
  std::vector<Exit> exits_;  ///< of each node, by turn
};

}  // namespace inhabit::crowd
