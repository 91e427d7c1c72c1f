#pragma once
#include "crowd/measures/area_density.h"
#include "geometry/voronoi.h"

namespace inhabit::crowd {

/// Voronoi density and speed [Steffen10]: person i has the density 1/A_i everywhere in their cell of size A_i, and then
///
///   rho_V = 1/|M| integral over M of rho = 1/|M| sum_i |A_i ∩ M| / |A_i|
///   v_V   = sum_i v_i |A_i ∩ M| / sum_i |A_i ∩ M|
///
/// for the area M. Cells end at the walls and, if wanted, at a cut-off radius (geometry/voronoi.h).
/// Deviations: |M| is the part of M that can be walked on; v_V is divided by the covered part of M and not by |M|
/// (PedPy, JPSreport), so that ground that nobody's cell covers, which only a cut-off leaves, does not count as
/// standing still. People whose speed is unknown are left out of v_V.
struct VoronoiDensity {
  std::vector<AreaRow> rows;   ///< one per frame
  std::size_t off_ground = 0;  ///< fixes that do not lie on the ground: without a cell, left out
};
VoronoiDensity voronoi_density(const Recording& recording, const VoronoiGround& ground, const MeasureArea& area,
                               std::span<const double> speed, int threads = 0);

/// 1/A_i of every fix, people per square metre; kUnknown off the ground.
std::vector<double> individual_density(const Recording& recording, const VoronoiGround& ground, int threads = 0);

}  // namespace inhabit::crowd
