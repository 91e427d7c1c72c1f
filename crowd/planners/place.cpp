#include "crowd/planners/place.h"

#include "core/rng.h"

namespace inhabit::crowd {

Region::Region(const Ring& corners, Vec2 origin) {
  if (corners.size() < 3) return;
  ring = corners;
  for (Vec2& p : ring) p -= origin;
  const Bounds box = bounds(ring);
  min_x = static_cast<float>(box.min.x), min_y = static_cast<float>(box.min.y);
  max_x = static_cast<float>(box.max.x), max_y = static_cast<float>(box.max.y);
  is_box = ring.size() == 4;
  for (std::size_t k = 0; k < 4 && is_box; ++k) {
    const Vec2 a = ring[k], b = ring[(k + 1) % 4], c = ring[(k + 2) % 4];
    is_box = (a.x == b.x && b.y == c.y) || (a.y == b.y && b.x == c.x);
  }
}

Region::Way Region::way_to_ring(float x, float y) const {
  const Vec2 p{x, y};
  if (geometry::contains(ring, p)) return {};
  const Vec2 q = nearest_on_ring(ring, p).point - p;
  return {static_cast<float>(q.x), static_cast<float>(q.y)};
}

Place::Place(const scene::Goal& goal, Vec2 origin) {
  if (goal.direction) {
    const Vec2 d = geometry::direction(*goal.direction);
    kind = Kind::direction, x = static_cast<float>(d.x), y = static_cast<float>(d.y);
  } else if (goal.offset) {
    kind = Kind::offset, x = static_cast<float>(goal.offset->x), y = static_cast<float>(goal.offset->y);
    jitter = static_cast<float>(goal.jitter);
  } else if (goal.area.size() >= 3) {
    kind = Kind::area, area = Region(goal.area, origin);
    aim = goal.aim.size() >= 3 ? Region(goal.aim, origin) : area;
  }
}

Region::Way own_offset(const Place& place, std::uint64_t seed, std::uint32_t id, std::size_t goal) {
  if (place.jitter == 0) return {place.x, place.y};
  Rng rng(mix64(seed ^ 0x6f66667365740000ULL) + goal, id);
  const double dx = rng.uniform(-1, 1), dy = rng.uniform(-1, 1);
  return {place.x + static_cast<float>(dx) * place.jitter, place.y + static_cast<float>(dy) * place.jitter};
}

}  // namespace inhabit::crowd
