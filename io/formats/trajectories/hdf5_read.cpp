#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "io/formats/trajectories/apart.h"
#include "io/formats/trajectories/areas.h"
#include "io/formats/trajectories/hdf5.h"
#include "io/formats/trajectories/hdf5_handle.h"

namespace inhabit::io {
namespace {

constexpr hsize_t kPiece = 65536;  // rows read at a time
/// What deflate packs a byte into at best; a file that claims more was not written by a program.
constexpr double kBestRatio = 1032;

struct Row {
  std::int64_t id, frame;
  double x, y;
};

/// Seconds that reading may compute: damaged files can send the library round in circles. Healthy ones are read at
/// megabytes a second, packed as they may be; more than that is for slow machines.
unsigned patience(std::size_t bytes) {
  return 2 + static_cast<unsigned>(std::min<std::size_t>(bytes >> 17, 8) + (bytes >> 20));
}

/// Kinds of messages from the process that reads: an error, the rate, the title, an area, rows.
enum Kind : char { kError = 'e', kRate = 'f', kTitle = 't', kArea = 'a', kRows = 'r' };

Error broken(std::string what) { return invalid("", "HDF5: " + std::move(what)); }
template <class T>
std::string_view bytes_of(const T* values, std::size_t count) {
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

// The library would copy the image twice; these hand out our own bytes instead. The file is opened for reading only, so
// they are not written to.
void* image_malloc(std::size_t, H5FD_file_image_op_t, void* bytes) { return bytes; }
void* image_copy(void* to, const void*, std::size_t, H5FD_file_image_op_t, void*) { return to; }
void* image_realloc(void*, std::size_t, H5FD_file_image_op_t, void*) { return nullptr; }
herr_t image_free(void*, H5FD_file_image_op_t, void*) { return 0; }
void* user_copy(void* bytes) { return bytes; }
herr_t user_free(void*) { return 0; }

/// A number that does not fit is an error, not the nearest one that does.
H5T_conv_ret_t refuse(H5T_conv_except_t what, hid_t, hid_t, void*, void*, void*) {
  return what == H5T_CONV_EXCEPT_PRECISION || what == H5T_CONV_EXCEPT_TRUNCATE ? H5T_CONV_UNHANDLED : H5T_CONV_ABORT;
}

Hdf5Handle open_image(std::string_view bytes) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (!access || H5Pset_fapl_core(access.get(), 1 << 16, false) < 0) return {};
  void* image = const_cast<char*>(bytes.data());
  H5FD_file_image_callbacks_t callbacks = {image_malloc, image_copy, image_realloc, image_free,
                                           user_copy,    user_free,  image};
  if (H5Pset_file_image_callbacks(access.get(), &callbacks) < 0) return {};
  if (H5Pset_file_image(access.get(), image, bytes.size()) < 0) return {};
  return {H5Fopen("image", H5F_ACC_RDONLY, access.get()), H5Fclose};
}

/// The dataset `name`, when it is in this file and not behind a link to another one.
Hdf5Handle open_dataset(hid_t file, const char* name) {
  H5L_info_t link{};
  if (H5Lexists(file, name, H5P_DEFAULT) <= 0 || H5Lget_info(file, name, &link, H5P_DEFAULT) < 0 ||
      link.type != H5L_TYPE_HARD)
    return {};
  H5O_info_t object{};
  if (H5Oget_info_by_name(file, name, &object, H5P_DEFAULT) < 0 || object.type != H5O_TYPE_DATASET) return {};
  return {H5Dopen2(file, name, H5P_DEFAULT), H5Dclose};
}

/// Why the data cannot be read, as far as the way they are stored says it.
std::optional<std::string> why_not_stored(hid_t dataset, hsize_t rows, std::size_t row_size) {
  const Hdf5Handle plist(H5Dget_create_plist(dataset), H5Pclose);
  if (!plist) return "the storage of /trajectory is damaged";
  const H5D_layout_t layout = H5Pget_layout(plist.get());
  if (layout == H5D_VIRTUAL || layout < 0 || H5Pget_external_count(plist.get()) != 0)
    return "the rows of /trajectory are in another file";
  const int filters = H5Pget_nfilters(plist.get());
  for (int k = 0; k < filters; ++k) {
    unsigned flags = 0;
    std::size_t parameters = 0;
    char name[64] = "";
    const H5Z_filter_t filter =
        H5Pget_filter2(plist.get(), static_cast<unsigned>(k), &flags, &parameters, nullptr, sizeof name, name, nullptr);
    if (filter >= 0 && H5Zfilter_avail(filter) > 0) continue;
    name[sizeof name - 1] = '\0';
    return "/trajectory is compressed with filter " + std::to_string(filter) +
           (name[0] != '\0' ? std::string(" (") + name + ")" : "") + ", for which the HDF5 library here has no plugin";
  }
  const auto stored = static_cast<double>(H5Dget_storage_size(dataset));
  if (static_cast<double>(rows) * static_cast<double>(row_size) > kBestRatio * stored)
    return "/trajectory says that it has " + std::to_string(rows) + " rows, which are not in the file";
  return std::nullopt;
}

/// The type that takes id, frame, x and y out of a row; an error names the column that is missing.
Result<Hdf5Handle> memory_type(hid_t file_type) {
  if (H5Tget_class(file_type) != H5T_COMPOUND) return broken("/trajectory has no columns");
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose);
  if (!type) return broken("no memory");
  const struct {
    const char* name;
    std::size_t offset;
    hid_t kind;
  } columns[] = {{"id", offsetof(Row, id), H5T_NATIVE_INT64},
                 {"frame", offsetof(Row, frame), H5T_NATIVE_INT64},
                 {"x", offsetof(Row, x), H5T_NATIVE_DOUBLE},
                 {"y", offsetof(Row, y), H5T_NATIVE_DOUBLE}};
  for (const auto& column : columns) {
    const int member = H5Tget_member_index(file_type, column.name);
    if (member < 0) return broken(std::string("/trajectory has no column ") + column.name);
    const H5T_class_t kind = H5Tget_member_class(file_type, static_cast<unsigned>(member));
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
      return broken(std::string("the column ") + column.name + " of /trajectory holds no numbers");
    if (H5Tinsert(type.get(), column.name, column.offset, column.kind) < 0) return broken("no memory");
  }
  return type;
}

Status send_rows(hid_t dataset, hid_t type, hid_t space, hsize_t rows, Sender& out) {
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  if (!transfer || H5Pset_type_conv_cb(transfer.get(), refuse, nullptr) < 0) return broken("no memory");
  std::vector<Row> piece(static_cast<std::size_t>(std::min(rows, kPiece)));
  for (hsize_t at = 0; at < rows; at += kPiece) {
    const hsize_t count = std::min(kPiece, rows - at);
    const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    if (!memory || H5Sselect_hyperslab(space, H5S_SELECT_SET, &at, nullptr, &count, nullptr) < 0 ||
        H5Dread(dataset, type, memory.get(), space, transfer.get(), piece.data()) < 0)
      return broken("the rows of /trajectory from " + std::to_string(at + 1) +
                    " on cannot be read: damaged or cut off");
    out.send(kRows, bytes_of(piece.data(), count));
  }
  return Done{};
}

/// JuPedSim's newer files have the area in parts: /regions {id, wkt}.
void send_regions(hid_t file, Sender& out) {
  const Hdf5Handle dataset = open_dataset(file, "regions");
  if (!dataset) return;
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose), space(H5Dget_space(dataset.get()), H5Sclose);
  if (!type || !space || H5Tget_class(type.get()) != H5T_COMPOUND) return;
  const int member = H5Tget_member_index(type.get(), "wkt");
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (member < 0 || count <= 0 || count > 10000) return;
  const Hdf5Handle text(H5Tget_member_type(type.get(), static_cast<unsigned>(member)), H5Tclose);
  if (!text || H5Tis_variable_str(text.get()) <= 0 || why_not_stored(dataset.get(), 0, 0)) return;
  const Hdf5Handle memory(H5Tcreate(H5T_COMPOUND, sizeof(char*)), H5Tclose);
  if (!memory || H5Tinsert(memory.get(), "wkt", 0, text.get()) < 0) return;
  std::vector<char*> texts(static_cast<std::size_t>(count), nullptr);
  if (H5Dread(dataset.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) >= 0)
    for (const char* wkt : texts)
      if (wkt != nullptr) out.send(kArea, wkt);
  for (char* wkt : texts) H5free_memory(wkt);
}

void send_attributes(hid_t file, hid_t dataset, Sender& out) {
  std::optional<double> rate = hdf5_number(dataset, "fps");
  if (!rate) rate = hdf5_number(file, "fps");
  const std::optional<double> step = hdf5_number(file, "dt"), every = hdf5_number(file, "every_nth_frame");
  if (!rate && step && every && *step * *every > 0) rate = 1 / (*step * *every);
  if (rate) out.send(kRate, bytes_of(&*rate, 1));
  if (const std::optional<std::string> title = hdf5_text(file, "experiment_title")) out.send(kTitle, *title);
  if (const std::optional<std::string> wkt = hdf5_text(file, "wkt_geometry"))
    out.send(kArea, *wkt);
  else
    send_regions(file, out);
}

Status send_all(std::string_view bytes, Sender& out) {
  const Hdf5Handle file = open_image(bytes);
  if (!file) return broken("the file is damaged or cut off");
  const Hdf5Handle dataset = open_dataset(file.get(), "trajectory");
  if (!dataset) return broken("there is no dataset /trajectory");
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose), file_type(H5Dget_type(dataset.get()), H5Tclose);
  if (!space || !file_type) return broken("/trajectory is damaged");
  hsize_t rows = 0;
  if (H5Sget_simple_extent_ndims(space.get()) != 1 || H5Sget_simple_extent_dims(space.get(), &rows, nullptr) != 1)
    return broken("/trajectory is no list of rows");
  if (rows > kMostRows) return broken("/trajectory has " + std::to_string(rows) + " rows, more than are read");
  const Result<Hdf5Handle> type = memory_type(file_type.get());
  if (!type) return type.error();
  if (const auto why = why_not_stored(dataset.get(), rows, H5Tget_size(file_type.get()))) return broken(*why);
  send_attributes(file.get(), dataset.get(), out);
  return send_rows(dataset.get(), type->get(), space.get(), rows, out);
}

Status take_rows(std::string_view payload, RawTrajectories& raw) {
  RawRows out(raw);
  for (std::size_t at = 0; at + sizeof(Row) <= payload.size(); at += sizeof(Row)) {
    Row row{};
    std::memcpy(&row, payload.data() + at, sizeof row);
    if (!out.add(row.id, row.frame, row.x, row.y))
      return invalid("row " + std::to_string(raw.fixes.size() + 1) + " of /trajectory", out.problem);
  }
  return Done{};
}

Status take(char kind, std::string_view payload, RawTrajectories& raw) {
  double rate = 0;
  if (kind == kRows) return take_rows(payload, raw);
  if (kind == kError) return invalid("", std::string(payload));
  if (kind == kRate && payload.size() == sizeof rate) {
    std::memcpy(&rate, payload.data(), sizeof rate);
    raw.frame_rate = rate;
  }
  if (kind == kTitle) raw.title = payload;
  if (kind == kArea) take_walkable(payload, raw);
  return Done{};
}

}  // namespace

bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

Result<RawTrajectories> read_hdf5(std::string_view bytes) {
  const Hdf5Session session;  // the copy has it too
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  const Result<bool> read = run_apart(
      [&](Sender& out) {
        if (const Status sent = send_all(bytes, out); !sent) out.send(kError, sent.error().text());
      },
      [&](char kind, std::string_view payload) { return take(kind, payload, raw); }, patience(bytes.size()));
  if (!read) return read.error();
  if (!*read) return broken("the file is damaged: the HDF5 library could not cope with it");
  if (raw.walkable.size() > 1) raw.walkable = geometry::difference(raw.walkable, {}, 0);
  return raw;
}

}  // namespace inhabit::io
