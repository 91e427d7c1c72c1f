#include "scene/crowd_models.h"

namespace inhabit::scene {

PbdModel PbdModel::of_preset(Preset preset) {
  PbdModel model;
  model.preset = static_cast<Choice>(preset);
  return model;
}

}  // namespace inhabit::scene
