#include "core/test_data.h"
#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

namespace {

struct Recording {
  const char* path;
  std::size_t rows, people;
  double frame_rate;
  double slowest, fastest;  ///< what the median speed lies between: 0.1 m/s of what an own script found
  TrajectoryOptions options = {};
};

const TrajectoryOptions kHermes{.unit = LengthUnit::centimetres, .frame_rate = 16};
const TrajectoryOptions kMetres{.unit = LengthUnit::metres};

/// Rows, people and rates as the data's README has them.
const Recording kRecordings[] = {
    {"juelich/bottleneck_wuppertal2018/040_c_56_h-.txt", 63110, 75, 25, 0.1, 0.4},
    {"juelich/hermes_uo/uo-050-180-180.txt", 9712, 61, 16, 1.3, 1.5, kHermes},
    {"juelich/hermes_uo/uo-100-180-180.txt", 21676, 121, 16, 1.1, 1.3, kHermes},
    {"juelich/hermes_uo/uo-145-180-180.txt", 41133, 175, 16, 0.85, 1.05, kHermes},
    {"juelich/hermes_uo/uo-180-180-120.txt", 54981, 170, 16, 0.55, 0.75, kHermes},
    {"juelich/hermes_bo/bo-360-050-050.txt", 18261, 118, 16, 1.4, 1.6, kHermes},
    {"juelich/hermes_bo/bo-360-090-090.txt", 38689, 214, 16, 1.2, 1.4, kHermes},
    {"juelich/hermes_corner/traj.txt", 18704, 137, 16, 1.0, 1.2, kMetres},
    {"juelich/hermes_t_junction/traj_KO_240_050_240.txt", 13569, 134, 16, 1.2, 1.5},
    {"juelich/basigo_unidir/traj_UNI_CORR_500_01.txt", 25536, 148, 25, 1.3, 1.5, kMetres},
    {"juelich/school_bottleneck_hdf5/00_01a.h5", 30701, 46, 25, 0.1, 0.8},
    {"juelich/single_file/n34_cam2.csv", 1101, 71, 25, 0.1, 0.6},
    {"juelich/single_file/subaih2019/UX_14_1.txt", 6131, 72, 25, 0.5, 1.2},
    {"juelich/single_file/subaih2019/UX_20_1.txt", 15178, 104, 25, 0.3, 0.9},
    {"juelich/single_file/subaih2019/UX_30_1.txt", 34295, 92, 25, 0.05, 0.5},
    {"juelich/single_file/paetzke2023/croma_female_04_1.txt", 12328, 4, 25, 0.8, 1.4},
    {"eth_ucy/eth/obsmat.txt", 8908, 360, 15, 1.2, 1.5},
    {"eth_ucy/zara01/obsmat.txt", 5024, 148, 25, 1.0, 1.3},
    {"eth_ucy/zara02/obsmat.txt", 9537, 204, 25, 0.8, 1.3},
    {"eth_ucy/students03/students003.txt", 17953, 434, 25, 0.6, 0.8, {LengthUnit::metres, 25, {}}},
    {"format_fixtures/jupedsim_v2_trajectories.sqlite", 8083, 30, 25, 0.1, 1.4},
    {"format_fixtures/crowdit.csv.gz", 791, 20, 2, 0.4, 1.6},
    {"format_fixtures/vadere_postvis.traj", 6936, 20, 25, 0.4, 1.8},
};

}  // namespace

TEST_CASE("real recordings have the rows people and speeds that are known of them") {
  const auto folder = INHABIT_TEST_DATA("pedestrians");
  if (!folder) return;
  for (const Recording& r : kRecordings) {
    CAPTURE(r.path);
    const auto t = read_trajectories(*folder / r.path, r.options);
    REQUIRE_MESSAGE(t.ok(), t.error().text());
    CHECK(t->fixes.size() == r.rows);
    CHECK(inhabit::scene::tracks_of(*t).size() == r.people);
    CHECK(t->frame_rate == r.frame_rate);
    const double speed = median_speed(*t);
    CHECK(speed > r.slowest);
    CHECK(speed < r.fastest);
  }
}

TEST_CASE("the page about formats has a row for each of them") {
  const auto page = read_file(std::filesystem::path(INHABIT_SOURCE_DIR) / "docs/formats.md");
  REQUIRE(page.ok());
  for (const TrajectoryFormat& format : trajectory_formats()) {
    CAPTURE(format.name);
    CHECK(page->find("\n| " + std::string(format.name)) != std::string::npos);
    CHECK(page->find("`." + std::string(format.extensions.substr(0, format.extensions.find(' '))) + "`") !=
          std::string::npos);
  }
}

TEST_CASE("real recordings that leave something open are asked about") {
  const auto folder = INHABIT_TEST_DATA("pedestrians");
  if (!folder) return;
  for (const Recording& r : kRecordings) {
    if (!r.options.unit) continue;
    const auto t = read_trajectories(*folder / r.path);
    REQUIRE_FALSE(t.ok());
    CHECK(t.error().message.find("--unit cm|m") != std::string::npos);
    CHECK((t.error().message.find("--fps N") != std::string::npos) == r.options.frame_rate.has_value());
    CHECK(t.error().message.find("the median speed would be") != std::string::npos);
  }
}

TEST_CASE("splines through their homography are where the published positions are") {
  const auto folder = INHABIT_TEST_DATA("pedestrians/eth_ucy/students03");
  if (!folder) return;
  const auto splines = read_trajectories(*folder / "annotation.vsp", {.homography = *folder / "H.txt"});
  REQUIRE_MESSAGE(splines.ok(), splines.error().text());
  const auto rows = read_trajectories(*folder / "students003.txt", {LengthUnit::metres, 25, {}});
  REQUIRE(rows.ok());
  const auto key = [](const Fix& fix) { return std::pair(fix.frame, fix.person); };
  std::size_t found = 0, near = 0;
  for (const Fix& fix : rows->fixes) {
    const auto same = std::ranges::lower_bound(splines->fixes, key(fix), {}, key);
    if (same == splines->fixes.end() || key(*same) != key(fix)) continue;
    ++found;
    near += length(same->at() - fix.at()) < 0.05;
  }
  MESSAGE(found, " of ", rows->fixes.size(), " positions are in both, ", near, " within 5 cm");
  // The published ones go on for a row after a spline has ended.
  CHECK(found > 0.97 * static_cast<double>(rows->fixes.size()));
  CHECK(near == found);
}

TEST_CASE("every real recording survives every format that is written") {
  const auto folder = INHABIT_TEST_DATA("pedestrians");
  if (!folder) return;
  const TestFolder out;
  for (const Recording& r : kRecordings) {
    CAPTURE(r.path);
    const auto t = read_trajectories(*folder / r.path, r.options);
    REQUIRE(t.ok());
    for (const char* name : {"a.txt", "a.csv", "a.h5", "a.sqlite"}) {
      CAPTURE(name);
      REQUIRE(write_trajectories(*t, out / name).ok());
      const auto again = read_trajectories(out / name);
      REQUIRE_MESSAGE(again.ok(), again.error().text());
      REQUIRE(again->fixes.size() == t->fixes.size());
      CHECK(again->frame_rate == t->frame_rate);
      double worst = 0;
      for (std::size_t k = 0; k < t->fixes.size(); ++k) {
        REQUIRE(again->fixes[k].frame == t->fixes[k].frame);
        REQUIRE(again->fixes[k].person == t->fixes[k].person);
        worst =
            std::max({worst, std::abs(again->fixes[k].x - t->fixes[k].x), std::abs(again->fixes[k].y - t->fixes[k].y)});
      }
      const bool rounded = std::string_view(name) == "a.txt" || std::string_view(name) == "a.csv";
      CHECK(worst <= (rounded ? 0.5001e-4 : 0));
    }
  }
}

TEST_CASE("reading leaves a database and what is beside it as they were") {
  const auto source = INHABIT_TEST_DATA("pedestrians/format_fixtures/jupedsim_v2_trajectories.sqlite");
  if (!source) return;
  const TestFolder folder;
  std::filesystem::copy_file(*source, folder / "a.sqlite");
  std::filesystem::permissions(folder / "a.sqlite", std::filesystem::perms::owner_read);
  const std::string before = *read_file(folder / "a.sqlite");
  const auto t = read_trajectories(folder / "a.sqlite");
  REQUIRE(t.ok());
  REQUIRE(t->walkable.size() == 1);
  CHECK(t->walkable[0].size() > 0);
  CHECK((*read_file(folder / "a.sqlite") == before));
  CHECK(folder.files() == 1);
}
