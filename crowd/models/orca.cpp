#include "crowd/models/orca.h"

namespace inhabit::crowd {

void Orca::step(Agents&, const Surroundings&) {}

}  // namespace inhabit::crowd
