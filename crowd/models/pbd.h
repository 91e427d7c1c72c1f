#pragma once
#include "crowd/model.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

class Pbd {
 public:
  using Parameters = scene::PbdModel;
  explicit Pbd(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  Parameters parameters_;
};
static_assert(Model<Pbd>);

}  // namespace inhabit::crowd
