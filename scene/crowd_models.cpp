#include "scene/crowd_models.h"

namespace inhabit::scene {

PbdModel PbdModel::of_preset(Preset preset) {
  PbdModel model;
  model.preset = static_cast<Choice>(preset);
  if (preset == Preset::game) return model;
  model.far = 1;
  model.relaxation_time = 0.12;
  model.static_friction = model.kinetic_friction = 0;
  model.headway = 2.2, model.headway_length = 0.11, model.headway_breadth = 1.05;
  model.anticipation = 0.7, model.sidestep = 70, model.hesitation = 0.3;
  return model;
}

}  // namespace inhabit::scene
