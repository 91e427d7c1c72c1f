#include "crowd/spots.h"

#include <algorithm>
#include <cmath>

namespace inhabit::crowd {
namespace {

/// A grid has at most so many cells; in wider ones there are more discs to look at, no other.
constexpr double kCells = 1e6;

}  // namespace

bool clear_of_walls(const Walls& walls, float x, float y, float radius) {
  if (walls.in_the_open(x, y)) return true;
  if (!walls.on_floor(x, y)) return false;
  const float least = radius * (1 - kTouch);
  bool clear = true;
  walls.for_each_near(x, y, [&](const WallSegment& s, std::uint32_t) {
    const WallPoint p = nearest_point(s, x, y);
    const float dx = x - p.x, dy = y - p.y;
    clear = clear && dx * dx + dy * dy >= least * least;
  });
  return clear;
}

Spots::Spots(const World& world, double widest) : walls_(&world.walls), widest_(static_cast<float>(widest)) {
  Bounds box;
  for (const Floor& floor : world.floors) box.add(floor.outline_bounds.min), box.add(floor.outline_bounds.max);
  if (world.floors.empty()) box = {{0, 0}, {0, 0}};
  const Vec2 size = box.size();
  double cell = std::max(2 * widest, 0.1);
  while ((std::floor(size.x / cell) + 1) * (std::floor(size.y / cell) + 1) > kCells) cell *= 1.25;
  min_x_ = static_cast<float>(box.min.x - world.origin.x), min_y_ = static_cast<float>(box.min.y - world.origin.y);
  inverse_cell_ = static_cast<float>(1 / cell);
  columns_ = static_cast<std::int32_t>(size.x / cell) + 1, rows_ = static_cast<std::int32_t>(size.y / cell) + 1;
  heads_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
}

std::int32_t Spots::index(float at, std::int32_t count) {
  return at > 0 ? std::min(static_cast<std::int32_t>(std::min(at, 1e9f)), count - 1) : 0;
}

std::int32_t& Spots::head(float x, float y) {
  return heads_[static_cast<std::size_t>(row(y)) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(column(x))];
}

bool Spots::free(float x, float y, float radius) const {
  const float reach = radius + widest_;
  const std::int32_t c0 = column(x - reach), c1 = column(x + reach), r0 = row(y - reach), r1 = row(y + reach);
  for (std::int32_t r = r0; r <= r1; ++r)
    for (std::int32_t c = c0; c <= c1; ++c) {
      const std::size_t cell =
          static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
      for (std::int32_t k = heads_[cell]; k >= 0; k = discs_[static_cast<std::size_t>(k)].next) {
        const Disc& disc = discs_[static_cast<std::size_t>(k)];
        if (!apart(disc.x - x, disc.y - y, disc.radius + radius)) return false;
      }
    }
  return clear_of_walls(*walls_, x, y, radius);
}

void Spots::add(float x, float y, float radius) {
  std::int32_t& first = head(x, y);
  discs_.push_back({x, y, radius, first});
  first = static_cast<std::int32_t>(discs_.size()) - 1;
}

void Spots::shrink(std::size_t size) {
  while (discs_.size() > size) {
    const Disc& last = discs_.back();
    head(last.x, last.y) = last.next;  // lists are stacks: the last one added is at the head
    discs_.pop_back();
  }
}

std::optional<Vec2> Spots::nearest_free(float x, float y, float radius, double farthest, std::size_t& budget) const {
  const double step = radius / 2.0;
  const bool sighted = walls_->on_floor(x, y);
  std::optional<Vec2> best;
  double nearest = farthest;
  const auto try_at = [&](int i, int j) {
    const double dx = i * step, dy = j * step, distance = std::sqrt(dx * dx + dy * dy);
    if (!(distance < nearest) || budget == 0) return;
    --budget;
    const auto px = static_cast<float>(x + dx), py = static_cast<float>(y + dy);
    if (!free(px, py, radius) || (sighted && !walls_->sees(x, y, px, py))) return;
    nearest = distance, best = Vec2{px, py};
  };
  // Squares round (x, y), from the inside out; none that is farther than the best found holds a better one.
  for (int k = 0; k * step < nearest && budget > 0; ++k) {
    if (k == 0) try_at(0, 0);
    for (int j = -k; j <= k && k > 0; ++j) {
      const int stride = j == -k || j == k ? 1 : 2 * k;
      for (int i = -k; i <= k; i += stride) try_at(i, j);
    }
  }
  return best;
}

}  // namespace inhabit::crowd
