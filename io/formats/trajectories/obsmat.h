#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// BIWI's obsmat.txt (Pellegrini 2009; also UCY's): eight columns `frame id x z y vx vz vy`, metres and metres per
/// second. The frame rate follows from the velocities; rows are 0.4 s apart where those leave it open.
bool is_obsmat(std::string_view bytes);
Result<RawTrajectories> read_obsmat(std::string_view bytes);

}  // namespace inhabit::io
