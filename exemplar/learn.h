#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/prior_evidence.h"

/// Furnished rooms become priors: Yu et al. 2011, section 3.2.
namespace inhabit::exemplar {
using namespace scene;

struct LearnOptions {
  /// Pairs that the user names, first and second; their relation is learned whether it is steady or not.
  std::vector<std::pair<std::string, std::string>> pairs;
  bool propose = true;  ///< and pairs that stand near and steadily in the examples
};

struct Learned {
  Priors priors;
  std::vector<KindEvidence> kinds;  ///< as many as priors.kinds, in their order
  std::vector<PairEvidence> pairs;  ///< as many as priors.pairs
  std::vector<std::string> notes;   ///< what was left out, and what is weak: one sentence each, for people
  int things = 0;
};

/// Learns from rooms; a room's name is its scene's. The same rooms in the same order give the same priors.
/// - Lengths are rounded to 0.1 mm and angles to 0.01 degrees, so that the file is readable.
/// - Rooms with nothing in them are left out with a note.
/// - Errors: no room, no room with anything placed in it, a named pair whose kinds are in no room or never together.
Result<Learned> learn(std::span<const Scene> rooms, const LearnOptions& options = {});

}  // namespace inhabit::exemplar
