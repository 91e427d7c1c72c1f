#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "annealing/targets.h"
#include "core/lists.h"
#include "scene/room.h"

/// A scene and its targets made ready for annealing: compiled once, shared by all chains, never changed.
namespace inhabit::annealing {

/// One object. Faces and angles are relative to the front that its prior's back face fixes.
struct Item {
  double half_depth = 0, half_width = 0, radius = 0, height = 0;  ///< radius: b_i of Yu et al.
  bool moves = false, turns = false;
  bool hung = false;      ///< on a wall
  bool attached = false;  ///< rides rigidly on what carries it (a member of a rigid group on the group's first)
  bool carried = false;   ///< second tier: its base is on its carrier's top
  double low = 0;         ///< base of what is not carried
  double back_turn = 0;   ///< heading of the face opposite to the back face, from the front
  double back_half = 0;   ///< from the centre to the back face
  bool has_wall = false;
  double wall_distance = 0, wall_angle = 0, wall_angle_strength = 1;
};

/// Floor that others stay out of (Yu et al. eq. 4, 5): in front of a face, a part of a view, a door's swing, a part of
/// a pathway.
struct Space {
  enum class Kind : std::uint8_t { access, view, path } kind = Kind::access;
  std::uint32_t owner = kNobody;  ///< the item it rides on; kNobody: it stands in the room
  Box local;                      ///< in the owner's frame, or in the room
  double radius = 0;              ///< half diagonal, ad_jk and vd_jk of Yu et al.
  double low = 0, high = 0;       ///< z range above the owner's base, or the floor
};

/// Two items that belong together.
struct Relation {
  std::uint32_t first = 0, second = 0;
  double distance = 0, bearing = 0, facing = 0;
  double bearing_strength = 1, facing_strength = 1;
};

/// Those who stand round one item at any bearing, evenly spaced.
struct Circle {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> seconds;
};

/// A pathway from door to door: a cubic Bezier curve (Yu et al. 4.3) from just inside the one to just inside the other.
struct Path {
  Vec2 from, to, from_inward, to_inward;
  std::uint32_t first_space = 0;  ///< of kPathParts
};
constexpr std::uint32_t kPathParts = 8;

/// Weights of all terms. Deviation: the paper has none of the last two; its accessible spaces alone keep bodies apart,
/// mostly (fig. 8c), while "bodies must not intersect" and must stay in the room, or there is nothing to furnish.
struct Weights {
  CostWeights learned;               ///< Yu et al. eq. 8
  double overlap = 20, inside = 20;  ///< per metre of depth
};

struct Furniture {
  const Scene* scene = nullptr;
  Room room;
  std::vector<Item> items;
  std::vector<Space> spaces;
  std::vector<Relation> relations;
  std::vector<Circle> circles;
  std::vector<Path> paths;
  Weights weights;
  double path_width = 0.8;
  core::Lists<std::uint32_t> spaces_of, relations_of, circles_of;  ///< of each item
  std::vector<std::vector<std::uint32_t>> carriers;                ///< of each item: what may carry it
  std::vector<std::uint32_t> carrier;                              ///< of each item at the start
  std::vector<std::uint32_t> walkers;                              ///< items that can be moved on their own
  std::vector<double> wall_sums;                                   ///< length of the walls up to each one's end

  /// Bodies that may intersect: their scene or a rigid group says so.
  bool may_overlap(std::uint32_t i, std::uint32_t j) const { return apart_[i * items.size() + j]; }
  /// Belong together, so that one may stand in the other's free space: a chair at its desk.
  bool bound(std::uint32_t i, std::uint32_t j) const { return bound_[i * items.size() + j]; }

  std::vector<bool> apart_, bound_;
  explicit Furniture(const Scene& s) : scene(&s), room(s.space) {}
};

/// Errors: a rigid group without its members' places; an object larger than the room; one that stands on itself.
Result<Furniture> compile(const Scene& scene, const Targets& targets, const Weights& weights);

}  // namespace inhabit::annealing
