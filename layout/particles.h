#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "scene/room.h"
#include "scene/scene.h"

/// The solver's view of a scene: oriented particles and the boxes that they carry.
namespace inhabit::layout {
using namespace scene;

/// A point that rides on a particle: the object itself, an object inside a rigid group, or (kGroup set) a group that is
/// not rigid, which has no state of its own: its position is the centre of mass of its particles.
struct Anchor {
  static constexpr std::uint32_t kGroup = 0x80000000u;
  std::uint32_t body = 0;
  std::uint32_t rider = kBody;  ///< which of Bodies::riders; kBody: the particle itself
  static constexpr std::uint32_t kBody = 0xffffffffu;
  bool group() const { return (body & kGroup) != 0; }
  std::uint32_t index() const { return body & ~kGroup; }
};

/// What never changes about a particle while a layout is solved.
struct BodyData {
  double w = 0;        ///< inverse mass; 0 when its position is pinned
  bool turns = false;  ///< false when its heading is pinned
  double mass = 1;
  std::uint32_t first_box = 0, boxes = 0;
  double area = 0;    ///< of all its boxes
  double radius = 0;  ///< of the circle about its position that holds every box
};

/// What never changes about an object's box.
struct BoxData {
  std::uint32_t body = 0, object = 0;
  Vec2 offset;
  double turn = 0;
  double half_depth = 0, half_width = 0, radius = 0;
  double low = 0, high = 0;  ///< z range
  std::uint64_t off = 0;     ///< sets whose members do not collide with each other
  std::uint64_t sphere = 0;  ///< sets that collide as circles
  bool at_wall = false;      ///< held to a wall by a constraint
};

/// Particles of a group that is not rigid.
struct GroupData {
  std::vector<std::uint32_t> bodies;
  double mass = 0, w = 0;
};

/// A place on a particle, in its frame.
struct Rider {
  Vec2 offset;
  double turn = 0;
};

struct Bodies {
  std::vector<Rider> riders;
  std::vector<BodyData> bodies;
  std::vector<BoxData> boxes;
  std::vector<GroupData> groups;
};

/// Where every particle is. Boxes follow their particle.
struct State {
  struct Body {
    Vec2 p;
    Vec2 front{1, 0};
    double angle = 0;
  };
  const Bodies* data = nullptr;
  const Room* room = nullptr;
  /// When set, every other particle counts as pinned: one object is fitted to the rest.
  std::uint32_t solo = kNobody;
  static constexpr std::uint32_t kNobody = 0xffffffffu;
  std::vector<Body> bodies;
  std::vector<Box> boxes;
  std::vector<Pose> frames;  ///< of each group that is not rigid: how far its curve has been carried along

  State(const Bodies& d, const Room& r)
      : data(&d), room(&r), bodies(d.bodies.size()), boxes(d.boxes.size()), frames(d.groups.size()) {}

  Vec2 position(const Anchor& a) const {
    if (a.group()) return group_position(a.index());
    const Body& b = bodies[a.body];
    return a.rider == Anchor::kBody ? b.p : b.p + rotate(data->riders[a.rider].offset, b.front);
  }
  double angle(const Anchor& a) const {
    if (a.group()) return frames[a.index()].angle;
    return a.rider == Anchor::kBody ? bodies[a.body].angle
                                    : wrap_angle(bodies[a.body].angle + data->riders[a.rider].turn);
  }
  Vec2 front(const Anchor& a) const {
    return !a.group() && a.rider == Anchor::kBody ? bodies[a.body].front : direction(angle(a));
  }
  double w(const Anchor& a) const {
    if (solo != kNobody && a.body != solo) return 0;
    return a.group() ? data->groups[a.index()].w : data->bodies[a.body].w;
  }
  double mass(const Anchor& a) const { return a.group() ? data->groups[a.index()].mass : data->bodies[a.body].mass; }
  bool turns(const Anchor& a) const {
    if (solo != kNobody && a.body != solo) return false;
    return a.group() ? w(a) > 0 : data->bodies[a.body].turns;
  }

  void shift(const Anchor& a, Vec2 d) {
    if (a.group()) return shift_group(a.index(), d);
    shift(a.body, d);
  }
  void shift(std::uint32_t body, Vec2 d) {
    const BodyData& b = data->bodies[body];
    bodies[body].p += d;
    for (std::uint32_t k = 0; k < b.boxes; ++k) boxes[b.first_box + k].center += d;
  }
  void turn(const Anchor& a, double by) {
    if (a.group()) return turn_group(a.index(), by);
    place(a.body, bodies[a.body].p, wrap_angle(bodies[a.body].angle + by));
  }
  void place(std::uint32_t body, Vec2 p, double angle) { place(body, p, angle, direction(angle)); }
  void place(std::uint32_t body, Vec2 p, double angle, Vec2 front);

  Vec2 group_position(std::uint32_t group) const;
  void shift_group(std::uint32_t group, Vec2 d);
  void turn_group(std::uint32_t group, double by);
};

}  // namespace inhabit::layout
