#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

/// Homes of Sweet Home 3D: `.sh3d` archives and bare `Home.xml` files, one scene per room, and back.
///
/// Frame: the plan's x to the right, y down, centimetres, positive angles clockwise on the screen; ours y up, metres,
/// counter-clockwise: x = x_cm / 100, y = -y_cm / 100, and the front (+depth there) faces angle = -a - 90 degrees.
namespace inhabit::io {
using namespace core;

/// A home as read: every byte of it is kept, so that writing changes nothing but the furniture that moved.
struct Sh3dHome {
  std::string archive;               ///< the .sh3d zip; empty when the input was Home.xml alone
  std::string xml;                   ///< Home.xml, UTF-8
  std::vector<std::string> entries;  ///< names of the archive's entries, in its order
};

/// What a home holds, as scenes. Where every piece went can be added up: pieces = objects + doors + windows of the
/// scenes (a door between two rooms counts twice there) + `outside` + `hidden`.
struct Sh3dRooms {
  std::vector<scene::Scene> scenes;   ///< one per `<room>`, in document order
  std::vector<std::string> outside;   ///< pieces, doors and windows that no room contains, by name and place
  std::vector<std::string> hidden;    ///< `visible='false'`: not in a scene, kept in the file
  std::vector<std::string> warnings;  ///< what was changed to make a room of a polygon
  std::size_t pieces = 0;             ///< furniture, lights, doors and windows of the home; groups count their members
};

/// A .sh3d file written.
struct Sh3dFile {
  std::string bytes;  ///< the .sh3d archive
  std::string xml;    ///< Home.xml alone, with all references to content: what Sweet Home 3D's own examples are
  std::size_t moved = 0, added = 0;
  std::vector<std::string> warnings;  ///< what had to be left out, for people
};

/// Reads the archive or the XML and checks every number in it. Nothing is ever extracted to disk. Errors name the
/// entry, line and column. An old .sh3d without Home.xml (Java serialisation only) is an error that says so.
Result<Sh3dHome> open_sh3d(std::string bytes);

/// One scene per room. The outline is the room's polygon, cut back to the inner wall faces where it reaches under a
/// wall by more than a centimetre; where the plan is open the outline's side is a wall to us, though nothing is built
/// there. Walls that stand free in the room are holes. Things that do not move in the home (`movable='false'`), stairs,
/// curtains and other parts of the building are fixed. Rugs and what else lies on the floor below 3 cm are a
/// millimetre high, so that they collide with nothing; the file keeps their height.
Result<Sh3dRooms> read_rooms(const Sh3dHome& home);

/// The scenes of read_rooms alone.
Result<std::vector<scene::Scene>> rooms(const Sh3dHome& home);

/// The home with the objects of `furnished` (scenes that came from it) where these scenes have them: x, y, angle and
/// elevation of exactly the pieces that moved are replaced in the original text, and objects that are new are added as
/// boxes; every other byte of Home.xml and every other entry is kept. When Home.xml changes, the stale Java `Home` and
/// `ContentDigests` entries are dropped, and references to content that the archive does not hold are removed, because
/// Sweet Home 3D refuses a file with such a reference. Doors, windows and walls are never changed.
Result<Sh3dFile> write_sh3d(const Sh3dHome& home, std::span<const scene::Scene> furnished);

/// A home of one level and one room for a scene that never was one: walls, doors, windows, and every placed object as a
/// box.
Result<Sh3dFile> write_sh3d_new(const scene::Scene& scene);

}  // namespace inhabit::io
