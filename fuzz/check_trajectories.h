#pragma once
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "io/trajectory_table.h"

namespace inhabit::fuzz {

inline std::string_view bytes_of(const unsigned char* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// What everything behind the readers relies on.
inline void check_trajectories(const core::Result<scene::Trajectories>& trajectories) {
  if (!trajectories.ok()) return;
  const scene::Trajectories& t = *trajectories;
  if (t.fixes.empty() || !(t.frame_rate > 0) || !std::isfinite(t.frame_rate)) std::abort();
  for (std::size_t k = 0; k < t.fixes.size(); ++k) {
    const scene::Fix& fix = t.fixes[k];
    if (!std::isfinite(fix.x) || !std::isfinite(fix.y)) std::abort();
    if (k > 0 && std::pair(t.fixes[k - 1].frame, t.fixes[k - 1].person) >= std::pair(fix.frame, fix.person))
      std::abort();
  }
  for (const scene::Area& area : t.walkable)
    if (area.outline.size() < 3 || !(area.size() > 0)) std::abort();
}

}  // namespace inhabit::fuzz
