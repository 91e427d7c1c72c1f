#pragma once
#include <filesystem>

#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// What a file of trajectories may leave open. What is given here counts more than what the file says.
struct TrajectoryOptions {
  std::optional<LengthUnit> unit;
  std::optional<double> frame_rate;  ///< frames per second, in (0, 10000]
  std::filesystem::path homography;  ///< for splines in pixels: 3x3 matrix from the image to metres
};

/// Frames in the place of times: of the rate asked for, the file's own, or what the times suggest. Times between frames
/// and events are interpolated, which a remark says. Errors: a person at two places at once, too many frames.
Status frames_from_times(RawTrajectories& raw, std::optional<double> frame_rate);

/// Trajectories in metres, sorted, each person once per frame. Remarks: people renumbered, rows given twice, gaps,
/// steps faster than 3 m/s, an unlikely median speed. Errors: nothing in it; contradicting rows; unit or frame rate
/// unknown, with what would make the median speed one of walking.
Result<scene::Trajectories> checked_trajectories(RawTrajectories raw, const TrajectoryOptions& options);

}  // namespace inhabit::io
