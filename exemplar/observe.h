#pragma once
#include <array>
#include <string>
#include <vector>

#include "scene/prior_evidence.h"

/// What a furnished room shows: Yu et al. 2011, section 3.1.
namespace inhabit::exemplar {
using namespace scene;

/// A base this near to the top of something stands on it; what is flatter is walked over. Metres.
inline constexpr double kTouch = 0.03, kStep = 0.05;
/// A face this near to a wall is at the wall, metres.
inline constexpr double kAtWall = 0.15;
/// An adult: height, and the free depth that one needs at a face, metres.
inline constexpr double kAdultHeight = 1.9, kAdultDepth = 0.6;

/// One upright face of one thing.
struct FaceSeen {
  double wall = 0;  ///< from its centre to the nearest wall, metres; negative outside
  double free = 0;  ///< straight ahead to the first wall or thing over the inner 90 % of its width, at most kLookDepth
  bool at_wall = false;  ///< what ends `free` is a wall nearer than kAtWall
};

/// One thing of one room.
struct Thing {
  std::string kind;
  int room = 0;
  std::uint32_t object = 0;  ///< its index in the scene
  Pose pose;
  Vec3 size;
  double base = 0;
  std::array<FaceSeen, 4> faces;
  Mount mount = Mount::floor;
  std::string on;  ///< the carrier's kind; empty in the first tier
  bool flat = false;
  std::optional<View> view;  ///< what the scene asks for

  Box box() const { return make_box(pose, size); }
  double top() const { return base + size.z; }
};

/// Unit vector out of a face, and the face's centre.
Vec2 face_normal(const Pose& pose, Face face);
Vec2 face_center(const Pose& pose, Vec3 size, Face face);

struct Observed {
  std::vector<Thing> things;
  std::vector<std::string> skipped;  ///< what was left out, and why: one sentence each
};

/// Everything in the room that could have been put elsewhere. Left out, with a reason: things without a position or
/// with one that is no number, without size, without kind and name, and whose centre stands more than 10 cm outside
/// the outline. Left out silently: parts of the building (scene/kind.h), be they movable or not.
Observed observe(const Scene& scene, int room);

}  // namespace inhabit::exemplar
