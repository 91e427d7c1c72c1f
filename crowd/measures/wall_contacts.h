#pragma once
#include "crowd/measures/overlaps.h"

namespace inhabit::crowd {

/// Discs against the walls of the walkable ground.
struct WallContacts {
  std::size_t outside = 0;  ///< fixes whose centre is off the ground by more than the tolerance
  std::size_t touching =
      0;             ///< fixes whose disc reaches into a wall by more than the tolerance, those outside included
  int people = 0;    ///< different people among `touching`
  double worst = 0;  ///< deepest reach into a wall, metres: radius - distance, or radius + distance when outside
  double worst_seconds = 0;
  std::int32_t who = 0;
};
/// Nothing can be touched when no walkable ground is known.
WallContacts wall_contacts(const Recording& recording, const Radii& radii, int threads = 0, double tolerance = 1e-6);

}  // namespace inhabit::crowd
