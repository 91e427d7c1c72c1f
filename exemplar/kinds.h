#pragma once
#include <span>

#include "exemplar/observe.h"

/// What the examples say about one kind by itself (Yu et al. 2011, sections 3.1 and 3.2).
namespace inhabit::exemplar {

using Things = std::span<const Thing* const>;

/// Which upright face stands to the wall, by the examples' votes. A thing within half a metre of a wall votes for its
/// own back unless another face is nearer to a wall by more than 5 cm. The back stays the back unless three quarters of
/// at least three votes are for one other face: what stands in the middle of rooms decides nothing.
struct BackVote {
  Face face = Face::back;
  double share = 1;  ///< of the votes; 1 when there are none
};
BackVote vote_back(Things things);

/// Free depth wanted in front of a face: 0 for one that is at a wall in every example; else what three quarters of the
/// other examples keep, at most an adult's 0.6 m; less than 0.1 m is 0. Nobody walks up to what hangs, lies flat or
/// stands on something else: 0.
double access_depth(Things things, Face face);

/// How a thing stands to the side of the outline that is nearest to the centre of its `back` face; `mode` is 0.
WallSample wall_sample(const Thing& thing, Face back, const Scene& scene);

struct KindFound {
  KindPrior prior;
  KindEvidence evidence;
};
/// Requires: all of one kind, at least one; `rooms` are what they were observed in, by Thing::room.
KindFound find_kind_prior(Things things, std::span<const Scene> rooms);

}  // namespace inhabit::exemplar
