#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

namespace {

constexpr const char* kNames[] = {"a.txt", "a.csv", "a.h5", "a.sqlite"};

/// A crowd that walks in circles: more rows than are kept before they go to the disk.
Trajectories crowd(int people, int frames) {
  Trajectories t;
  t.frame_rate = 25;
  t.fixes.reserve(static_cast<std::size_t>(people * frames));
  for (int frame = 0; frame < frames; ++frame)
    for (int person = 1; person <= people; ++person) {
      const double angle = 0.01 * frame + person;
      t.fixes.push_back(
          {frame, person, 4 * std::cos(angle) + 9 * (person % 40), 4 * std::sin(angle) + 9 * (person / 40.0)});
    }
  return t;
}

}  // namespace

TEST_CASE("what is written in any format is read back") {
  const TestFolder folder;
  for (const char* name : kNames) {
    CAPTURE(name);
    const std::filesystem::path path = folder / name;
    const auto written = write_trajectories(example(), path);
    REQUIRE_MESSAGE(written.ok(), written.error().text());
    const auto read = read_trajectories(path);
    REQUIRE_MESSAGE(read.ok(), read.error().text());
    check_same(*read, example());
    CHECK(read->remarks.empty());
    if (std::string_view(name) == "a.csv") continue;
    CHECK(read->name == "two people");
    REQUIRE(read->walkable.size() == 1);
    CHECK(read->walkable[0].outline == example().walkable[0].outline);
    CHECK(read->walkable[0].holes == example().walkable[0].holes);
  }
  CHECK(folder.files() == std::size(kNames));
}

TEST_CASE("the same trajectories give the same bytes") {
  const TestFolder folder;
  const Trajectories t = crowd(300, 100);
  for (const char* name : kNames) {
    CAPTURE(name);
    std::string first;
    for (int run = 0; run < 2; ++run) {
      REQUIRE(write_trajectories(t, folder / name).ok());
      const auto bytes = read_file(folder / name);
      REQUIRE(bytes.ok());
      if (run == 0)
        first = *bytes;
      else
        CHECK((first == *bytes));
    }
    const auto read = read_trajectories(folder / name);
    REQUIRE_MESSAGE(read.ok(), read.error().text());
    // Text and CSV are rounded to 0.1 mm; half of that and what the last digit of a double adds.
    const bool text = std::string_view(name) == "a.txt" || std::string_view(name) == "a.csv";
    check_same(*read, t, text ? 0.5001e-4 : 0);
  }
}

TEST_CASE("text is written as others expect it") {
  const TestFolder folder;
  REQUIRE(write_trajectories(example(), folder / "a.txt").ok());
  CHECK(*read_file(folder / "a.txt") ==
        "# framerate: 16 fps\n# title: two people\n"
        "# walkable area: POLYGON ((-1 -1, 9 -1, 9 7.5, -1 7.5, -1 -1), (4 4, 5 4, 5 5, 4 5, 4 4))\n"
        "# id frame x/m y/m z/m\n3 -1 0.0625 1 0\n7 -1 2 1.5 0\n3 0 0.125 1 0\n7 0 2 1.4375 0\n3 1 0.1875 0.9375 0\n"
        "7 1 2 1.375 0\n");
  REQUIRE(write_trajectories(example(), folder / "a.csv").ok());
  CHECK(read_file(folder / "a.csv")->starts_with("id,frame,x,y,t\n3,-1,0.0625,1,-0.0625\n"));
}

TEST_CASE("numbers are rounded to the digits asked for") {
  const auto text = [](double value, int digits) {
    std::string out;
    append_rounded(out, value, digits);
    return out;
  };
  CHECK(text(0, 4) == "0");
  CHECK(text(-0.00004, 4) == "0");
  CHECK(text(-0.00006, 4) == "-0.0001");
  CHECK(text(12.5, 4) == "12.5");
  CHECK(text(-12.99996, 4) == "-13");
  CHECK(text(0.1, 6) == "0.1");
  CHECK(text(5268347.25, 4) == "5268347.25");
  CHECK(text(1e300, 4) == "1e+300");
}

TEST_CASE("a process that dies leaves whole frames in the temporary file") {
  const TestFolder folder;
  const Trajectories t = crowd(3000, 20);
  for (const char* name : kNames) {
    CAPTURE(name);
    auto writer = TrajectoryWriter::open(folder / name, {25, {}, "", ""});
    REQUIRE(writer.ok());
    std::vector<Spot> people;
    for (const Fix& fix : t.fixes) {
      people.push_back({fix.person, fix.x, fix.y});
      if (people.size() < 3000) continue;
      REQUIRE(writer->add(fix.frame, people).ok());
      people.clear();
    }
    // What the next process would find: a copy of everything there is now, before finish().
    std::filesystem::path part;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
      if (entry.path().filename().string().starts_with(std::string(name) + ".part-") &&
          !entry.path().string().ends_with("-journal"))
        part = entry.path();
    REQUIRE(!part.empty());
    const auto left = read_trajectories(part);
    REQUIRE_MESSAGE(left.ok(), left.error().text());
    CHECK(left->fixes.size() >= 40'000);
    CHECK(left->fixes.size() % 3000 == 0);
    CHECK_FALSE(std::filesystem::exists(folder / name));
    REQUIRE(writer->finish().ok());
    CHECK(read_trajectories(folder / name)->fixes.size() == 60'000);
  }
  CHECK(folder.files() == std::size(kNames));
}

TEST_CASE("a writer that is given up leaves what was there") {
  const TestFolder folder;
  for (const char* name : kNames) {
    CAPTURE(name);
    REQUIRE(write_file_atomically(folder / name, "mine").ok());
    {
      auto writer = TrajectoryWriter::open(folder / name, {});
      REQUIRE(writer.ok());
      const Spot spot{1, std::numeric_limits<double>::quiet_NaN(), 0};
      CHECK(writer->add(3, std::span(&spot, 1)).error().text() == "person 1 is at no finite place in frame 3");
    }
    CHECK(*read_file(folder / name) == "mine");
  }
  CHECK(folder.files() == std::size(kNames));
}

TEST_CASE("a file that cannot be written is refused before the work") {
  const TestFolder folder;
  CHECK(TrajectoryWriter::open(folder / "a.docx", {}).error().text() ==
        "trajectories are written to files with one of these extensions: .h5, .sqlite, .csv, .txt");
  CHECK_FALSE(TrajectoryWriter::open(folder / "no/such/folder.txt", {}).ok());
  CHECK_FALSE(TrajectoryWriter::open(folder / "", {}).ok());
  CHECK_FALSE(TrajectoryWriter::open(folder / "a.txt", {.frame_rate = 0}).ok());
  CHECK(folder.files() == 0);
}

TEST_CASE("titles cannot break the header that readers look for") {
  const TestFolder folder;
  Trajectories t = example();
  t.name = "framerate: 99\n# x/cm in cm";
  for (const char* name : {"a.txt", "a.h5", "a.sqlite"}) {
    REQUIRE(write_trajectories(t, folder / name).ok());
    check_same(*read_trajectories(folder / name), example());
  }
}
