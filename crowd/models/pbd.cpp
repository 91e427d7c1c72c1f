#include "crowd/models/pbd.h"

namespace inhabit::crowd {

void Pbd::step(Agents&, const Surroundings&) {}

}  // namespace inhabit::crowd
