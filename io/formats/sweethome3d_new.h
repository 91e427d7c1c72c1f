#pragma once
#include <string>
#include <vector>

#include "io/formats/sweethome3d.h"

/// Pieces of Home.xml for what was no piece before.
namespace inhabit::io::sh3d {

/// An object as a `<pieceOfFurniture>` without a model: Sweet Home 3D shows a box. Requires: it has a position and an
/// angle.
std::string box_element(const scene::Object& object, const std::string& level);

/// The archive with this Home.xml, without what went stale, and without references to content that it does not hold.
Result<Sh3dFile> packed(const std::string& archive, const std::string& xml, const std::vector<std::string>& entries);

}  // namespace inhabit::io::sh3d
