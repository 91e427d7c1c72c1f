#pragma once
#include "exemplar/observe.h"

/// How two kinds stand to each other (Yu et al. 2011, section 3.2, "pairwise relationships").
namespace inhabit::exemplar {

struct PairFound {
  PairPrior prior;
  PairEvidence evidence;
  double gap = 0;      ///< median distance between the footprints, metres
  double beside = 0;   ///< share of the seconds whose footprint is within 35 cm of their first's
  double carried = 0;  ///< share of which one stands on the other
  double steady = 0;   ///< share in modes whose distance, bearing (unless concentric) and facing hardly vary
};

/// Every `second` belongs to the `first` nearest to it (between footprints, then between centres) in its room.
/// count = 0 when the two are never in one room. Requires: the things are sorted by room.
PairFound find_pair(std::span<const Thing> things, const std::string& first, const std::string& second);

/// Pairs that the examples suggest, by first, then second: in at least 3 examples (and 2 rooms where there are several)
/// the second has a first in at least half of the rooms that it is in; their footprints are at most 0.8 m apart in the
/// median, or the first is a thing that people sit down to look at, and the second a seat that faces it; and 70 % of
/// the examples either stand within 35 cm of their first or are steady: within a mode the distance varies by less than
/// 12 cm or 15 %, facing by 25 degrees, bearing by 30. Of all firsts that a kind could belong to, the nearest; and the
/// nearest that it looks at. Rugs, what hangs, and what stands on others are not proposed, but for what is looked at;
/// neither is a thing with its carrier.
std::vector<PairFound> propose_pairs(std::span<const Thing> things, int rooms);

/// Whether things of this kind are there to be looked at: televisions, pictures, clocks, easels, white boards.
bool must_be_seen(std::string_view kind);

}  // namespace inhabit::exemplar
