#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// Numbers without any header, four columns or more: `id frame x y [z]` as the old Juelich files have it, or TrajNet's
/// `frame id x y`: the one in which people move least between rows. Neither the unit nor the frame rate is in the file.
bool is_columns(std::string_view bytes);
Result<RawTrajectories> read_columns(std::string_view bytes);

}  // namespace inhabit::io
