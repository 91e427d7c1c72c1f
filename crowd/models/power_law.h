#pragma once
#include "crowd/model.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

class PowerLaw {
 public:
  using Parameters = scene::PowerLawModel;
  explicit PowerLaw(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  Parameters parameters_;
};
static_assert(Model<PowerLaw>);

}  // namespace inhabit::crowd
