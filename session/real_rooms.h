#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "layout/furnish.h"
#include "scene/priors.h"
#include "session/document.h"

/// Real homes as a test of furnishing: every home is held out once, priors are learned from the others, its rooms are
/// stripped and furnished again, and what comes out is compared with what its designer did.
namespace inhabit::session {

/// One home with what the other homes teach.
struct HeldOut {
  std::string home;
  scene::Priors priors;
  std::vector<Scene> rooms;  ///< as built, those with at least `least` movable things on the floor
};
Result<std::vector<HeldOut>> held_out_homes(std::span<const Document> homes, std::size_t least = 4);

/// A way of furnishing a room whose movable things have no places.
struct RealMethod {
  std::string name;
  std::function<Result<Scene>(const Scene& stripped, const scene::Priors& priors, std::uint64_t seed)> furnish;
};
/// Without any wish (random places that collide with nothing), by the house rules, and by learned priors: projected,
/// annealed, and annealed and then projected. All from random starts; `base` has the solver's options, its seed is not
/// used.
std::vector<RealMethod> real_methods(const layout::Options& base);

/// Values by what they are of: a kind, or a pair of kinds.
using Features = std::map<std::string, std::vector<double>>;

/// How the movable things on the floor of some rooms stand.
struct RoomFeatures {
  Features wall_distance, wall_angle;   ///< metres; degrees from 0 (back to the wall) to 180
  Features pair_distance, pair_facing;  ///< metres; degrees from 0 (looks at it) to 180

  void add(const RoomFeatures& other);
};
/// The pairs are those of `priors`; every second with its nearest first, as learning counts them.
RoomFeatures room_features(const Scene& room, const scene::Priors& priors);

/// What check says of a room whose things ask for the free depth that `priors` has for their kinds.
struct RoomQuality {
  int rooms = 0, feasible = 0, doors_free = 0, all_reachable = 0;
  double walkable_share = 0;         ///< summed
  int faces = 0, faces_blocked = 0;  ///< faces that ask for depth, and those of which more than a tenth is not free
  void add(const Scene& room, const scene::Priors& priors);
};

/// Mean difference between two distributions, key by key, weighted by the numbers in `human` (Wasserstein's first
/// distance: the area between their distribution functions). Keys with fewer than three values in either are left out.
double difference(const Features& human, const Features& other);

}  // namespace inhabit::session
