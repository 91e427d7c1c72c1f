#pragma once
#include "scene/scene.h"

namespace inhabit::session {
using namespace scene;

/// Constraints by what things are, for rooms whose document states none (a home of Sweet Home 3D): cupboards and beds
/// at the wall, seats at their tables, sofas towards the television, free depth before doors and drawers. Scenes with
/// constraints and objects with a clearance keep what they have.
Scene with_house_rules(Scene scene);

}  // namespace inhabit::session
