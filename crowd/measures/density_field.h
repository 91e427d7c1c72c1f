#pragma once
#include "crowd/measures/voronoi_density.h"

namespace inhabit::crowd {

/// Voronoi density and speed at the points of a raster, averaged over time [PedPy's Voronoi profiles]: at a point, the
/// density 1/A_i of whoever's cell it lies in, 0 where nobody's cell reaches.
struct DensityField {
  Vec2 origin;  ///< lower left corner
  double cell = 0.2;
  int columns = 0, rows = 0;
  std::vector<float> density;  ///< people per square metre; kUnknown off the ground. Row 0 lies at the lowest y
  std::vector<float> speed;    ///< metres per second, weighted by time; kUnknown where nobody's cell ever was
  std::size_t frames = 0;      ///< how many were averaged
  float most() const;          ///< largest density
};
struct FieldOptions {
  double cell = 0.2;              ///< metres; wider when there would be more than 250,000
  std::size_t most_frames = 300;  ///< evenly spread over the recording
  int threads = 0;
};
/// Over the bounds of the ground, or of the people when the ground has none.
DensityField density_field(const Recording& recording, const VoronoiGround& ground, std::span<const double> speed,
                           const FieldOptions& options = {});

}  // namespace inhabit::crowd
