#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace inhabit::io {

/// What ProcTHOR's asset database knows of a model: its box at rotation 0, and its kind as `tv_stand`.
struct Asset {
  scene::Vec3 size;
  std::string kind;
};
using Assets = std::map<std::string, Asset, std::less<>>;

/// asset-database.json of ProcTHOR: {type: [{assetId, boundingBox {x, y, z}}]}.
core::Result<Assets> read_procthor_assets(std::string_view text);

/// A ProcTHOR house (schema 1.0.0), or one house per line; `line` picks one of them, from 1 (0: all). Every room
/// becomes a scene: floorPolygon is the outline, doors and windows lie in its walls, children stand `on` their parents.
///
/// Unity's axes (x right, y up, z ahead, turns clockwise seen from above) become ours by (x, z, y) and angle = 90 -
/// yaw. The front of a model looks along its own +z: of the 2536 pieces in the 500 one-room test houses that belong at
/// a wall (beds, dressers, fridges, desks, counters, sofas, pictures and so on) 2454 have their -z face there, 54 a
/// side face and none the +z face. Holes are measured from the first corner of their wall's polygon: so measured
/// nothing stands before any of the 500 doors, measured from the other end something does 154 times. Tilts about other
/// axes than the vertical are left out (extra `x-tilt`).
core::Result<std::vector<scene::Scene>> read_procthor(std::string_view text, const Assets& assets,
                                                      std::size_t line = 0);

}  // namespace inhabit::io
