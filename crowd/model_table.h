#pragma once
#include <variant>

#include "crowd/models/orca.h"
#include "crowd/models/pbd.h"
#include "crowd/models/power_law.h"
#include "crowd/models/social_force.h"

namespace inhabit::crowd {

/// Every model; this line is the only registration there is. In the order of scene::CrowdModels.
using Models = std::variant<Pbd, PowerLaw, SocialForce, Orca>;

}  // namespace inhabit::crowd
