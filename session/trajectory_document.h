#pragma once
#include <string>
#include <string_view>

#include "core/core.h"
#include "scene/trajectories.h"

/// Files of trajectories as front ends open and save them.
namespace inhabit::session {

/// What a file may leave open.
struct TrajectoryOpenOptions {
  std::string unit;        ///< "cm" or "m"; empty: the file says it
  double frame_rate = 0;   ///< frames per second; 0: the file says it
  std::string homography;  ///< file with the 3x3 matrix from pixels to metres
  bool empty() const { return unit.empty() && frame_rate == 0 && homography.empty(); }
};

/// Whether the file of this name holds trajectories rather than a scene.
bool holds_trajectories(const std::string& name);
/// Any format of io/trajectory_table.h; what was odd is in the remarks.
core::Result<scene::Trajectories> open_trajectories(const std::string& name, const TrajectoryOpenOptions& options = {});
/// Whether trajectories can be written to a file of this name. For asking before long work.
core::Status can_save_trajectories(const std::string& path);
/// In the format that the extension says; an existing file stays whole until the new one is.
core::Status save_trajectories(const scene::Trajectories& trajectories, const std::string& path);

/// Every format of scenes and of trajectories, one per line: extensions, whether it is read and written, what it is.
std::string formats_text();

}  // namespace inhabit::session
