#pragma once
#include <vector>

#include "crowd/agents.h"
#include "scene/crowd.h"

/// Goals as the planners see them: relative to the world's origin, with what is asked at every step at hand.
namespace inhabit::crowd {

/// Where people can be. Axis-parallel rectangles, which most are, are told by their bounds alone.
struct Region {
  Ring ring;
  float min_x = 0, min_y = 0, max_x = -1, max_y = -1;
  bool is_box = false;

  Region() = default;
  /// `ring` moved by -origin; empty for fewer than three corners.
  Region(const Ring& ring, Vec2 origin);
  bool empty() const { return ring.empty(); }

  /// True inside and on the border.
  bool contains(float x, float y) const {
    if (!(x >= min_x && x <= max_x && y >= min_y && y <= max_y)) return false;
    return is_box || geometry::contains(ring, Vec2{x, y});
  }
  /// From (x, y) to the nearest point of the region; nothing inside. Requires: not empty.
  struct Way {
    float x = 0, y = 0;
  };
  Way way_from(float x, float y) const {
    if (is_box) return {std::clamp(x, min_x, max_x) - x, std::clamp(y, min_y, max_y) - y};
    return way_to_ring(x, y);
  }

 private:
  Way way_to_ring(float x, float y) const;
};

struct Place {
  enum class Kind { nowhere, area, direction, offset } kind = Kind::nowhere;
  Region area, aim;                ///< of areas; `aim` is never empty
  float x = 0, y = 0, jitter = 0;  ///< a direction's unit vector, or an offset in metres

  Place() = default;
  Place(const scene::Goal& goal, Vec2 origin);

  /// The nearest point of what people head for while they are not in the area: the aim; of the area once they are on
  /// the aim; nothing inside the area. Requires: an area.
  Region::Way way_from(float px, float py) const {
    const Region::Way way = aim.way_from(px, py);
    return way.x != 0 || way.y != 0 ? way : area.way_from(px, py);
  }
};

/// Offset and jitter of an agent's own goal: the same whenever it is asked.
Region::Way own_offset(const Place& place, std::uint64_t seed, std::uint32_t id, std::size_t goal);

}  // namespace inhabit::crowd
