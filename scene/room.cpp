#include "scene/room.h"

#include <algorithm>
#include <initializer_list>

namespace inhabit::scene {
namespace {

std::vector<Ring> hole_outlines(const Space& space) {
  std::vector<Ring> rings;
  for (const Hole& h : space.holes) rings.push_back(h.outline);
  return rings;
}

}  // namespace

Room::Room(const Space& space) : Room(space.outline, hole_outlines(space)) {}

Room::Room(const Ring& outline, const std::vector<Ring>& holes)
    : outline_(counter_clockwise(outline)), hole_rings_(holes), convex_(is_convex(outline_)) {
  const std::size_t n = outline_.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 before = outline_[(k + n - 1) % n], a = outline_[k], b = outline_[(k + 1) % n];
    const Vec2 along = unit(b - a);
    walls_.push_back({a, b, along, perp(along), length(b - a), angle_of(perp(along)), cross(a - before, b - a) < 0});
  }
  for (const Ring& hole : holes) {
    for (Ring& part : convex_parts(hole)) {
      const Vec2 c = bounds(part).center();
      double r = 0;
      for (const Vec2 p : part) r = std::max(r, length(p - c));
      hole_center_.push_back(c), hole_radius_.push_back(r);
      holes_.push_back(std::move(part));
    }
  }
  area_ = signed_area(outline_);
  center_ = centroid(outline_);
  bounds_ = bounds(outline_);
  // The centroid of the free area (TVCG eq. 12 wants the room's, not its corners').
  Vec2 moment = area_ * center_;
  for (const Ring& hole : holes) {
    const double a = std::abs(signed_area(hole));
    moment -= a * centroid(hole);
    area_ -= a;
  }
  if (area_ > 0) center_ = (1 / area_) * moment;
}

bool Room::contains(Vec2 p) const {
  if (convex_) {
    for (const Wall& w : walls_) {
      if (dot(p - w.a, w.normal) < 0) return false;
    }
  } else if (!geometry::contains(outline_, p)) {
    return false;
  }
  return std::ranges::none_of(hole_rings_, [p](const Ring& h) { return geometry::contains(h, p); });
}

WallPoint Room::nearest_wall(Vec2 p, std::optional<int> only) const {
  if (convex_ && !only) {
    // Inside a convex room the nearest of the walls' lines is met on its wall.
    std::uint32_t nearest = 0;
    double least = 1e300;
    for (std::uint32_t k = 0; k < walls_.size(); ++k) {
      const double off = dot(p - walls_[k].a, walls_[k].normal);
      if (off < least) least = off, nearest = k;
    }
    const Wall& w = walls_[nearest];
    if (least >= 0) return {w.a + std::clamp(dot(p - w.a, w.along), 0.0, w.length) * w.along, least, nearest};
  }
  WallPoint best{{}, 1e300, 0};
  double best_square = 1e300;
  const std::size_t first = only ? static_cast<std::size_t>(*only) % walls_.size() : 0;
  const std::size_t last = only ? first + 1 : walls_.size();
  for (std::size_t k = first; k < last; ++k) {
    const Wall& w = walls_[k];
    const double t = std::clamp(dot(p - w.a, w.along), 0.0, w.length);
    const Vec2 q = w.a + t * w.along;
    const double square = dot(p - q, p - q);
    if (square < best_square) {
      best_square = square;
      best = {q, 0, static_cast<std::uint32_t>(k)};
    }
  }
  const double d = std::sqrt(best_square);
  best.distance = dot(p - best.point, walls_[best.wall].normal) < 0 ? -d : d;
  return best;
}

Separation Room::wall_push(const Box& box, std::size_t k) const {
  const Wall& wall = walls_[k];
  // The part of the wall inside the box, by clipping it against the box's two slabs.
  const Vec2 d = rotate_back(wall.b - wall.a, box.front), p = rotate_back(wall.a - box.center, box.front);
  double t0 = 0, t1 = 1;
  for (const auto& [pos, dir, half] : {std::tuple{p.x, d.x, box.half_depth}, std::tuple{p.y, d.y, box.half_width}}) {
    if (std::abs(dir) < 1e-15) {
      if (std::abs(pos) >= half) return {};
      continue;
    }
    const double u = (-half - pos) / dir, v = (half - pos) / dir;
    t0 = std::max(t0, std::min(u, v)), t1 = std::min(t1, std::max(u, v));
  }
  if (t0 >= t1) return {};
  Separation best{wall.normal, box.extent(wall.normal) - dot(box.center - wall.a, wall.normal)};
  // A reflex corner inside the box: the shortest way off the wedge behind it, which its other wall or a face of the box
  // may show. A face does only when the whole wedge lies before it, or a wall would still cross the box.
  const auto corner = [&](const Wall& other, Vec2 at, Vec2 d1, Vec2 d2) {
    const Vec2 c = at - box.center;
    const double past = box.extent(other.normal) + dot(c, other.normal);
    if (past < best.depth) best = {other.normal, past};
    for (const Vec2 face : {box.front, box.left(), -box.front, -box.left()}) {
      if (dot(d1, face) < -1e-12 || dot(d2, face) < -1e-12) continue;
      const double depth = box.extent(face) - dot(c, face);
      if (depth > 0 && depth < best.depth) best = {-face, depth};
    }
  };
  const Wall &before = walls_[(k + walls_.size() - 1) % walls_.size()], &after = walls_[(k + 1) % walls_.size()];
  if (wall.reflex && t0 == 0) corner(before, wall.a, wall.along, -before.along);
  if (after.reflex && t1 == 1) corner(after, wall.b, -wall.along, after.along);
  return best;
}

std::optional<DoorFrame> frame(const Space& space, const Door& door) {
  if (door.wall < 0 || static_cast<std::size_t>(door.wall) >= space.walls()) return std::nullopt;
  const auto wall = static_cast<std::size_t>(door.wall);
  const Vec2 along = unit(space.wall_end(wall) - space.wall_start(wall));
  return DoorFrame{space.wall_start(wall) + door.from * along, along, perp(along)};
}

}  // namespace inhabit::scene
