#include "crowd/models/social_force.h"

namespace inhabit::crowd {

void SocialForce::step(Agents&, const Surroundings&) {}

}  // namespace inhabit::crowd
