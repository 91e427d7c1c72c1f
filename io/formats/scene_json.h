#pragma once
#include <string>
#include <string_view>

#include "scene/scene.h"

/// The scene document (docs/scene.schema.json).
namespace inhabit::io {

/// Reads and checks a whole document. Errors say where: a JSON pointer, or line and column of malformed JSON. A
/// clockwise outline is turned round, and with it the wall numbers, so that doors, windows and constraints stay at
/// their walls.
core::Result<scene::Scene> read_scene(std::string_view text);

/// The document of a scene: what equals a default is left out, degrees are rounded to 1e-9. Reading it gives the same
/// scene and writing that gives the same bytes. Requires: references point at what exists.
std::string write_scene(const scene::Scene& scene);

}  // namespace inhabit::io
