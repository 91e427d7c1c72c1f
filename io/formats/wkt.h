#pragma once
#include <string_view>
#include <vector>

#include "geometry/overlay.h"
#include "scene/scene.h"

namespace inhabit::io {

/// Well-known text (OGC 06-103r4): the walkable area in metres as POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION, which
/// may be nested, with or without Z, M and a leading `SRID=…;`. Every polygon becomes one scene, in the order of the
/// file; holes are obstacles. Points and lines are no areas: they are left out and named in the extra `x-dropped`.
/// Plans in a national grid are moved to the origin (extra `x-origin`).
core::Result<std::vector<scene::Scene>> read_wkt(std::string_view text);

/// The same text as areas, left where they are: repaired where they cross themselves, counter-clockwise. Errors: not
/// one.
core::Result<std::vector<geometry::Area>> read_wkt_areas(std::string_view text);

}  // namespace inhabit::io
