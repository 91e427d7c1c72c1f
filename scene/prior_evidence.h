#pragma once
#include "scene/priors.h"

/// What a prior was learned from, example by example: for pictures by which a person judges it.
namespace inhabit::scene {

/// One thing at its nearest wall.
struct WallSample {
  double distance = 0, angle = 0;  ///< as in WallMode
  int room = 0;                    ///< of Priors::rooms
  int mode = 0;                    ///< of KindPrior::wall
};

/// The examples behind one KindPrior, in the order of rooms and objects.
struct KindEvidence {
  std::vector<WallSample> wall;
  std::vector<std::array<double, 4>> free_depth;  ///< seen in front of each face, metres, at most kLookDepth
};
inline constexpr double kLookDepth = 4;

struct PairSample {
  double distance = 0, bearing = 0, facing = 0;  ///< as in PairMode
  int room = 0, mode = 0;
  int first = 0;  ///< number of the first, among all of its kind in all rooms
};

/// The examples behind one PairPrior.
struct PairEvidence {
  std::vector<PairSample> samples;
  Vec2 first_size, second_size;  ///< mean width and depth, to draw them
};

}  // namespace inhabit::scene
