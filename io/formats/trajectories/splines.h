#pragma once
#include <array>
#include <string_view>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// Row by row; takes (x, y, 1) of an image to metres on the ground times a scale.
using Homography = std::array<double, 9>;
/// Nine numbers. Errors: others, or a matrix that loses a dimension.
Result<Homography> read_homography(std::string_view text);

/// UCY's splines (.vsp, Lerner 2007): per person the number of control points, then `x y frame gaze`; pixels from the
/// middle of the image, y upwards, 25 frames per second. Metres come from the homography alone, which is applied to the
/// control points; between them people move evenly. Requires: a homography, else the error asks for it.
bool is_splines(std::string_view bytes);
Result<RawTrajectories> read_splines(std::string_view bytes, const Homography* ground_from_image);

}  // namespace inhabit::io
