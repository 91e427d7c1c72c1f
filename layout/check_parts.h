#pragma once
#include "layout/check.h"
#include "layout/solids.h"

/// The parts of a check, one question each; check.h says what they answer.
namespace inhabit::layout {

/// At most so many overlaps are listed: a hundred thousand objects in one heap would have billions.
constexpr std::size_t kMostOverlaps = 200000;

struct OverlapFindings {
  std::vector<CheckReport::Overlap> list;  ///< deepest first
  std::size_t count = 0, exempt = 0, rigid = 0, pinned = 0;
};
OverlapFindings find_overlaps(const Solids& solids, bool all_collisions);

struct OutsideFindings {
  std::vector<CheckReport::Outside> list;  ///< deepest first; without the missing objects
  std::size_t pinned = 0;                  ///< not listed: what cannot move
};
OutsideFindings find_outside(const Solids& solids, int threads);

std::vector<CheckReport::BlockedDoor> find_blocked_doors(const Solids& solids);
std::vector<CheckReport::BlockedClearance> find_blocked_clearances(const Solids& solids, int threads);
std::vector<CheckReport::BlockedView> find_blocked_views(const Solids& solids, int threads);

struct ReachFindings {
  CheckReport::Reachable reachable;
  double walkable_share = 0, cell = 0;
};
/// Requires: the outline encloses an area.
ReachFindings find_reach(const Solids& solids);

/// True when a person bumps into the solid: higher than a step, and not above their head.
inline bool blocks_person(const Solid& solid) { return solid.top > kStepHeight && solid.base < kPersonHeight; }

}  // namespace inhabit::layout
