#pragma once
#include <span>

#include "io/formats/trajectories/raw.h"

/// Walkable areas as trajectories carry them: well-known text, metres, in the frame of the positions.
namespace inhabit::io {

/// Adds the areas of `wkt` to those of `raw`; text that is none becomes a remark.
void take_walkable(std::string_view wkt, RawTrajectories& raw);
/// POLYGON, or MULTIPOLYGON for several; shortest digits.
std::string walkable_text(std::span<const scene::Area> areas);

}  // namespace inhabit::io
