#pragma once
#include "crowd/agents.h"
#include "crowd/walls.h"

namespace inhabit::crowd {

/// After a model's step, whatever the model: whoever is no longer on the floor, came there through a wall, or has a
/// position or velocity that is no number goes back to where he was before, at rest. Then everybody's kept place is
/// where he is. Returns how many were put back. Requires: kept places are on the floor.
std::size_t keep_on_floor(Agents& agents, const Walls& walls, int threads);

}  // namespace inhabit::crowd
