#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// The pedestrian records of PTV Viswalk: `$VISION`, comments after `*`, then `$PEDESTRIAN:NO;SIMSEC;COORDCENTX;…`.
/// Metres and seconds.
bool is_viswalk(std::string_view bytes);
Result<RawTrajectories> read_viswalk(std::string_view bytes);

}  // namespace inhabit::io
