#include "crowd/walls.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/lists.h"

namespace inhabit::crowd {
namespace {

/// Grids of walls have at most so many cells: a plan of kilometres has wider ones.
constexpr double kCells = 4e6;

Ring moved(const Ring& ring, Vec2 origin) {
  Ring out = ring;
  for (Vec2& p : out) p = p - origin;
  return out;
}

/// Distance between a segment and an axis-parallel square is at most `reach`: Chebyshev-conservative by its bounds and
/// its line.
bool near_cell(const WallSegment& s, double low_x, double low_y, double cell, double reach) {
  const double cx = low_x + cell / 2, cy = low_y + cell / 2, half = cell / 2 + reach;
  if (std::max(s.ax, s.bx) < cx - half || std::min(s.ax, s.bx) > cx + half) return false;
  if (std::max(s.ay, s.by) < cy - half || std::min(s.ay, s.by) > cy + half) return false;
  const double dx = s.bx - s.ax, dy = s.by - s.ay;
  const double cross = dx * (cy - s.ay) - dy * (cx - s.ax);
  return std::abs(cross) <= half * (std::abs(dx) + std::abs(dy));
}

/// The float, or 0 where `keep` is 0 instead of 1.
float or_zero(float value, std::int32_t keep) {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(value) & -keep);
}

double orient(double ax, double ay, double bx, double by, double px, double py) {
  return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

}  // namespace

Walls::Walls(const std::vector<Floor>& floors, Vec2 origin, double reach) : reach_(static_cast<float>(reach)) {
  Bounds box;
  const auto add_ring = [&](const Ring& ring, bool outline) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], b = ring[(k + 1) % ring.size()];
      const Vec2 from = outline ? a : b, to = outline ? b : a;
      segments_.push_back(
          {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x), static_cast<float>(to.y)});
      box.add(a);
    }
  };
  for (const Floor& floor : floors) {
    std::vector<Ring> holes;
    for (const Ring& hole : floor.holes) holes.push_back(moved(hole, origin));
    floors_.push_back(make_floor(moved(floor.outline, origin), std::move(holes)));
    add_ring(floors_.back().outline, true);
    for (const Ring& hole : floors_.back().holes) add_ring(hole, false);
  }
  if (segments_.empty()) return;

  const Vec2 size = box.size();
  double cell = std::max(reach, 0.25);
  while ((std::floor(size.x / cell) + 1) * (std::floor(size.y / cell) + 1) > kCells) cell *= 1.25;
  min_x_ = static_cast<float>(box.min.x), min_y_ = static_cast<float>(box.min.y);
  inverse_cell_ = static_cast<float>(1 / cell);
  columns_ = static_cast<std::int32_t>(size.x / cell) + 1, rows_ = static_cast<std::int32_t>(size.y / cell) + 1;

  // Segments are near the cells that their bounds, grown by reach, cover and whose square they come close to.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near;
  const double grown = reach + 1e-3 * cell;  // floats put a point on a cell's edge into either
  inside_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kSolid);
  for (std::uint32_t k = 0; k < segments_.size(); ++k) {
    const WallSegment& s = segments_[k];
    const auto index = [&](double at, std::int32_t count) {
      return std::clamp(static_cast<std::int32_t>(std::floor(at / cell)), 0, count - 1);
    };
    const std::int32_t c0 = index(std::min(s.ax, s.bx) - grown - min_x_, columns_);
    const std::int32_t c1 = index(std::max(s.ax, s.bx) + grown - min_x_, columns_);
    const std::int32_t r0 = index(std::min(s.ay, s.by) - grown - min_y_, rows_);
    const std::int32_t r1 = index(std::max(s.ay, s.by) + grown - min_y_, rows_);
    for (std::int32_t r = r0; r <= r1; ++r)
      for (std::int32_t c = c0; c <= c1; ++c) {
        const double low_x = min_x_ + c * cell, low_y = min_y_ + r * cell;
        const auto place = static_cast<std::uint32_t>(r * columns_ + c);
        if (near_cell(s, low_x, low_y, cell, grown)) near.emplace_back(place, k);
        if (near_cell(s, low_x, low_y, cell, 1e-3 * cell)) inside_[place] = kBorder;
      }
  }
  first_.assign(inside_.size() + 1, 0), items_.resize(near.size());
  for (const auto& [place, k] : near) ++first_[place + 1];
  for (std::size_t c = 0; c < inside_.size(); ++c) first_[c + 1] += first_[c];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [place, k] : near) items_[next[place]++] = k;

  for (std::int32_t r = 0; r < rows_; ++r)
    for (std::int32_t c = 0; c < columns_; ++c) {
      const auto place = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
      if (inside_[place] == kBorder) continue;
      const Vec2 middle{min_x_ + (c + 0.5) * cell, min_y_ + (r + 0.5) * cell};
      if (std::ranges::any_of(floors_, [&](const Floor& floor) { return contains(floor, middle); }))
        inside_[place] = first_[place] == first_[place + 1] ? kOpen : kFloor;
    }
}

std::span<const std::uint32_t> Walls::near(float x, float y) const {
  if (segments_.empty()) return {};
  const auto index = [&](float at, std::int32_t count) {
    return at > 0 ? std::min(static_cast<std::int32_t>(std::min(at * inverse_cell_, 1e9f)), count - 1) : 0;
  };
  const auto place = static_cast<std::size_t>(index(y - min_y_, rows_)) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(index(x - min_x_, columns_));
  return {items_.data() + first_[place], items_.data() + first_[place + 1]};
}

bool Walls::on_floor(float x, float y) const {
  if (segments_.empty()) return true;
  const float column = (x - min_x_) * inverse_cell_, row = (y - min_y_) * inverse_cell_;
  if (!(column >= 0 && row >= 0 && column < static_cast<float>(columns_) && row < static_cast<float>(rows_)))
    return false;
  const std::uint8_t state =
      inside_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  if (state != kBorder) return state != kSolid;
  return std::ranges::any_of(floors_, [&](const Floor& floor) { return contains(floor, Vec2{x, y}); });
}

void Walls::in_the_open(std::span<const float> x, std::span<const float> y, std::span<std::uint8_t> flags) const {
  if (segments_.empty()) {
    for (std::size_t k = 0; k < x.size(); ++k) flags[k] = x[k] - x[k] == 0 && y[k] - y[k] == 0;
    return;
  }
  // In parts, each in three loops: the first two are arithmetic without branches, which compilers turn into vectors.
  // Indices are below 2^24, so that floats hold them.
  constexpr std::size_t kPart = 256;
  std::array<std::int32_t, kPart> cell, in;
  const auto columns = static_cast<float>(columns_), rows = static_cast<float>(rows_);
  const float min_x = min_x_, min_y = min_y_, inverse = inverse_cell_;
  const std::uint8_t* const inside = inside_.data();
  for (std::size_t begin = 0; begin < x.size(); begin += kPart) {
    const std::size_t count = std::min(kPart, x.size() - begin);
    const float *px = x.data() + begin, *py = y.data() + begin;
    for (std::size_t k = 0; k < count; ++k) {
      const float c = (px[k] - min_x) * inverse, r = (py[k] - min_y) * inverse;
      in[k] = static_cast<std::int32_t>(c >= 0) & static_cast<std::int32_t>(c < columns) &
              static_cast<std::int32_t>(r >= 0) & static_cast<std::int32_t>(r < rows);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const float c = or_zero((px[k] - min_x) * inverse, in[k]), r = or_zero((py[k] - min_y) * inverse, in[k]);
      cell[k] = static_cast<std::int32_t>(static_cast<float>(static_cast<std::int32_t>(r)) * columns +
                                          static_cast<float>(static_cast<std::int32_t>(c)));
    }
    std::uint8_t* const out = flags.data() + begin;
    for (std::size_t k = 0; k < count; ++k)
      out[k] = static_cast<std::uint8_t>(in[k] & static_cast<std::int32_t>(inside[cell[k]] == kOpen));
  }
}

bool Walls::leaves(float ax, float ay, float bx, float by) const {
  for (const std::uint32_t k : near(bx, by)) {
    const WallSegment& s = segments_[k];
    // The floor is on the left. Half-open in each test, so that a way through a corner meets one of its two sides.
    if (!(orient(s.ax, s.ay, s.bx, s.by, bx, by) < 0) || orient(s.ax, s.ay, s.bx, s.by, ax, ay) < 0) continue;
    const double p = orient(ax, ay, bx, by, s.ax, s.ay), q = orient(ax, ay, bx, by, s.bx, s.by);
    if ((p > 0) != (q > 0)) return true;
  }
  return false;
}

bool Walls::sees(float ax, float ay, float bx, float by) const {
  if (segments_.empty()) return true;
  if (!on_floor(ax, ay) || !on_floor(bx, by)) return false;
  // Walk along the line from cell to cell; every cell lists the segments near it.
  const float length = std::hypot(bx - ax, by - ay);
  const int steps = static_cast<int>(std::ceil(length * inverse_cell_ * 2)) + 1;
  std::span<const std::uint32_t> before;
  for (int k = 0; k <= steps; ++k) {
    const float t = static_cast<float>(k) / static_cast<float>(steps);
    const auto list = near(ax + t * (bx - ax), ay + t * (by - ay));
    if (list.data() == before.data() && list.size() == before.size()) continue;
    before = list;
    for (const std::uint32_t i : list) {
      const WallSegment& s = segments_[i];
      const double p = orient(ax, ay, bx, by, s.ax, s.ay), q = orient(ax, ay, bx, by, s.bx, s.by);
      const double u = orient(s.ax, s.ay, s.bx, s.by, ax, ay), v = orient(s.ax, s.ay, s.bx, s.by, bx, by);
      if (((p > 0) != (q > 0)) && ((u > 0) != (v > 0))) return false;
    }
  }
  return true;
}

}  // namespace inhabit::crowd
