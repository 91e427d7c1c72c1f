#include "io/formats/sweethome3d_archive.h"

#include <zip.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

namespace inhabit::io::sh3d {
namespace {

constexpr zip_int64_t kMostEntries = 20000;
constexpr std::uint64_t kMostUnpacked = 4ULL << 30;
constexpr std::uint64_t kLargestXml = 64ULL << 20;
constexpr std::uint64_t kHighestRatio = 1000;
constexpr std::uint64_t kSmallEntry = 1 << 20;  // below this a high ratio harms nobody

struct CloseArchive {
  void operator()(zip_t* z) const { zip_discard(z); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;
struct CloseFile {
  void operator()(zip_file_t* f) const { zip_fclose(f); }
};

Error broken(std::string where, const char* why) {
  return invalid(std::move(where), std::string("the zip archive cannot be read: ").append(why));
}

/// Opened from memory; `bytes` must outlive it.
Result<Archive> open_archive(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* z = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (z == nullptr) {
    if (source != nullptr) zip_source_free(source);
    Error out = broken("", zip_error_strerror(&error));
    zip_error_fini(&error);
    return out;
  }
  zip_error_fini(&error);
  return Archive(z);
}

std::optional<Error> why_refused(const zip_stat_t& entry, std::uint64_t& total) {
  const std::string name = entry.name;
  if ((entry.valid & ZIP_STAT_SIZE) == 0 || (entry.valid & ZIP_STAT_COMP_SIZE) == 0)
    return broken(name, "no size is given");
  if ((entry.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && entry.encryption_method != ZIP_EM_NONE)
    return Error{ErrorCode::unsupported, "is encrypted", name};
  if (entry.size > kMostUnpacked || (total += entry.size) > kMostUnpacked)
    return invalid(name, "the archive unpacks to more than 4 GiB; refused");
  if (entry.size > kSmallEntry && entry.size / kHighestRatio > entry.comp_size)
    return invalid(name, "unpacks to more than a thousand times its size; refused as a zip bomb");
  return std::nullopt;
}

/// The bytes that a closed archive has left in its source.
Result<std::string> bytes_of(zip_source_t* source) {
  std::string out;
  if (zip_source_open(source) != 0) return broken("", "the written archive is lost");
  char buffer[65536];
  zip_int64_t got = 0;
  while ((got = zip_source_read(source, buffer, sizeof buffer)) > 0) out.append(buffer, static_cast<std::size_t>(got));
  zip_source_close(source);
  if (got < 0) return broken("", "the written archive is lost");
  return out;
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06"); }

Result<std::vector<std::string>> entry_names(const std::string& archive) {
  auto opened = open_archive(archive);
  if (!opened) return opened.error();
  zip_t* z = opened->get();
  const zip_int64_t count = zip_get_num_entries(z, 0);
  if (count > kMostEntries) return invalid("", "the archive has more than 20000 entries; refused");
  std::vector<std::string> names;
  std::uint64_t total = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t entry;
    zip_stat_init(&entry);
    if (zip_stat_index(z, static_cast<zip_uint64_t>(i), 0, &entry) != 0 || entry.name == nullptr)
      return broken("", zip_strerror(z));
    if (auto refused = why_refused(entry, total)) return *refused;
    names.emplace_back(entry.name);
  }
  return names;
}

Result<std::string> read_entry(const std::string& archive, const std::string& name) {
  auto opened = open_archive(archive);
  if (!opened) return opened.error();
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen(opened->get(), name.c_str(), 0));
  if (!file) return broken(name, zip_strerror(opened->get()));
  std::string out;
  char buffer[65536];
  zip_int64_t got = 0;
  while ((got = zip_fread(file.get(), buffer, sizeof buffer)) > 0) {
    out.append(buffer, static_cast<std::size_t>(got));
    if (out.size() > kLargestXml) return invalid(name, "unpacks to more than 64 MiB; refused");
  }
  if (got < 0) return broken(name, zip_file_strerror(file.get()));
  return out;
}

Result<std::string> with_entry(const std::string& archive, const std::string& name, const std::string& content,
                               const std::vector<std::string>& dropped) {
  zip_error_t error;
  zip_error_init(&error);
  struct Free {
    void operator()(zip_source_t* s) const { zip_source_free(s); }
  };
  // A source that is written to takes over its bytes: libzip 1.7 frees them whatever it was told.
  void* copy = archive.empty() ? nullptr : std::malloc(archive.size());
  if (copy != nullptr) std::memcpy(copy, archive.data(), archive.size());
  zip_source_t* raw = zip_source_buffer_create(copy, copy == nullptr ? 0 : archive.size(), 1, &error);
  if (raw == nullptr) {
    std::free(copy);
    return broken("", zip_error_strerror(&error));
  }
  zip_source_keep(raw);
  const std::unique_ptr<zip_source_t, Free> kept(raw);
  Archive z(zip_open_from_source(raw, archive.empty() ? ZIP_TRUNCATE | ZIP_CREATE : 0, &error));
  if (!z) {
    zip_source_free(raw);
    return broken("", zip_error_strerror(&error));
  }
  for (const std::string& gone : dropped) {
    const zip_int64_t at = zip_name_locate(z.get(), gone.c_str(), 0);
    if (at >= 0 && zip_delete(z.get(), static_cast<zip_uint64_t>(at)) != 0) return broken(gone, zip_strerror(z.get()));
  }
  zip_source_t* text = zip_source_buffer(z.get(), content.data(), content.size(), 0);
  if (text == nullptr) return broken(name, zip_strerror(z.get()));
  zip_int64_t at = zip_name_locate(z.get(), name.c_str(), 0);
  const bool known = at >= 0;
  if (known ? zip_file_replace(z.get(), static_cast<zip_uint64_t>(at), text, 0) != 0
            : (at = zip_file_add(z.get(), name.c_str(), text, ZIP_FL_ENC_UTF_8)) < 0) {
    zip_source_free(text);
    return broken(name, zip_strerror(z.get()));
  }
  // 1 January 1980, the earliest that a zip can say.
  zip_file_set_dostime(z.get(), static_cast<zip_uint64_t>(at), 0, 0x21, 0);
  zip_t* closing = z.release();
  if (zip_close(closing) != 0) {
    Error out = broken("", zip_strerror(closing));
    zip_discard(closing);
    return out;
  }
  return bytes_of(kept.get());
}

}  // namespace inhabit::io::sh3d
