#include "crowd/models/power_law.h"

namespace inhabit::crowd {

void PowerLaw::step(Agents&, const Surroundings&) {}

}  // namespace inhabit::crowd
