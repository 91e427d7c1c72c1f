#pragma once
#include <span>

#include "render/drawing.h"
#include "scene/prior_evidence.h"

/// What was learned from furnished rooms, drawn so that a person can judge it: every example, and the clusters found
/// among them. One card for a kind or a pair.
namespace inhabit::render {

inline constexpr Vec2 kPriorCard{640, 270};

/// Wall distances as a histogram with the modes above it, headings as a rose over the wall (up is the wall's inward
/// normal), and in words what carries the kind and where people must reach it. Requires: the evidence is the prior's.
Drawing draw_kind_card(const scene::KindPrior& prior, const scene::KindEvidence& evidence);

/// Where the seconds stand round their first, whose front is up, with a tick where each one faces; and a rose of their
/// facing (up: it looks at the first).
Drawing draw_pair_card(const scene::PairPrior& prior, const scene::PairEvidence& evidence);

/// All cards on one page, pairs first, then kinds, the most frequent before the others.
Drawing draw_priors(const scene::Priors& priors, std::span<const scene::KindEvidence> kinds,
                    std::span<const scene::PairEvidence> pairs, std::string_view title);

}  // namespace inhabit::render
