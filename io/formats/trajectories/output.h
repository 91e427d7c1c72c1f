#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/core.h"
#include "scene/trajectories.h"

/// What the writers of trajectories share.
namespace inhabit::io {
using namespace core;

/// What is known before the first position.
struct TrajectoryHeader {
  double frame_rate = 24;  ///< frames per second
  std::vector<scene::Area> walkable;
  std::string title;
  std::string producer_notes;  ///< one line: what made it
};

/// One person in the frame that is added, metres.
struct Spot {
  std::int32_t person = 0;
  double x = 0, y = 0;
};

/// How many rows are kept before they go to the disk, rounded up to whole frames: what is lost when the process dies.
constexpr std::size_t kRowsKept = 16384;

/// A file that is appended to. What has been written stays when the process dies.
class AppendFile {
 public:
  static Result<AppendFile> create(const std::filesystem::path& path);
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&&) = delete;
  ~AppendFile();
  std::string buffer;  ///< what comes next
  /// Writes the buffer and empties it.
  Status flush();
  /// The same, then to the disk and closed.
  Status close();

 private:
  AppendFile(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
  int file_ = -1;
  std::filesystem::path path_;
};

/// Appends `value` with at most `digits` places behind the point (at most 9), rounded, without zeros at the end.
void append_rounded(std::string& out, double value, int digits);
void append_whole(std::string& out, std::int64_t value);
/// Control characters as blanks, for one line of a comment.
std::string one_line(std::string_view text);

}  // namespace inhabit::io
