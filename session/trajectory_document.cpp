#include "session/trajectory_document.h"

#include <algorithm>

#include "io/file.h"
#include "io/format_table.h"
#include "io/trajectory_table.h"

namespace inhabit::session {
namespace {

/// `  .h5 .hdf5     read, written  what it is`.
std::string format_line(std::string_view extensions, bool written, std::string_view help) {
  std::string line = "  .";
  for (const char c : extensions) line.append(1, c).append(c == ' ' ? "." : "");
  line.resize(std::max<std::size_t>(line.size() + 2, 24), ' ');
  line += written ? "read, written  " : "read           ";
  return line.append(help) + "\n";
}

}  // namespace

bool holds_trajectories(const std::string& name) { return io::holds_trajectories(name); }

core::Result<scene::Trajectories> open_trajectories(const std::string& name, const TrajectoryOpenOptions& options) {
  io::TrajectoryOptions read;
  if (!options.unit.empty()) read.unit = options.unit == "cm" ? io::LengthUnit::centimetres : io::LengthUnit::metres;
  if (options.frame_rate != 0) read.frame_rate = options.frame_rate;
  read.homography = options.homography;
  return io::read_trajectories(std::filesystem::path(name), read);
}

core::Status can_save_trajectories(const std::string& path) {
  if (io::trajectory_format_to_write(path) == nullptr) return io::no_such_trajectory_format();
  return io::can_write(path);
}

core::Status save_trajectories(const scene::Trajectories& trajectories, const std::string& path) {
  return io::write_trajectories(trajectories, path);
}

std::string formats_text() {
  std::string out = "Scenes:\n";
  for (const io::Format& f : io::formats()) out += format_line(f.extensions, f.write != nullptr, f.help);
  out += "Trajectories:\n";
  for (const io::TrajectoryFormat& f : io::trajectory_formats()) {
    std::string help(f.help);
    if (!f.needs.empty()) help.append("; needs ").append(f.needs);
    out += format_line(f.extensions, f.create != nullptr, help);
  }
  return out + "Files are known by their content; read ones may be packed by gzip.";
}

}  // namespace inhabit::session
