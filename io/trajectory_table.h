#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/formats/trajectories/output.h"
#include "io/trajectory_checks.h"
#include "scene/trajectories.h"

/// Every format that trajectories are read from and written to.
namespace inhabit::io {

class AnyTrajectoryWriter;

struct TrajectoryFormat {
  std::string_view name;
  std::string_view extensions;           ///< separated by spaces
  bool (*sniff)(std::string_view head);  ///< true when the start of the content looks like this format
  Result<RawTrajectories> (*read)(std::string_view bytes, const TrajectoryOptions& options);
  /// nullptr: read only.
  Result<std::unique_ptr<AnyTrajectoryWriter>> (*create)(const std::filesystem::path& path,
                                                         const TrajectoryHeader& header);
  std::string_view needs;  ///< the flags without which it cannot be read
  std::string_view help;
};

/// In the order in which their sniffing is asked.
std::span<const TrajectoryFormat> trajectory_formats();
/// The format that writes files with this extension; nullptr when none does.
const TrajectoryFormat* trajectory_format_to_write(const std::filesystem::path& path);
/// The error when there is none: it names the extensions that are written.
Error no_such_trajectory_format();

/// Whether the start of the content, which may be packed by gzip, is that of a format of trajectories.
bool are_trajectories(std::string_view bytes);
/// The same for a file, of which only the start is read; where its content says nothing, its extension does.
bool holds_trajectories(const std::filesystem::path& path);

/// Reads a file by its content, else by its extension; gzip is unpacked. The file is not written to whatever its
/// format. Errors name the file and the place in it.
Result<scene::Trajectories> read_trajectories(const std::filesystem::path& path, const TrajectoryOptions& options = {});
/// The same for bytes in memory; `name` decides where the content leaves open what it is.
Result<scene::Trajectories> read_trajectories(std::string_view bytes, std::string_view name,
                                              const TrajectoryOptions& options = {});

/// Writes trajectories frame by frame, in the format that the extension says, to a temporary file beside the target
/// that takes its place in the end. Memory does not grow with time. Text and CSV are rounded to 0.1 mm, HDF5 and SQLite
/// keep every digit; the same calls give the same bytes. A process that dies leaves a temporary file of whole frames.
class TrajectoryWriter {
 public:
  static Result<TrajectoryWriter> open(const std::filesystem::path& path, const TrajectoryHeader& header);
  TrajectoryWriter(TrajectoryWriter&&) noexcept;
  TrajectoryWriter& operator=(TrajectoryWriter&&) = delete;
  /// Removes the temporary file when finish() has not been called.
  ~TrajectoryWriter();
  /// Requires: frames ascend from call to call and persons within one. A frame without people is no row of any format.
  /// Errors: a position that is not finite, a full disk; then the writer is of no more use.
  Status add(std::int32_t frame, std::span<const Spot> people);
  /// Puts the file in its place. When only that fails, the temporary file stays and the error names it.
  Status finish();

 private:
  struct State;
  explicit TrajectoryWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All of them in one file.
Status write_trajectories(const scene::Trajectories& trajectories, const std::filesystem::path& path);

}  // namespace inhabit::io
