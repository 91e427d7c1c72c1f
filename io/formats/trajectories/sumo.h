#pragma once
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// SUMO's floating car data (--fcd-output): the persons of `<fcd-export><timestep time><person id x y>`, metres and
/// seconds. Their names become numbers, in order of appearance unless they are numbers already.
bool is_sumo(std::string_view bytes);
Result<RawTrajectories> read_sumo(std::string_view bytes);

}  // namespace inhabit::io
