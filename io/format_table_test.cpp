#include "io/format_table.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "io/file.h"
#include "io/scene_examples.h"

using namespace inhabit::io;
namespace fs = std::filesystem;

namespace {

struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() /
                  ("inhabit-io-test-" +
                   std::to_string(std::hash<std::string>{}(doctest::getContextOptions()->binary_name.c_str())) + "-" +
                   std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  TemporaryFolder() { fs::create_directories(path); }
  ~TemporaryFolder() { fs::remove_all(path); }
};

std::string gzip(std::string_view text) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(text.size() + 100, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data())),
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data()), stream.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

TEST_CASE("a file is written whole or not at all") {
  const TemporaryFolder folder;
  const fs::path path = folder.path / "a.json";
  REQUIRE(write_file_atomically(path, "first").ok());
  REQUIRE(write_file_atomically(path, "second").ok());
  CHECK(*read_file(path) == "second");
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
  CHECK(write_file_atomically(folder.path / "none" / "a.json", "x").error().code ==
        inhabit::core::ErrorCode::not_found);
  // A folder cannot be replaced by a file; nothing is left behind.
  fs::create_directories(folder.path / "full" / "inside");
  CHECK_FALSE(write_file_atomically(folder.path / "full", "x").ok());
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 2);
}

TEST_CASE("what cannot be read says why") {
  const TemporaryFolder folder;
  CHECK(read_file(folder.path / "none").error().code == inhabit::core::ErrorCode::not_found);
  CHECK(read_file(folder.path).error().message == "is a folder, not a file");
  std::ofstream(folder.path / "large") << std::string(3000000, 'x');
  CHECK(read_file(folder.path / "large", 1 << 20).error().message == "is larger than 1 MiB");
}

TEST_CASE("gzip is unpacked and damage is told") {
  const std::string packed = gzip("hello") + gzip(" world");
  CHECK(*gunzip(packed) == "hello world");
  CHECK_FALSE(gunzip(packed.substr(0, packed.size() - 3)).ok());
  CHECK_FALSE(gunzip("\x1f\x8b\x08").ok());
  CHECK(gunzip(gzip(std::string(3000000, ' ')), 1 << 20).error().message == "gzip: larger than 1 MiB when unpacked");
  CHECK_FALSE(read_any_bytes(gzip(gzip("hello")), "a.gz").ok());
}

TEST_CASE("a file is known by what is in it") {
  CHECK(read_any_bytes(kFullScene, "a.txt").ok());
  CHECK(read_any_bytes(gzip(kFullScene), "a.json.gz").ok());
  CHECK(read_any_bytes("\n POLYGON((0 0, 1 0, 0 1, 0 0))", "a").ok());
  CHECK(read_any_bytes(R"({"type": "Polygon", "coordinates": [[[0, 0], [900, 0], [0, 1], [0, 0]]]})", "a.json").ok());
  CHECK(read_any_bytes(R"({"rooms": [{"roomType": "Kitchen"}]})", "a.json").error().message.find("asset database") !=
        std::string::npos);
  CHECK(read_any_bytes("hello", "a.txt").error().code == inhabit::core::ErrorCode::unsupported);
  CHECK(read_any_bytes("{\"x\": }", "a.json").error().where == "line 1, column 7");
  CHECK(format_to_write("a.JSON")->name == "scene");
  CHECK(format_to_write("a.wkt") == nullptr);
  CHECK(format_to_write("a.sh3d")->homes);
  CHECK(format_to_write("Home.xml") == nullptr);
  const auto home = read_any_bytes(
      "<home><room name='A'><point x='0' y='0'/><point x='0' y='300'/><point x='300' y='0'/>"
      "</room></home>",
      "a.txt");
  REQUIRE(home.ok());
  CHECK(home->home);
  CHECK(home->scenes.front().name == "A");
}

TEST_CASE("options that a format has no use for are refused") {
  CHECK(read_any_bytes(kFullScene, "a.json", {.line = 2}).error().message ==
        "--line is for ProcTHOR houses, and this is another format: scene");
  CHECK(read_any_bytes(gzip("POLYGON((0 0, 1 0, 0 1, 0 0))"), "a", {.asset_database = "a.json"}).error().message ==
        "--assets is for ProcTHOR houses, and this is another format: wkt");
}

TEST_CASE("errors name the file") {
  const TemporaryFolder folder;
  const fs::path path = folder.path / "bad.json";
  std::ofstream(path) << R"({"space": {"outline": 1}})";
  CHECK(read_any(path).error().text() == path.string() + ": /space/outline: is a number where a list belongs");
}
