#pragma once
#include "crowd/model.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

class SocialForce {
 public:
  using Parameters = scene::SocialForceModel;
  explicit SocialForce(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  Parameters parameters_;
};
static_assert(Model<SocialForce>);

}  // namespace inhabit::crowd
