#pragma once
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "io/file.h"
#include "io/trajectory_table.h"

/// For tests of trajectories.
namespace inhabit::io {

/// Fails the test when the text is refused.
inline scene::Trajectories read_text(std::string_view text, const TrajectoryOptions& options = {},
                                     std::string_view name = "test") {
  Result<scene::Trajectories> trajectories = read_trajectories(text, name, options);
  REQUIRE_MESSAGE(trajectories.ok(), trajectories.error().text());
  return *std::move(trajectories);
}
/// The error; fails the test when there is none.
inline std::string refusal(std::string_view text, const TrajectoryOptions& options = {},
                           std::string_view name = "test") {
  const Result<scene::Trajectories> trajectories = read_trajectories(text, name, options);
  REQUIRE_FALSE(trajectories.ok());
  return trajectories.error().text();
}
inline bool has_remark(const scene::Trajectories& trajectories, std::string_view part) {
  for (const std::string& remark : trajectories.remarks)
    if (remark.find(part) != std::string::npos) return true;
  return false;
}
/// Metres per second between a person's neighbouring rows.
inline double median_speed(const scene::Trajectories& trajectories) {
  const scene::Tracks tracks = scene::tracks_of(trajectories);
  std::vector<double> speeds;
  for (std::size_t k = 0; k < tracks.size(); ++k)
    for (std::size_t i = 1; i < tracks[k].size(); ++i) {
      const scene::Fix &a = trajectories.fixes[tracks[k][i - 1]], &b = trajectories.fixes[tracks[k][i]];
      speeds.push_back(length(b.at() - a.at()) * trajectories.frame_rate / (b.frame - a.frame));
    }
  REQUIRE(!speeds.empty());
  std::ranges::nth_element(speeds, speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2));
  return speeds[speeds.size() / 2];
}

/// A folder of its own that is removed at the end.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "inhabit-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

/// Two people, three frames from -1 on, a floor with a hole.
inline scene::Trajectories example() {
  scene::Trajectories t;
  t.frame_rate = 16;
  t.name = "two people";
  t.walkable = {{{{-1, -1}, {9, -1}, {9, 7.5}, {-1, 7.5}}, {{{4, 4}, {5, 4}, {5, 5}, {4, 5}}}}};
  t.fixes = {{-1, 3, 0.0625, 1}, {-1, 7, 2, 1.5},        {0, 3, 0.125, 1},
             {0, 7, 2, 1.4375},  {1, 3, 0.1875, 0.9375}, {1, 7, 2, 1.375}};
  return t;
}
inline void check_same(const scene::Trajectories& a, const scene::Trajectories& b, double tolerance = 0) {
  REQUIRE(a.fixes.size() == b.fixes.size());
  CHECK(a.frame_rate == b.frame_rate);
  for (std::size_t k = 0; k < a.fixes.size(); ++k) {
    CHECK(a.fixes[k].frame == b.fixes[k].frame);
    CHECK(a.fixes[k].person == b.fixes[k].person);
    CHECK(std::abs(a.fixes[k].x - b.fixes[k].x) <= tolerance);
    CHECK(std::abs(a.fixes[k].y - b.fixes[k].y) <= tolerance);
  }
}

}  // namespace inhabit::io
