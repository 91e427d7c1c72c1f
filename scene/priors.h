#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

/// What furnished rooms teach about kinds of furniture, as plain data: the priors file (Yu et al. 2011, section 3).
/// Learned by exemplar/, read and edited by people, used by annealing/ as cost terms and by layout/ as constraints.
/// Metres and radians; counts say how much evidence there is, so that a prior of one example is seen to be weak.
namespace inhabit::scene {

/// The four upright faces, in the order of every array over faces (and of Accessibility's choices).
enum class Face : std::uint8_t { back, left, front, right };
inline constexpr std::array<std::string_view, 4> kFaceNames = {"back", "left", "front", "right"};

/// The kind under which an object is learned and looked up: what the scene calls it, in lower-case words without digits
/// ("Bedside_Table" gives "bedside table"); by its name where it has no kind. "" when it has neither.
std::string prior_kind(const Object& object);

/// One way in which a kind stands at walls: the mean of one cluster of examples. The paper clusters distance and angle
/// apart; here they are clustered together, since an example that stands off the wall is also the one that is turned.
/// Walls are the sides of the outline; a pillar is none.
struct WallMode {
  double distance = 0;  ///< from the back face's centre to the nearest wall, m (the paper: from the centre, which would
                        ///< depend on the object's depth)
  double angle = 0;     ///< of the direction opposite to KindPrior::back, from the nearest wall's inward normal; 0 =
                        ///< back to the wall. For the usual back that direction is the object's heading
  double distance_deviation = 0, angle_deviation = 0;  ///< standard deviation, and circular standard deviation
  int count = 0;                                       ///< examples in it; its weight is its share of all of them
  friend bool operator==(const WallMode&, const WallMode&) = default;
};

/// What carries a kind: the floor or a wall (first tier), or another kind (second tier).
struct Support {
  Mount mount = Mount::floor;
  std::string on;  ///< the carrier's kind; empty: the mount says where
  int count = 0;
  friend bool operator==(const Support&, const Support&) = default;
};

/// What is known about one kind of furniture.
struct KindPrior {
  std::string kind;
  int count = 0;                   ///< examples seen
  int rooms = 0;                   ///< in so many rooms
  Face back = Face::back;          ///< which face stood nearest to a wall: the object's front is opposite to it
  double back_share = 1;           ///< the share of examples in which it did
  std::vector<WallMode> wall;      ///< most frequent first; empty: nothing learned, no prior
  std::vector<Support> support;    ///< most frequent first
  std::array<double, 4> access{};  ///< free depth in front of each face, 0 for one that need not be reached
  std::optional<View> view;        ///< the front must be seen
  double elevation = 0;            ///< mean height of the base of what hangs on a wall
  bool by_hand = false;            ///< written by a person, not learned
  friend bool operator==(const KindPrior&, const KindPrior&) = default;
};

/// One way in which `second` stands to `first`: the mean of one cluster of examples. Headings are those of the scene,
/// whatever KindPrior::back says.
struct PairMode {
  double distance = 0;  ///< between the centres
  double bearing = 0;   ///< of the second's centre, from the first's heading
  double facing = 0;    ///< heading of the second, from the direction to the first: 0 = looks at it
  double distance_deviation = 0, bearing_deviation = 0, facing_deviation = 0;
  int count = 0;
  friend bool operator==(const PairMode&, const PairMode&) = default;
};

/// How two kinds stand to each other. Each `second` belongs to one `first`, the nearest in the examples.
struct PairPrior {
  std::string first, second;
  std::vector<PairMode> modes;  ///< most frequent first
  double per_first = 1;         ///< how many `second` gather round one `first`, on average
  bool concentric = false;      ///< they stand round it at any bearing, evenly spaced (chairs round a table); the
                                ///< modes' bearings then mean nothing
  int count = 0, rooms = 0;
  double spread = 0;     ///< of the distance within the modes, over their mean: the smaller, the steadier
  bool by_hand = false;  ///< named by the user; otherwise proposed from the examples
  friend bool operator==(const PairPrior&, const PairPrior&) = default;
};

/// Weights of the cost terms (Yu et al. 2011, eq. 8).
struct CostWeights {
  double accessibility = 0.1, visibility = 0.01, pathway = 0.1;
  double wall_distance = 1, wall_angle = 10, pair_distance = 1, pair_angle = 10;
  friend bool operator==(const CostWeights&, const CostWeights&) = default;
};

struct Priors {
  std::vector<KindPrior> kinds;  ///< by name
  std::vector<PairPrior> pairs;  ///< by first, then second
  CostWeights weights;
  std::vector<std::string> rooms;  ///< what was learned from
  Extras extras;

  /// The prior of a kind, or null.
  const KindPrior* of(std::string_view kind) const {
    for (const KindPrior& prior : kinds)
      if (prior.kind == kind) return &prior;
    return nullptr;
  }
  friend bool operator==(const Priors&, const Priors&) = default;
};

}  // namespace inhabit::scene
