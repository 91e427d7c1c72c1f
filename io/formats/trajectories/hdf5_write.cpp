#include <algorithm>
#include <cstddef>

#include "core/text.h"
#include "geometry/polygon.h"
#include "io/formats/trajectories/areas.h"
#include "io/formats/trajectories/hdf5.h"
#include "io/formats/trajectories/hdf5_handle.h"

namespace inhabit::io {
namespace {

constexpr hsize_t kChunk = kRowsKept;

struct Row {
  std::int64_t id, frame;
  double x, y, z;
};

constexpr struct {
  const char *name, *unit, *description;
  std::size_t offset;
  bool whole;
} kColumns[] = {
    {"id", "1", "unique identifier of the pedestrian", offsetof(Row, id), true},
    {"frame", "1", "frame number; its time is frame / fps seconds", offsetof(Row, frame), true},
    {"x", "m", "pedestrian x-coordinate (meter [m])", offsetof(Row, x), false},
    {"y", "m", "pedestrian y-coordinate (meter [m])", offsetof(Row, y), false},
    {"z", "m", "pedestrian z-coordinate (meter [m])", offsetof(Row, z), false},
};

Hdf5Handle row_type(bool in_file) {
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose);
  for (const auto& c : kColumns) {
    const hid_t kind =
        c.whole ? (in_file ? H5T_STD_I64LE : H5T_NATIVE_INT64) : (in_file ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE);
    if (!type || H5Tinsert(type.get(), c.name, c.offset, kind) < 0) return {};
  }
  return type;
}

Hdf5Handle create_file(const std::filesystem::path& path) {
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  if (!creation || H5Pset_obj_track_times(creation.get(), false) < 0) return {};
  return {H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.get(), H5P_DEFAULT), H5Fclose};
}

Hdf5Handle create_dataset(hid_t file, hid_t type) {
  const hsize_t none = 0, endless = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &none, &endless), H5Sclose);
  const Hdf5Handle plist(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (!space || !plist || H5Pset_obj_track_times(plist.get(), false) < 0 || H5Pset_chunk(plist.get(), 1, &kChunk) < 0 ||
      H5Pset_shuffle(plist.get()) < 0 || H5Pset_deflate(plist.get(), 1) < 0)
    return {};
  return {H5Dcreate2(file, "trajectory", type, space.get(), H5P_DEFAULT, plist.get(), H5P_DEFAULT), H5Dclose};
}

bool write_bounds(hid_t file, const geometry::Bounds& bounds) {
  if (bounds.min.x > bounds.max.x) return true;
  return set_hdf5_number(file, "xmin", bounds.min.x) && set_hdf5_number(file, "xmax", bounds.max.x) &&
         set_hdf5_number(file, "ymin", bounds.min.y) && set_hdf5_number(file, "ymax", bounds.max.y);
}

bool write_attributes(hid_t file, hid_t dataset, const TrajectoryHeader& header) {
  std::string units = "{", descriptions = "{";
  bool good = set_hdf5_number(dataset, "fps", header.frame_rate);
  for (const auto& c : kColumns) {
    good = good && set_hdf5_text(dataset, c.name, c.description);
    const std::string start = (units.size() > 1 ? ", \"" : "\"") + std::string(c.name) + "\": \"";
    units += start + c.unit + "\"";
    descriptions += start + c.description + "\"";
  }
  good = good && set_hdf5_text(dataset, "column_units", units + "}") &&
         set_hdf5_text(dataset, "column_descriptions", descriptions + "}") &&
         set_hdf5_whole(file, "schema_version", 2) && set_hdf5_text(file, "file_version", "1.0.0") &&
         set_hdf5_text(file, "producer", "inhabit") && set_hdf5_number(file, "fps", header.frame_rate) &&
         set_hdf5_number(file, "dt", 1 / header.frame_rate) && set_hdf5_whole(file, "every_nth_frame", 1);
  if (!header.title.empty()) good = good && set_hdf5_text(file, "experiment_title", one_line(header.title));
  if (!header.producer_notes.empty()) good = good && set_hdf5_text(file, "source", one_line(header.producer_notes));
  if (!header.walkable.empty()) good = good && set_hdf5_text(file, "wkt_geometry", walkable_text(header.walkable));
  return good;
}

}  // namespace

struct Hdf5Writer::State {
  std::filesystem::path path;
  Hdf5Handle file, dataset, type;
  std::vector<Row> rows;
  hsize_t written = 0;
  geometry::Bounds seen;  ///< of the positions, when no area is known
  bool area_known = false;

  Error error() const { return {ErrorCode::io, "HDF5: cannot be written; is the disk full?", path.string()}; }
};

Hdf5Writer::Hdf5Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Hdf5Writer::Hdf5Writer(Hdf5Writer&&) noexcept = default;
Hdf5Writer& Hdf5Writer::operator=(Hdf5Writer&&) noexcept = default;
Hdf5Writer::~Hdf5Writer() {
  if (!state_) return;
  const Hdf5Session session;
  state_.reset();
}

Result<Hdf5Writer> Hdf5Writer::create(const std::filesystem::path& path, const TrajectoryHeader& header) {
  const Hdf5Session session;
  auto state = std::make_unique<State>();
  state->path = path;
  state->file = create_file(path);
  const Hdf5Handle type = row_type(true);
  state->type = row_type(false);
  if (!state->file || !type || !state->type) return state->error();
  state->dataset = create_dataset(state->file.get(), type.get());
  if (!state->dataset || !write_attributes(state->file.get(), state->dataset.get(), header)) return state->error();
  for (const scene::Area& area : header.walkable)
    for (const geometry::Vec2 p : area.outline) state->seen.add(p);
  state->area_known = !header.walkable.empty();
  if (H5Fflush(state->file.get(), H5F_SCOPE_GLOBAL) < 0) return state->error();
  return Hdf5Writer(std::move(state));
}

Status Hdf5Writer::add(std::int32_t frame, std::span<const Spot> people) {
  for (const Spot& spot : people) {
    state_->rows.push_back({spot.person, frame, spot.x, spot.y, 0});
    if (!state_->area_known) state_->seen.add({spot.x, spot.y});
  }
  return Done{};
}

Status Hdf5Writer::flush() {
  const Hdf5Session session;
  State& s = *state_;
  const hsize_t count = s.rows.size(), end = s.written + count;
  if (count == 0) return Done{};
  if (H5Dset_extent(s.dataset.get(), &end) < 0) return s.error();
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle space(H5Dget_space(s.dataset.get()), H5Sclose);
  if (!memory || !space || H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &s.written, nullptr, &count, nullptr) < 0 ||
      H5Dwrite(s.dataset.get(), s.type.get(), memory.get(), space.get(), H5P_DEFAULT, s.rows.data()) < 0 ||
      H5Fflush(s.file.get(), H5F_SCOPE_GLOBAL) < 0)
    return s.error();
  s.written = end;
  s.rows.clear();
  return Done{};
}

Status Hdf5Writer::close() {
  const Hdf5Session session;
  if (const Status flushed = flush(); !flushed) return flushed;
  const bool good = write_bounds(state_->file.get(), state_->seen) && state_->dataset.close() && state_->type.close() &&
                    state_->file.close();
  return good ? Status(Done{}) : Status(state_->error());
}

}  // namespace inhabit::io
