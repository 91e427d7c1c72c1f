#pragma once
#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>

#include "core/core.h"

namespace inhabit::session {

/// ffmpeg's path, from PATH; empty when there is none.
std::string find_ffmpeg();

/// A film that ffmpeg writes from pixels that it is given, to a temporary file beside the target that takes its place
/// in the end.
class FilmEncoder {
 public:
  /// `format` is mp4 or webm. Requires: both sides are even. Errors: no ffmpeg.
  static core::Result<std::unique_ptr<FilmEncoder>> open(const std::string& path, const std::string& format, int width,
                                                         int height, double rate);
  FilmEncoder(const FilmEncoder&) = delete;
  FilmEncoder& operator=(const FilmEncoder&) = delete;
  /// Ends ffmpeg and removes the temporary file when finish() has not been called.
  ~FilmEncoder();
  /// One picture: 4 bytes per pixel, blue first. Errors: what ffmpeg complained of.
  core::Status add(std::span<const std::uint8_t> pixels);
  core::Status finish();

 private:
  FilmEncoder() = default;
  core::Error complaint() const;
  std::string path_, temporary_;
  int pipe_ = -1;
  pid_t process_ = -1;
  std::FILE* messages_ = nullptr;
};

}  // namespace inhabit::session
