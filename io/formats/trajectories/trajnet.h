#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// TrajNet++ (Kothari 2020): one JSON object per line, `{"track": {"f", "p", "x", "y"}}` in metres and
/// `{"scene": {"fps", …}}`, whose rate is that of the rows. Predictions are left out.
bool is_trajnet(std::string_view bytes);
Result<RawTrajectories> read_trajnet(std::string_view bytes);

}  // namespace inhabit::io
