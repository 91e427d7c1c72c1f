#include "io/trajectory_checks.h"

#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

namespace {

std::string petrack(std::string_view rows) { return "# framerate: 25 fps\n# id frame x/m y/m\n" + std::string(rows); }

}  // namespace

TEST_CASE("rows in any order come sorted") {
  const Trajectories t = read_text(petrack("2 1 0 0\n1 2 0.05 0\n1 1 0 1\n2 2 0.05 0\n"));
  CHECK(t.fixes == std::vector<Fix>{{1, 1, 0, 1}, {1, 2, 0, 0}, {2, 1, 0.05, 0}, {2, 2, 0.05, 0}});
}

TEST_CASE("a row given twice counts once and a contradicting one is an error with its line") {
  const Trajectories t = read_text(petrack("1 1 0 0\n1 2 0.05 0\n1 1 0 0\n"));
  CHECK(t.fixes.size() == 2);
  CHECK(has_remark(t, "1 rows say what another one says"));
  CHECK(refusal(petrack("1 1 0 0\n1 2 0.05 0\n1 1 0.5 0\n")) ==
        "line 5: person 1 is at another place in frame 1 than line 3 says");
}

TEST_CASE("gaps and jumps are counted and the worst is named") {
  const Trajectories t = read_text(petrack("1 1 0 0\n1 2 0.05 0\n1 3 0.1 0\n1 8 0.35 0\n1 9 1.35 0\n"));
  CHECK(has_remark(t, "1 gap in the tracks, the longest 5 frames: person 1 after frame 3"));
  CHECK(has_remark(t, "1 step faster than 3 m/s, the fastest 25 m/s: person 1 after frame 8"));
}

TEST_CASE("numbers that are none have no place in a trajectory") {
  CHECK(refusal(petrack("1 1 0 0\n1 2 nan 0\n")) == "line 4: a position must be a finite number");
  CHECK(refusal(petrack("1 1 0 inf\n")) == "line 3: a position must be a finite number");
  CHECK(refusal(petrack("1 1 0 1e12\n")) == "line 3: (0, 1e+12) is no position on a plan");
  CHECK(refusal(petrack("1 1.5 0 0\n")) == "line 3: frame: \"1.5\" is no whole number");
  CHECK(refusal(petrack("1 4294967296 0 0\n")) == "line 3: frame 4294967296 does not fit 32 bits");
  CHECK(refusal(petrack("")) == "there is no position in it");
  CHECK(refusal("") ==
        "none of the known formats of trajectories: hdf5, sqlite, trajnet++, viswalk, splines, sumo, "
        "vadere, csv, petrack, obsmat, columns");
  CHECK(refusal("# framerate: 0 fps\n# x/m\n1 1 0 0\n") ==
        "a frame rate of 0 is none; it is above 0 and at most 10000");
  CHECK(refusal("id,t,x,y\n1,nan,0,0\n") == "line 2: the time must be a finite number");
}

TEST_CASE("an unlikely median speed is remarked on with what it may come from") {
  CHECK(has_remark(read_text(petrack("1 1 0 0\n1 2 5 0\n1 3 10 0\n")),
                   "the median speed is 125 m/s, which nobody walks; centimetres? (--unit cm)"));
  CHECK(has_remark(read_text("# framerate: 25\n# x/cm\n1 1 0 0\n1 2 0.05 0\n1 3 0.1 0\n"),
                   "the median speed is 0.013 m/s; metres, or another frame rate? (--unit, --fps)"));
  CHECK(read_text(petrack("1 1 0 0\n1 2 0.05 0\n1 3 0.1 0\n")).remarks.empty());
}

TEST_CASE("what is asked for counts more than the file and is said to") {
  const Trajectories t =
      read_text(petrack("1 1 100 0\n1 2 110 0\n"), {.unit = LengthUnit::centimetres, .frame_rate = 16});
  CHECK(t.frame_rate == 16);
  CHECK(t.fixes[0].x == 1);
  CHECK(has_remark(t, "the file says m, but --unit cm counts"));
  CHECK(has_remark(t, "the file says 25 frames per second, but --fps 16 counts"));
}

TEST_CASE("numbers of people beyond 32 bits are replaced in order") {
  const Trajectories t = read_text(petrack("5 1 0 0\n9000000000 1 1 0\n-7 1 2 0\n"));
  CHECK(t.fixes == std::vector<Fix>{{1, 1, 2, 0}, {1, 2, 0, 0}, {1, 3, 1, 0}});
  CHECK(has_remark(t, "do not fit 32 bits"));
}

TEST_CASE("a clock that starts far from zero keeps its frames in 32 bits") {
  const Trajectories t = read_text("id,t,x,y\n1,1700000000.25,0,0\n1,1700000000.5,0.3,0\n1,1700000000.75,0.6,0\n");
  CHECK(t.frame_rate == 4);
  CHECK(t.fixes[0].frame == 1);
  CHECK(has_remark(t, "frame 0 is at 1700000000 s of the file"));
}

TEST_CASE("few bytes cannot ask for endless interpolation") {
  CHECK(refusal("pedestrianId simTime startX startY\n1 0 0 0\n1 1e7 1 1\n").find("a smaller --fps has fewer") !=
        std::string::npos);
  CHECK(refusal("pedestrianId simTime startX startY\n1 0 0 0\n1 1e11 1 1\n").find("32 bits") != std::string::npos);
}

TEST_CASE("packed files are unpacked once and within bounds") {
  // gzip of "id,frame,x,y,t\n1,0,0,0,0\n1,1,1,0,1\n"
  constexpr unsigned char kPacked[] = {31,  139, 8,   0,   0,   0,   0,   0,  2,   255, 203, 76, 209, 73, 43, 74,
                                       204, 77,  213, 169, 208, 169, 212, 41, 225, 50,  212, 49, 128, 64, 32, 11,
                                       4,   13,  116, 12,  185, 0,   210, 61, 25,  162, 35,  0,  0,   0};
  const std::string_view packed(reinterpret_cast<const char*>(kPacked), sizeof kPacked);
  CHECK(are_trajectories(packed));
  CHECK(read_text(packed, {}, "a.csv.gz").fixes.size() == 2);
  CHECK(refusal(packed.substr(0, 30)) == "gzip: damaged or cut off");
}
