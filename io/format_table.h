#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/sweethome3d.h"
#include "scene/scene.h"

/// Every format that spaces and furnished rooms are read from and written to.
namespace inhabit::io {

/// For formats with `houses`; an error for all others.
struct ReadOptions {
  /// ProcTHOR's asset-database.json, without which its houses have no sizes.
  std::filesystem::path asset_database;
  /// The house of a file with one per line, from 1; 0: all.
  std::size_t line = 0;
};

/// What is in a file: scenes, and for a home also the home, so that its rooms can be written back into it.
struct Content {
  std::vector<scene::Scene> scenes;
  std::optional<Sh3dHome> home;
  std::vector<std::string> warnings;  ///< what reading left out or changed, for people
};

struct Format {
  std::string_view name;
  std::string_view extensions;            ///< separated by spaces, the first is the one for writing
  bool (*sniff)(std::string_view bytes);  ///< true when the content looks like this format
  core::Result<Content> (*read)(std::string_view bytes, const ReadOptions& options);
  /// nullptr: read only. Requires: one scene, or a home and scenes that came from it where `homes` is true.
  core::Result<std::string> (*write)(const Content& content);
  bool homes;  ///< holds several rooms when they come from one home
  std::string_view help;
  bool houses = false;  ///< ReadOptions mean something to it
};

std::span<const Format> formats();
/// The format that writes files with this extension; nullptr when none does.
const Format* format_to_write(const std::filesystem::path& path);

/// Reads a file by its content, else by its extension; gzip is unpacked. Errors name the file.
core::Result<Content> read_any(const std::filesystem::path& path, const ReadOptions& options = {});
/// The same for bytes in memory; `name` decides where the content leaves open what it is.
core::Result<Content> read_any_bytes(std::string_view bytes, std::string_view name, const ReadOptions& options = {});

}  // namespace inhabit::io
