#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// Vadere's footsteps (postvis.traj): columns whose names hold pedestrianId, simTime, startX, startY and perhaps
/// endTime, endX, endY. Metres and seconds; one row per step, so positions between them are interpolated.
bool is_vadere(std::string_view bytes);
Result<RawTrajectories> read_vadere(std::string_view bytes);

}  // namespace inhabit::io
