#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/rng.h"
#include "scene/priors.h"

/// What learned priors ask of the objects of one scene: which of the clustered means each of them gets, who belongs to
/// whom, what carries what. The one translation of a priors file: annealing makes cost terms of it, the position-based
/// solver constraints (session/).
namespace inhabit::annealing {
using namespace core;
using namespace scene;

constexpr std::uint32_t kNobody = 0xffffffffu;

/// One object and what is wanted of it.
struct ObjectTarget {
  const KindPrior* prior = nullptr;  ///< null: nothing is known of its kind
  std::optional<WallMode> wall;      ///< the cluster that it got
  Face back = Face::back;            ///< the face that stands to the wall
  std::array<double, 4> access{};    ///< free depth in front of each face: the scene's clearance, else the prior's
  std::optional<View> view;          ///< the scene's, else the prior's
  Mount mount = Mount::floor;
  std::uint32_t carrier = kNobody;      ///< what it stands on; kNobody: the floor, a wall or the ceiling
  std::vector<std::uint32_t> carriers;  ///< what it may stand on instead, in order of number, `carrier` included
};

/// One object that stands to another as learned.
struct PairTarget {
  std::uint32_t first = 0, second = 0;
  PairMode mode;
  bool concentric = false;  ///< at any bearing, evenly spaced with the others round `first`
};

struct Targets {
  std::vector<ObjectTarget> objects;  ///< one per object of the scene
  std::vector<PairTarget> pairs;      ///< by first
  std::vector<std::string> warnings;  ///< for people: kinds that nobody has seen, weak priors, nothing to stand on
};

/// Yu et al. 2011, 3.2: "we can assign one of the clustered means" to each object. Each gets a wall mode with the
/// mode's share as its chance; those who gather round one object share out the pair's modes in proportion (four chairs
/// of a table with four places get a place each). The same seed gives the same targets. Keeps pointers into `priors`.
Targets choose_targets(const Scene& scene, const Priors& priors, std::uint64_t seed);

/// How much a mean angle says: 1 while the examples agree to 30 degrees, 0 when they are spread by 90 or more.
double angle_strength(double deviation);

}  // namespace inhabit::annealing
