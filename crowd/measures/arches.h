#pragma once
#include <optional>
#include <span>
#include <vector>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// Somebody at a moment: metres, metres per second.
struct Standing {
  Vec2 at;
  double radius = 0.25, speed = 0;
};

/// An opening in a straight wall that goes on at either end of it, for as long as the crowd is wide. The crowd stands
/// to the left of the way from `from` to `to`.
struct Opening {
  Vec2 from, to;
};

struct ArchOptions {
  double touch = 0.05;   ///< two touch when their gap is at most this share of their radii's sum
  double slow = 0.7;     ///< metres per second: who is faster bears no arch
  double thick = 2;      ///< of a ring, in diameters of the widest
  double step = 0.25;    ///< metres from one ring to the next
  double farthest = 10;  ///< inner radius of the last ring, in half widths of the opening
};

/// A half ring of people who bear each other before an opening.
struct Arch {
  double radius = 0;                ///< inner radius of its ring about the opening's middle, metres
  double speed = 0;                 ///< mean of its people's, metres per second
  std::vector<std::size_t> people;  ///< from the wall on the side of `from` to the wall on the side of `to`
};

/// The innermost arch: the smallest ring about the middle of the opening, no smaller than half its width, in which a
/// chain of slow people, each touching the next, leads from the wall on one side of the opening to the wall on the
/// other; of several chains one of the fewest people. Nothing when there is none.
///
/// The definition is ours: papers speak of arches when they see half rings of people before an exit. As chains stay in
/// a ring that the opening does not reach, none is a straight row across it; in a packed crowd at rest there is one
/// at half the width already, in a flowing one farther out or nowhere.
std::optional<Arch> innermost_arch(std::span<const Standing> crowd, const Opening& opening,
                                   const ArchOptions& options = {});

}  // namespace inhabit::crowd
