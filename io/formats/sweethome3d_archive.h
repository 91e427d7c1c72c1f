#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/core.h"

/// Zip archives in memory, with limits: nothing is extracted to disk, and only the entry asked for is unpacked.
namespace inhabit::io::sh3d {
using namespace core;

/// True when the bytes begin like a zip archive.
bool is_zip(std::string_view bytes);

/// The names of all entries. Refuses what no home has: more than 20,000 entries, more than 4 GiB unpacked in all, or
/// one entry that claims to unpack to more than a thousand times its size.
Result<std::vector<std::string>> entry_names(const std::string& archive);

/// One entry unpacked; at most 64 MiB, whatever the archive claims.
Result<std::string> read_entry(const std::string& archive, const std::string& name);

/// The archive (a new one when empty) with one entry replaced or added and others dropped; the rest is copied as
/// packed. The time stamp of the entry is fixed, so that the same content gives the same bytes.
Result<std::string> with_entry(const std::string& archive, const std::string& name, const std::string& content,
                               const std::vector<std::string>& dropped);

}  // namespace inhabit::io::sh3d
