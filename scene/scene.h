#pragma once
#include "scene/constraint_kinds.h"
#include "scene/crowd.h"

/// The scene document as plain data: what a file says, in metres and radians, with every name resolved.
namespace inhabit::scene {

struct Hole {
  std::string id;
  Ring outline;  ///< counter-clockwise as read
  Extras extras;
  friend bool operator==(const Hole&, const Hole&) = default;
};

/// An opening that people use. `from` is measured along the wall from its first corner.
struct Door {
  std::string id;
  int wall = 0;
  double from = 0, width = 0.9, height = 2.1;
  enum class Swing { in, out, none } swing = Swing::in;
  enum class Hinge { start, end } hinge = Hinge::start;  ///< which jamb the leaf turns on, along the wall
  Extras extras;
  friend bool operator==(const Door&, const Door&) = default;
};

struct Window {
  std::string id;
  int wall = 0;
  double from = 0, width = 1, sill = 0.9, height = 1.2;
  Extras extras;
  friend bool operator==(const Window&, const Window&) = default;
};

/// The room: wall k joins corner k to corner k + 1 of the outline, which runs counter-clockwise.
struct Space {
  Ring outline;
  std::vector<Hole> holes;
  double height = 2.6;
  std::vector<Door> doors;
  std::vector<Window> windows;
  Extras extras;

  std::size_t walls() const { return outline.size(); }
  Vec2 wall_start(std::size_t k) const { return outline[k]; }
  Vec2 wall_end(std::size_t k) const { return outline[(k + 1) % outline.size()]; }
  friend bool operator==(const Space&, const Space&) = default;
};

/// Free depth wanted in front of each face, metres.
struct Clearance {
  double front = 0, back = 0, left = 0, right = 0;
  bool any() const { return front > 0 || back > 0 || left > 0 || right > 0; }
  friend bool operator==(const Clearance&, const Clearance&) = default;
};

/// A cone from the centre of the front face that must stay free: `angle` is its full opening, radians.
struct View {
  double distance = 0, angle = 0;
  friend bool operator==(const View&, const View&) = default;
};

enum class Mount { floor, wall, ceiling };
/// What a user has pinned in the room; unlike `fixed` it is no property of the thing.
enum class Lock { none, position, angle, both };

struct Object {
  std::string id, kind, name;
  Vec3 size{0.5, 0.5, 0.5};      ///< width across the front, depth front to back, height
  std::optional<Vec3> position;  ///< centre of the footprint, height of the base; absent: anywhere
  std::optional<double> angle;   ///< where the front faces; absent: any
  std::optional<double>
      elevation;  ///< height of the base while there is no position; absent: on what carries it, or by its mount
  bool fixed = false;
  Lock lock = Lock::none;
  Clearance clearance;
  std::optional<View> view;
  Mount mount = Mount::floor;
  Ref on;                      ///< what carries it
  std::optional<double> mass;  ///< absent: the box's volume
  std::string model;
  Extras extras;
  friend bool operator==(const Object&, const Object&) = default;
};

/// Members are pulled onto the segment, or the circular arc about `center` that runs counter-clockwise from start to
/// end.
struct Curve {
  enum class Kind { segment, arc } kind = Kind::segment;
  Vec2 start, end, center;
  bool medial_axis = false;  ///< a segment without end points: the medial axis of the group's bounding box
  friend bool operator==(const Curve&, const Curve&) = default;
};

/// Objects and groups that belong together; a particle of its own. In a rigid group the members' positions and angles
/// give its shape, and the whole starts at random unless the group itself has a `position`.
struct Group {
  std::string id;
  std::vector<Ref> members;
  bool rigid = false;
  std::optional<double> spacing;  ///< equal distance between neighbours along the curve
  std::optional<Curve> curve;
  std::optional<Vec2> position;
  std::optional<double> angle;
  Extras extras;
  friend bool operator==(const Group&, const Group&) = default;
};

struct Scene {
  std::string name;
  Space space;
  std::vector<Object> objects;
  std::vector<Group> groups;
  Constraints constraints;
  bool house_rules = false;  ///< nobody asked for the constraints: they are the usual ones by kind, and may be missed
  Crowd crowd;
  std::uint64_t seed = 1;
  Extras extras;

  /// The id of what a reference points at; "" for none.
  const std::string& id_of(Ref ref) const {
    static const std::string kNone;
    switch (ref.kind) {
      case Ref::Kind::object:
        return objects[ref.index].id;
      case Ref::Kind::group:
        return groups[ref.index].id;
      case Ref::Kind::door:
        return space.doors[ref.index].id;
      case Ref::Kind::none:
        break;
    }
    return kNone;
  }
  friend bool operator==(const Scene&, const Scene&) = default;
};

}  // namespace inhabit::scene
