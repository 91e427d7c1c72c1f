#pragma once
#include "crowd/measures/fundamental.h"

namespace inhabit::crowd {

/// People one behind the other on a straight piece of way.
struct SingleFile {
  Vec2 origin, axis{1, 0};              ///< s = (x - origin)·axis, axis a unit vector
  double from = -1e300, until = 1e300;  ///< people with s in between are measured, metres
  /// `headway`: rho = 1 / d with d the distance to the person ahead [Seyfried05 takes the same in the mean].
  /// `voronoi`: rho = 2 / (distance from the person behind to the person ahead): the cell of one dimension.
  enum class Density { headway, voronoi } density = Density::voronoi;
};

/// One point per person and frame whose neighbours needed for the density are in the recording too, at any s; `speed`:
/// one per fix, along the axis or not. Ahead is the way that the frame's people walk in the mean; frames where that is
/// unknown or nobody moves are left out, and so are people at the same s. Density per metre.
std::vector<FundamentalPoint> single_file_points(const Recording& recording, std::span<const Vec2> velocities,
                                                 const SingleFile& file, int every = 1);

}  // namespace inhabit::crowd
