#pragma once
#include <optional>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// Individual velocity over a window of time:
///
///   v_i(t) = (x_i(t + n/f) - x_i(t - n/f)) / (2 n/f)
///
/// with f frames per second, as PedPy's compute_individual_speed has it. The window evens out the swaying of heads; its
/// usual length is ours.
struct SpeedWindow {
  int frames = 0;  ///< n; 0: the number of frames nearest to 5/16 s
  /// At the ends of a track: take the largest symmetric window there is; or as much as there is on each side; or none.
  enum class Ends { shrink, one_sided, exclude } ends = Ends::shrink;
};
/// The n that is meant, at least 1.
int window_frames(const SpeedWindow& window, double frame_rate);

/// One velocity per fix, metres per second. Where frames are missing, the outermost fixes within the window count, over
/// the time between them. kUnknown in both parts where there is no other fix to compare with: at the two ends of a
/// track under `shrink`, in the outer n frames under `exclude`.
std::vector<Vec2> velocities(const Recording& recording, const SpeedWindow& window, int threads = 0);

/// Lengths of velocities; or, given a unit vector, their parts along it, which are negative for who walks against it.
std::vector<double> speeds(std::span<const Vec2> velocities, std::optional<Vec2> direction = std::nullopt);

}  // namespace inhabit::crowd
