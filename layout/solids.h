#pragma once
#include <vector>

#include "geometry/box_grid.h"
#include "geometry/containment.h"
#include "layout/relations.h"
#include "scene/room.h"

namespace inhabit::layout {

/// An object where it stands: its box in plan, and its base and top.
struct Solid {
  std::uint32_t object = 0;
  Box box;
  double base = 0, top = 0;

  /// True when the z ranges share more than `least` metres.
  bool shares_height(double low, double high, double least = 1e-3) const {
    return std::min(top, high) - std::max(base, low) > least;
  }
};

/// What every part of a check reads. Keeps a reference to the scene.
struct Solids {
  explicit Solids(const Scene& scene);

  const Scene& scene;
  Floor floor;
  Relations relations;
  std::vector<Solid> list;  ///< the objects that have a position, in order
  BoxGrid grid;             ///< over `list`

  const Object& object(const Solid& solid) const { return scene.objects[solid.object]; }
  const std::string& id(const Solid& solid) const { return object(solid).id; }
};

}  // namespace inhabit::layout
