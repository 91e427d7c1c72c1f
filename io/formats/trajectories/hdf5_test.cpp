#include "io/formats/trajectories/hdf5.h"

#include <algorithm>
#include <cstddef>

#include "io/formats/trajectories/hdf5_handle.h"
#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

namespace {

std::string written(const Trajectories& trajectories) {
  const TestFolder folder;
  REQUIRE(write_trajectories(trajectories, folder / "a.h5").ok());
  return *read_file(folder / "a.h5");
}

/// JuPedSim's types, in its order of columns.
struct Small {
  std::uint32_t frame, id;
  float x, y;
};
Hdf5Handle small_type() {
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Small)), H5Tclose);
  H5Tinsert(type.get(), "frame", offsetof(Small, frame), H5T_NATIVE_UINT32);
  H5Tinsert(type.get(), "id", offsetof(Small, id), H5T_NATIVE_UINT32);
  H5Tinsert(type.get(), "x", offsetof(Small, x), H5T_NATIVE_FLOAT);
  H5Tinsert(type.get(), "y", offsetof(Small, y), H5T_NATIVE_FLOAT);
  return type;
}

/// A file whose /trajectory has these rows; `change` may add to it.
template <class Change>
std::string made(std::vector<Small> rows, Change change) {
  const TestFolder folder;
  {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const hsize_t count = rows.size();
    const Hdf5Handle type = small_type(), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle dataset(
        H5Dcreate2(file.get(), "trajectory", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    REQUIRE(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()) >= 0);
    change(file.get(), dataset.get());
  }
  return *read_file(folder / "a.h5");
}

}  // namespace

TEST_CASE("HDF5 has the columns and attributes that PedPy and h5py look for") {
  const TestFolder folder;
  REQUIRE(write_trajectories(example(), folder / "a.h5").ok());
  const Hdf5Session session;
  const Hdf5Handle file(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle dataset(H5Dopen2(file.get(), "trajectory", H5P_DEFAULT), H5Dclose);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  REQUIRE(H5Tget_nmembers(type.get()) == 5);
  constexpr const char* kColumns[] = {"id", "frame", "x", "y", "z"};
  for (unsigned k = 0; k < 5; ++k) {
    char* name = H5Tget_member_name(type.get(), k);
    CHECK(std::string(name) == kColumns[k]);
    H5free_memory(name);
    const Hdf5Handle member(H5Tget_member_type(type.get(), k), H5Tclose);
    CHECK(H5Tequal(member.get(), k < 2 ? H5T_STD_I64LE : H5T_IEEE_F64LE) > 0);
    CHECK(hdf5_text(dataset.get(), kColumns[k]).has_value());
  }
  CHECK(hdf5_number(dataset.get(), "fps") == 16);
  CHECK(hdf5_number(file.get(), "fps") == 16);
  CHECK(hdf5_number(file.get(), "schema_version") == 2);
  CHECK(hdf5_number(file.get(), "xmin") == -1);
  CHECK(hdf5_number(file.get(), "ymax") == 7.5);
  CHECK(hdf5_text(file.get(), "producer") == "inhabit");
  CHECK(hdf5_text(file.get(), "wkt_geometry") ==
        "POLYGON ((-1 -1, 9 -1, 9 7.5, -1 7.5, -1 -1), (4 4, 5 4, 5 5, 4 5, 4 4))");
  CHECK(hdf5_text(dataset.get(), "column_units") == R"({"id": "1", "frame": "1", "x": "m", "y": "m", "z": "m"})");
  // A text of fixed length would reach PedPy as bytes, which its WalkableArea refuses.
  const Hdf5Handle attribute(H5Aopen(file.get(), "wkt_geometry", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle text(H5Aget_type(attribute.get()), H5Tclose);
  CHECK(H5Tis_variable_str(text.get()) > 0);
}

TEST_CASE("HDF5 columns are found by name and converted") {
  const std::string bytes = made({{5, 2, 1.5, 2}, {4, 1, 0.5, 0.25F}}, [](hid_t file, hid_t dataset) {
    REQUIRE(set_hdf5_whole(dataset, "fps", 10));
    REQUIRE(set_hdf5_text(file, "wkt_geometry", "POLYGON((0 0, 0 3, 4 3, 0 0))"));
  });
  const Trajectories t = read_text(bytes);
  CHECK(t.frame_rate == 10);
  CHECK(t.fixes == std::vector<Fix>{{4, 1, 0.5, 0.25}, {5, 2, 1.5, 2}});
  CHECK(t.walkable.size() == 1);
}

TEST_CASE("the frame rate of HDF5 may be in the file or in the step of a simulation") {
  const auto rows = std::vector<Small>{{1, 1, 0, 0}, {2, 1, 0.05F, 0}};
  CHECK(read_text(made(rows, [](hid_t file, hid_t) { REQUIRE(set_hdf5_number(file, "fps", 16)); })).frame_rate == 16);
  CHECK(read_text(made(rows, [](hid_t file, hid_t) {
          REQUIRE(set_hdf5_number(file, "dt", 0.01));
          REQUIRE(set_hdf5_whole(file, "every_nth_frame", 4));
        })).frame_rate == doctest::Approx(25));
  CHECK(refusal(made(rows, [](hid_t, hid_t) {})).starts_with("the file does not say its frame rate: --fps N says it"));
}

TEST_CASE("HDF5 without what is needed is refused by name") {
  const TestFolder folder;
  const auto file_with = [&](const char* column) {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fcreate((folder / "b.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    if (column != nullptr) {
      const Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 8), H5Tclose);
      H5Tinsert(type.get(), column, 0, H5T_NATIVE_DOUBLE);
      const hsize_t count = 1;
      const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
      const Hdf5Handle dataset(
          H5Dcreate2(file.get(), "trajectory", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
          H5Dclose);
    }
    return folder / "b.h5";
  };
  CHECK(refusal(*read_file(file_with(nullptr))) == "HDF5: there is no dataset /trajectory");
  CHECK(refusal(*read_file(file_with("id"))) == "HDF5: /trajectory has no column frame");
}

TEST_CASE("HDF5 that is cut off anywhere is one clear error") {
  Trajectories t = example();
  for (int frame = 2; frame < 3000; ++frame) t.fixes.push_back({frame, 3, 0.01 * frame, 0.001 * frame * (frame % 7)});
  const std::string bytes = written(t);
  std::size_t read = 0;
  for (std::size_t size = 8; size < bytes.size(); size += 1 + size / 20) {
    const auto result = read_trajectories(std::string_view(bytes).substr(0, size), "a.h5");
    read += result.ok();
    if (!result.ok()) CHECK(result.error().text().starts_with("HDF5: "));
  }
  CHECK(read == 0);
  CHECK(refusal("", {}, "a.h5") == "HDF5: the file is damaged or cut off");
}

TEST_CASE("HDF5 that sends the library round in circles is refused") {
  std::string bytes = *read_file(std::string(INHABIT_SOURCE_DIR) + "/fuzz/corpus/trajectory_hdf5/small.h5");
  // The heap of its texts: behind the head of 16 bytes, objects of no size follow each other for ever.
  const std::size_t heap = bytes.find("GCOL");
  REQUIRE(heap + 4096 <= bytes.size());
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(heap) + 16, 4080, '\0');
  CHECK(refusal(bytes) == "HDF5: the file is damaged: the HDF5 library could not cope with it");
}

TEST_CASE("HDF5 that promises more rows than it holds is refused before memory is asked for") {
  const TestFolder folder;
  {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const hsize_t count = 100'000'000, chunk = 1000;
    const Hdf5Handle type = small_type(), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle plist(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(plist.get(), 1, &chunk);
    const Hdf5Handle dataset(
        H5Dcreate2(file.get(), "trajectory", type.get(), space.get(), H5P_DEFAULT, plist.get(), H5P_DEFAULT), H5Dclose);
    REQUIRE(set_hdf5_number(dataset.get(), "fps", 25));
  }
  CHECK(refusal(*read_file(folder / "a.h5")) ==
        "HDF5: /trajectory says that it has 100000000 rows, which are not in the file");
}

TEST_CASE("HDF5 cannot lead to other files") {
  const TestFolder folder;
  {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fcreate((folder / "link.h5").c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    REQUIRE(H5Lcreate_external((folder / "other.h5").c_str(), "/trajectory", file.get(), "trajectory", H5P_DEFAULT,
                               H5P_DEFAULT) >= 0);
    const Hdf5Handle raw(H5Fcreate((folder / "raw.h5").c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const hsize_t count = 2;
    const Hdf5Handle type = small_type(), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle plist(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    REQUIRE(H5Pset_external(plist.get(), "/etc/hostname", 0, 32) >= 0);
    const Hdf5Handle dataset(
        H5Dcreate2(raw.get(), "trajectory", type.get(), space.get(), H5P_DEFAULT, plist.get(), H5P_DEFAULT), H5Dclose);
    REQUIRE(dataset);
  }
  REQUIRE(write_trajectories(example(), folder / "other.h5").ok());
  CHECK(refusal(*read_file(folder / "link.h5")) == "HDF5: there is no dataset /trajectory");
  CHECK(refusal(*read_file(folder / "raw.h5")) == "HDF5: the rows of /trajectory are in another file");
}

TEST_CASE("a number in HDF5 that does not fit is an error and not the nearest one") {
  std::string bytes = made({{4294967295U, 2, 1.5, 2}, {4, 1, 0.5, 0.25F}},
                           [](hid_t, hid_t dataset) { REQUIRE(set_hdf5_whole(dataset, "fps", 10)); });
  CHECK(refusal(bytes) == "row 1 of /trajectory: frame 4294967295 does not fit 32 bits");
}
