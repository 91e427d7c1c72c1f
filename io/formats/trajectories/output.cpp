#include "io/formats/trajectories/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/text.h"

namespace inhabit::io {
namespace {

Error write_error(const std::filesystem::path& path) {
  return {ErrorCode::io, std::string("cannot be written: ") + std::strerror(errno), path.string()};
}

}  // namespace

Result<AppendFile> AppendFile::create(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return write_error(path);
  return AppendFile(file, path);
}
AppendFile::AppendFile(AppendFile&& other) noexcept
    : buffer(std::move(other.buffer)), file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}
AppendFile::~AppendFile() {
  if (file_ >= 0) ::close(file_);
}

Status AppendFile::flush() {
  std::string_view rest = buffer;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return write_error(path_);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer.clear();
  return Done{};
}

Status AppendFile::close() {
  if (const Status flushed = flush(); !flushed) return flushed;
  // Some file systems know no fsync; that is no reason to fail.
  if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP) return write_error(path_);
  if (::close(std::exchange(file_, -1)) != 0) return write_error(path_);
  return Done{};
}

void append_whole(std::string& out, std::int64_t value) {
  char text[24];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

void append_rounded(std::string& out, double value, int digits) {
  static constexpr std::int64_t kPowers[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000};
  const std::int64_t power = kPowers[digits];
  const double scaled = value * static_cast<double>(power);
  if (!(std::abs(scaled) < 9e15)) {
    out += shortest(value);
    return;
  }
  const std::int64_t rounded = std::llround(scaled), size = std::abs(rounded);
  if (rounded < 0) out += '-';
  append_whole(out, size / power);
  std::int64_t fraction = size % power;
  if (fraction == 0) return;
  out += '.';
  for (std::int64_t place = power / 10; fraction > 0; place /= 10) {
    out += static_cast<char>('0' + fraction / place);
    fraction %= place;
  }
}

std::string one_line(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return out;
}

}  // namespace inhabit::io
