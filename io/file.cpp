#include "io/file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace inhabit::io {
namespace {

Error file_error(const std::filesystem::path& path, std::string what) {
  return {ErrorCode::io, std::move(what), path.string()};
}
Error system_error(const std::filesystem::path& path, const char* doing) {
  const int code = errno;
  Error error = file_error(path, std::string(doing) + ": " + std::strerror(code));
  if (code == ENOENT) error.code = ErrorCode::not_found;
  return error;
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Writes everything, to the disk and not only to the cache.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  // Pipes and some file systems know no fsync; that is no reason to fail.
  return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return file_error(path, "is a folder, not a file");
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) return system_error(path, "cannot be opened");
  std::string bytes;
  // Read piece by piece: pipes have no size and files may grow.
  char piece[1 << 16];
  while (const std::size_t count = std::fread(piece, 1, sizeof piece, file.get())) {
    if (bytes.size() + count > limit) return file_error(path, "is larger than " + std::to_string(limit >> 20) + " MiB");
    bytes.append(piece, count);
  }
  if (std::ferror(file.get()) != 0) return system_error(path, "cannot be read");
  return bytes;
}

Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  static std::atomic<unsigned> next{0};
  std::filesystem::path temporary = path;
  temporary += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(next++);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return system_error(path, "cannot be written");
  const bool written = write_all(file, bytes);
  const Error write_error = system_error(path, "cannot be written");
  if (::close(file) != 0 || !written) {
    ::unlink(temporary.c_str());
    return write_error;
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    const Error error = system_error(path, "cannot be replaced");
    ::unlink(temporary.c_str());
    return error;
  }
  return Done{};
}

Status can_write(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return file_error(path, "is a folder, not a file");
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return system_error(path, "cannot be written");
  if (!std::filesystem::is_directory(folder, ignored)) return file_error(path, "cannot be written: no folder holds it");
  return Done{};
}

Result<std::string> gunzip(std::string_view bytes, std::size_t limit) {
  z_stream stream{};
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) return Error{ErrorCode::io, "gzip: no memory", ""};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, &inflateEnd);
  // zlib does not write to its input, its type only says so.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), kLargestFile));
  std::string out;
  char piece[1 << 16];
  for (;;) {
    stream.next_out = reinterpret_cast<Bytef*>(piece), stream.avail_out = sizeof piece;
    const int state = inflate(&stream, Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END) return invalid("", "gzip: damaged or cut off");
    const std::size_t count = sizeof piece - stream.avail_out;
    if (out.size() + count > limit)
      return invalid("", "gzip: larger than " + std::to_string(limit >> 20) + " MiB when unpacked");
    out.append(piece, count);
    if (state != Z_STREAM_END) continue;
    if (stream.avail_in == 0) return out;
    if (inflateReset(&stream) != Z_OK) return invalid("", "gzip: damaged");
  }
}

std::string gunzip_head(std::string_view bytes, std::size_t limit) {
  z_stream stream{};
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) return {};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, &inflateEnd);
  std::string out(limit, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), kLargestFile));
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(std::min<std::size_t>(limit, kLargestFile));
  inflate(&stream, Z_SYNC_FLUSH);
  out.resize(stream.total_out);
  return out;
}

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1);
  return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

}  // namespace inhabit::io
