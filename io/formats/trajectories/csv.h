#pragma once
#include <string_view>

#include "io/formats/trajectories/output.h"
#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// Tables whose first line names the columns, separated by commas, semicolons, tabs or blanks: a person (id, pedID, …),
/// a frame or a time in seconds, x and y; v_x and v_y tell the frame rate. Metres unless a name says cm. crowd:it's
/// files are of this kind.
bool is_csv(std::string_view bytes);
Result<RawTrajectories> read_csv(std::string_view bytes);

/// `id,frame,x,y,t`: metres to 0.1 mm, seconds to a microsecond, ordered by frame.
class CsvWriter {
 public:
  static Result<CsvWriter> create(const std::filesystem::path& path, const TrajectoryHeader& header);
  Status add(std::int32_t frame, std::span<const Spot> people);
  Status flush() { return file_.flush(); }
  Status close() { return file_.close(); }

 private:
  CsvWriter(AppendFile file, double frame_rate) : file_(std::move(file)), frame_rate_(frame_rate) {}
  AppendFile file_;
  double frame_rate_;
};

}  // namespace inhabit::io
