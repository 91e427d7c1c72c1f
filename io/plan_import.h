#pragma once
#include <string>
#include <vector>

#include "geometry/overlay.h"
#include "scene/scene.h"

/// What the readers of floor plans share: from rings that programs drew to spaces that a scene document allows.
namespace inhabit::io {
using namespace scene;

/// A text as JSON, for extras.
std::string json_text(std::string_view text);

/// True when the area is just as a scene wants it: simple, counter-clockwise, holes inside and apart from nothing.
bool is_clean(const Area& area);
/// The same area, counter-clockwise and without a repeated last corner or equal neighbours.
Area tidied(Area area);

/// Scenes of the areas: clean ones corner for corner, others repaired by GEOS, which may split them (then they carry
/// `x-repaired`). All are moved by the same whole number of metres to the origin when they lie in a national grid,
/// which the extra `x-origin` keeps. Errors: nothing left, or coordinates that are no metres.
Result<std::vector<Scene>> scenes_of(std::vector<Area> areas, std::string_view name);

/// A door or window as a plan draws it: a thin polygon in or on a wall.
struct DrawnOpening {
  Ring outline;
  bool window = false;
};
/// Puts the openings that lie within `reach` metres of a wall and along it into the space, at least 0.4 m wide. Returns
/// how many it took.
std::size_t add_openings(Space& space, const std::vector<DrawnOpening>& openings, double reach);

}  // namespace inhabit::io
