#pragma once
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace inhabit::io {

/// GeoJSON (RFC 7946): FeatureCollection, Feature or bare geometry. Every polygon becomes a scene, named after the
/// feature's `name`; everything else is left out.
///
/// WGS84 longitude and latitude, which RFC 7946 demands, are assumed unless `crs` names another system, a number is
/// beyond 180 or 90, or the plan would be wider than 0.2 degrees; otherwise the numbers are metres. Degrees are
/// projected about the middle (lon0, lat0) of the plan's bounds, x = N cos(lat0) (lon - lon0), y = M (lat - lat0), with
/// the ellipsoid's radii of curvature N and M; at d metres north or south of the middle the error of an east-west
/// length l is l d tan(lat0) / N: 0.3 mm per metre at 1 km and 60 degrees. The extra `x-origin` keeps {"lon": …, "lat":
/// …}.
///
/// WRLD indoor maps (property `type`): every room, bathroom, hallway and unit becomes a scene, and so does every piece
/// of at least 1.5 square metres that these, walls, doors, windows, stairs, lifts and inaccessible spaces leave of the
/// building_outline: on many floors nobody drew the rooms. Doors and windows that touch a room's outline become its
/// own.
core::Result<std::vector<scene::Scene>> read_geojson(std::string_view text);

}  // namespace inhabit::io
