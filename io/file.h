#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "core/core.h"

namespace inhabit::io {
using namespace core;

constexpr std::size_t kLargestFile = std::size_t{256} << 20;

/// The bytes of a file. Errors (`where` is the path): not there, no ordinary file, not readable, larger than `limit`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit = kLargestFile);

/// Writes to a temporary file in the same folder and renames it, so that `path` holds either all of `bytes` or, after
/// an error, what it held before.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Whether a file of this name could be written, without touching it: the folder exists and lets us, and the name is no
/// folder's.
Status can_write(const std::filesystem::path& path);

/// What a gzip file (RFC 1952, one or more members) holds. Errors: damaged, cut off, larger than `limit` when unpacked.
Result<std::string> gunzip(std::string_view bytes, std::size_t limit = kLargestFile);
/// What the start of a gzip file holds, at most `limit` bytes of it; as much as can be unpacked.
std::string gunzip_head(std::string_view bytes, std::size_t limit);
inline bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// `line 3, column 7` of the byte at `offset`.
std::string line_and_column(std::string_view text, std::size_t offset);

}  // namespace inhabit::io
