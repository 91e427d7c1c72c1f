#pragma once
#include "crowd/model.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

class Orca {
 public:
  using Parameters = scene::OrcaModel;
  explicit Orca(const Parameters& parameters) : parameters_(parameters) {}
  void step(Agents& agents, const Surroundings& around);

 private:
  Parameters parameters_;
};
static_assert(Model<Orca>);

}  // namespace inhabit::crowd
