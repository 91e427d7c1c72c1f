#pragma once
#include "scene/scene.h"

/// How homes are furnished, for scenes that do not say.
namespace inhabit::layout {
using namespace scene;

/// Adds the usual constraints by kind (scene/kind.h): beds and wardrobes with their back to a wall, chairs gathered
/// round tables, the sofa turned to the television, bedside tables at beds, free space in front of what opens. They are
/// wishes of moderate weight: furnished real rooms satisfy most of them.
///
/// A scene that declares constraints of its own, other than collision and stacking, is left as it is. Things that are
/// fixed and members of rigid groups get no rules of their own, but others gather round them. An object's own clearance
/// is kept.
void add_house_rules(Scene& scene);

}  // namespace inhabit::layout
