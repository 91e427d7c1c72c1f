#pragma once
#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "core/test_data.h"
#include "crowd/measures/area_density.h"
#include "crowd/measures/fundamental.h"
#include "crowd/measures/test_recording.h"

/// For tests only: the real recordings and the curves published for them. A reader of the one text format that these
/// files have; what users read comes through io/.
namespace inhabit::crowd {

/// `id frame x y …` in rows, # before comments. `unit`: metres per unit of the file.
inline std::optional<scene::Trajectories> recorded(std::string_view name, double frame_rate, double unit,
                                                   geometry::Ring walkable) {
  const auto file_path = INHABIT_TEST_DATA("pedestrians/juelich/" + std::string(name));
  if (!file_path) return std::nullopt;
  scene::Trajectories t;
  t.frame_rate = frame_rate;
  if (!walkable.empty()) t.walkable = {{std::move(walkable), {}}};
  std::ifstream file(*file_path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream row(line);
    scene::Fix fix;
    if (row >> fix.person >> fix.frame >> fix.x >> fix.y) fix.x *= unit, fix.y *= unit, t.fixes.push_back(fix);
  }
  std::ranges::sort(t.fixes, {}, [](const scene::Fix& f) { return std::pair(f.frame, f.person); });
  return t;
}

/// Two columns, density and speed, of all the files named.
inline std::vector<FundamentalPoint> published(std::initializer_list<std::string_view> names) {
  std::vector<FundamentalPoint> points;
  for (const std::string_view name : names) {
    const auto file_path = INHABIT_TEST_DATA("pedestrians/reference_fd/" + std::string(name));
    if (!file_path) return {};
    std::ifstream file(*file_path);
    for (std::string line; std::getline(file, line);) {
      std::istringstream row(line);
      FundamentalPoint p;
      if (row >> p.density >> p.speed) points.push_back(p);
    }
  }
  return points;
}

}  // namespace inhabit::crowd
