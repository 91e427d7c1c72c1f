#include "io/trajectory_table.h"

#include <algorithm>
#include <fstream>

#include "io/file.h"
#include "io/formats/trajectories/columns.h"
#include "io/formats/trajectories/csv.h"
#include "io/formats/trajectories/delimited.h"
#include "io/formats/trajectories/hdf5.h"
#include "io/formats/trajectories/obsmat.h"
#include "io/formats/trajectories/petrack.h"
#include "io/formats/trajectories/splines.h"
#include "io/formats/trajectories/sqlite.h"
#include "io/formats/trajectories/sumo.h"
#include "io/formats/trajectories/trajnet.h"
#include "io/formats/trajectories/vadere.h"
#include "io/formats/trajectories/viswalk.h"
#include "io/trajectory_writers.h"

namespace inhabit::io {
namespace {

/// A recording of a hundred thousand people for minutes; less for what is packed, which may be anything.
constexpr std::size_t kLargestRecording = std::size_t{8} << 30;
constexpr std::size_t kHead = 1 << 18;

template <Result<RawTrajectories> (*read)(std::string_view)>
Result<RawTrajectories> plain(std::string_view bytes, const TrajectoryOptions&) {
  return read(bytes);
}

Result<RawTrajectories> read_splines_file(std::string_view bytes, const TrajectoryOptions& options) {
  if (options.homography.empty()) return read_splines(bytes, nullptr);
  const Result<std::string> text = read_file(options.homography, 1 << 16);
  if (!text) return text.error();
  const Result<Homography> ground = read_homography(*text);
  if (ground) return read_splines(bytes, &*ground);
  const std::string& where = ground.error().where;
  return invalid(options.homography.string() + (where.empty() ? "" : ": ") + where, ground.error().message);
}

// One line per format; the first whose sniffing agrees reads a file.
constexpr TrajectoryFormat kFormats[] = {
    {"hdf5", "h5 hdf5", is_hdf5, plain<read_hdf5>, create_as<Hdf5Writer>, "",
     "HDF5 of the Juelich archive and of JuPedSim: /trajectory in metres"},
    {"sqlite", "sqlite sqlite3 db", is_sqlite, plain<read_sqlite>, create_as<SqliteWriter>, "",
     "JuPedSim's database, versions 1 to 3; written as 2"},
    {"trajnet++", "ndjson", is_trajnet, plain<read_trajnet>, nullptr, "",
     "TrajNet++, one JSON object per line, metres"},
    {"viswalk", "pp", is_viswalk, plain<read_viswalk>, nullptr, "", "pedestrian records of PTV Viswalk"},
    {"splines", "vsp", is_splines, read_splines_file, nullptr, "--homography", "UCY's splines in pixels, 25 fps"},
    {"sumo", "xml", is_sumo, plain<read_sumo>, nullptr, "", "the persons of SUMO's fcd-output"},
    {"vadere", "traj", is_vadere, plain<read_vadere>, nullptr, "",
     "Vadere's footsteps, interpolated at 25 frames per second or --fps"},
    {"csv", "csv", is_csv, plain<read_csv>, create_as<CsvWriter>, "--fps without times or speeds",
     "tables that name their columns: id, frame or t, x, y; crowd:it's"},
    {"petrack", "txt", is_petrack, plain<read_petrack>, create_as<PetrackWriter>,
     "--unit, --fps where comments lack them", "text of PeTrack and the Juelich archive: id frame x y z"},
    {"obsmat", "txt", is_obsmat, plain<read_obsmat>, nullptr, "", "BIWI's obsmat.txt: frame id x z y vx vz vy, metres"},
    {"columns", "txt", is_columns, plain<read_columns>, nullptr, "--unit and --fps",
     "numbers alone: id frame x y (HERMES) or frame id x y (TrajNet)"},
};

bool has_extension(const TrajectoryFormat& format, std::string_view extension) {
  for (std::string_view rest = format.extensions; !rest.empty();) {
    const std::size_t space = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, space) == extension) return true;
    rest.remove_prefix(std::min(space + 1, rest.size()));
  }
  return false;
}
std::string extension_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return lower(std::string_view(extension).substr(extension.empty() ? 0 : 1));
}

const TrajectoryFormat* format_of(std::string_view bytes) {
  const auto found = std::ranges::find_if(kFormats, [&](const auto& f) { return f.sniff(bytes.substr(0, kHead)); });
  return found == std::end(kFormats) ? nullptr : found;
}
/// The first format with this extension.
const TrajectoryFormat* format_named(std::string_view extension) {
  const auto found = std::ranges::find_if(kFormats, [&](const auto& f) { return has_extension(f, extension); });
  return found == std::end(kFormats) ? nullptr : found;
}

}  // namespace

std::span<const TrajectoryFormat> trajectory_formats() { return kFormats; }

const TrajectoryFormat* trajectory_format_to_write(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  const auto found =
      std::ranges::find_if(kFormats, [&](const auto& f) { return f.create != nullptr && has_extension(f, extension); });
  return found == std::end(kFormats) ? nullptr : found;
}

bool are_trajectories(std::string_view bytes) {
  return is_gzip(bytes) ? format_of(gunzip_head(bytes, kHead)) != nullptr : format_of(bytes) != nullptr;
}

bool holds_trajectories(const std::filesystem::path& path) {
  std::string head(kHead, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (are_trajectories(head)) return true;
  std::string extension = extension_of(path);
  if (extension == "gz") extension = extension_of(path.stem());
  // Homes are .xml too.
  return extension != "xml" && format_named(extension) != nullptr;
}

Result<scene::Trajectories> read_trajectories(std::string_view bytes, std::string_view name,
                                              const TrajectoryOptions& options) {
  if (is_gzip(bytes)) {
    const Result<std::string> unpacked = gunzip(bytes);
    if (!unpacked) return unpacked.error();
    if (is_gzip(*unpacked)) return invalid("", "gzip within gzip");
    return read_trajectories(*unpacked, name.ends_with(".gz") ? name.substr(0, name.size() - 3) : name, options);
  }
  const TrajectoryFormat* format = format_of(bytes);
  if (format == nullptr) {
    format = format_named(extension_of(name));
    if (format == nullptr) {
      std::string known;
      for (const TrajectoryFormat& f : kFormats) known += (known.empty() ? "" : ", ") + std::string(f.name);
      return Error{ErrorCode::unsupported, "none of the known formats of trajectories: " + known, ""};
    }
  }
  Result<RawTrajectories> raw = format->read(bytes, options);
  if (!raw) return raw.error();
  Result<scene::Trajectories> trajectories = checked_trajectories(std::move(*raw), options);
  if (trajectories && trajectories->name.empty()) trajectories->name = std::filesystem::path(name).stem().string();
  return trajectories;
}

Result<scene::Trajectories> read_trajectories(const std::filesystem::path& path, const TrajectoryOptions& options) {
  const Result<std::string> bytes = read_file(path, kLargestRecording);
  if (!bytes) return bytes.error();
  Result<scene::Trajectories> trajectories = read_trajectories(*bytes, path.filename().string(), options);
  if (trajectories) return trajectories;
  Error error = trajectories.error();
  error.where = path.string() + (error.where.empty() ? "" : ": ") + error.where;
  return error;
}

}  // namespace inhabit::io
