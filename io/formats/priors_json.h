#pragma once
#include <string>
#include <string_view>

#include "core/result.h"
#include "scene/priors.h"

/// The priors file (docs/priors.md).
namespace inhabit::io {

/// Reads and checks a whole file. Errors say where: a JSON pointer, or line and column of malformed JSON. An error is
/// also what contradicts itself: a kind or a pair twice, a pair both ways round, things that carry each other, a pair
/// without a way to stand. Kinds and pairs are sorted by name, their modes by count.
core::Result<scene::Priors> read_priors(std::string_view text);

/// Reading it gives the same priors and writing that gives the same bytes. The weights are always there, so that they
/// can be edited; all else that equals a default is left out.
std::string write_priors(const scene::Priors& priors);

}  // namespace inhabit::io
