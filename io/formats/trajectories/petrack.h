#pragma once
#include <string_view>

#include "io/formats/trajectories/output.h"
#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// The text of PeTrack and of the Juelich archive: comments with the frame rate and the unit, then `id frame x y z …`
/// separated by white space. Old files leave the unit out.
bool is_petrack(std::string_view bytes);
Result<RawTrajectories> read_petrack(std::string_view bytes);

/// The same in metres to 0.1 mm, ordered by frame, z = 0.
class PetrackWriter {
 public:
  static Result<PetrackWriter> create(const std::filesystem::path& path, const TrajectoryHeader& header);
  Status add(std::int32_t frame, std::span<const Spot> people);
  Status flush() { return file_.flush(); }
  Status close() { return file_.close(); }

 private:
  explicit PetrackWriter(AppendFile file) : file_(std::move(file)) {}
  AppendFile file_;
};

}  // namespace inhabit::io
