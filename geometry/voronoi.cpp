#include "geometry/voronoi.h"

#include <algorithm>

#include "core/core.h"
#include "geometry/convex.h"
#include "geometry/point_grid.h"

namespace inhabit::geometry {
namespace {

constexpr double kTouch = 1e-9;  // metres: what meets by less than this only touches

/// A convex cell, seen from its point. A side starts at its corner and knows which wall it lies on, -1 for none.
struct Corner {
  Vec2 p;
  std::int32_t wall = -1;
};

}  // namespace

VoronoiGround::VoronoiGround(std::vector<Area> walkable, double cut_off)
    : walkable_(std::move(walkable)), cut_off_(cut_off) {
  INHABIT_ASSERT(!walkable_.empty() || cut_off > 0);
  if (walkable_.size() > 1) walkable_ = difference(walkable_, {}, 0);  // neighbours share no wall
  const auto add_walls = [&](const Ring& ring, bool hole) {
    const bool turn = (signed_area(ring) < 0) != hole;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], b = ring[(k + 1) % ring.size()];
      walls_.push_back(turn ? Wall{b, a} : Wall{a, b});
    }
  };
  for (const Area& area : walkable_) {
    floors_.push_back(make_floor(area.outline, area.holes));
    add_walls(area.outline, false);
    for (const Ring& hole : area.holes) add_walls(hole, true);
    for (const Vec2 p : area.outline) bounds_.add(p);
  }
  if (cut_off_ > 0) {
    // A regular n-gon of circumradius R has the area n/2 R² sin(2 pi/n).
    constexpr double n = kCutOffCorners;
    const double radius = cut_off_ * std::sqrt(2 * kPi / (n * std::sin(2 * kPi / n)));
    for (int k = 0; k < kCutOffCorners; ++k) start_.push_back(radius * direction(2 * kPi * (k + 0.5) / n));
  }
}

bool VoronoiGround::on_ground(Vec2 p) const {
  if (floors_.empty()) return true;
  return std::ranges::any_of(floors_, [&](const Floor& floor) { return contains(floor, p); });
}

/// Cuts one cell after the other; keeps its buffers.
class VoronoiGround::Cutter {
 public:
  Cutter(const VoronoiGround& ground, std::span<const Vec2> points, double spacing)
      : ground_(ground), points_(points), grid_(points, spacing) {}

  const PointGrid& grid() const { return grid_; }

  Area cell(std::size_t i) {
    const Vec2 p = points_[i];
    begin(p);
    cut_by_points(i);
    convex_ = corners_;
    if (!cut_by_walls(p)) return cut_by_geos(p);
    Area area;
    for (const Corner& c : corners_) area.outline.push_back(p + c.p);
    return area;
  }

 private:
  void begin(Vec2 p) {
    corners_.clear();
    if (!ground_.start_.empty()) {
      for (const Vec2 c : ground_.start_) corners_.push_back({c});
    } else {
      // A metre beyond the ground, so that the frame never lies on a wall.
      const Vec2 low = ground_.bounds_.min - Vec2{1, 1} - p, high = ground_.bounds_.max + Vec2{1, 1} - p;
      corners_ = {{low}, {{high.x, low.y}}, {high}, {{low.x, high.y}}};
    }
    measure();
  }

  void measure() {
    reach2_ = 0;
    for (const Corner& c : corners_) reach2_ = std::max(reach2_, dot(c.p, c.p));
  }

  /// Keeps what fulfils n·x <= c. The new side lies on `wall`.
  void cut(Vec2 n, double c, std::int32_t wall) {
    bool any = false;
    for (const Corner& corner : corners_) any = any || dot(n, corner.p) > c;
    if (!any) return;
    next_.clear();
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Corner& a = corners_[k];
      const Corner& b = corners_[k + 1 == corners_.size() ? 0 : k + 1];
      const double da = dot(n, a.p) - c, db = dot(n, b.p) - c;
      if (da < 0 || (da == 0 && db <= 0)) next_.push_back(a);
      if (da == 0 && db > 0) next_.push_back({a.p, wall});
      if (da < 0 && db > 0) next_.push_back({a.p + (da / (da - db)) * (b.p - a.p), wall});
      if (da > 0 && db < 0) next_.push_back({a.p + (da / (da - db)) * (b.p - a.p), a.wall});
    }
    corners_.swap(next_);
    measure();
  }

  void cut_by_points(std::size_t i) {
    const Vec2 p = points_[i];
    const auto one = [&](std::size_t j) {
      if (j == i) return;
      const Vec2 d = points_[j] - p;
      const double dd = dot(d, d);
      if (dd > 0 && dd < 4 * reach2_) cut(d, dd / 2, -1);
    };
    for (std::int32_t k = 0;; ++k) {
      // Everybody nearer than (k - 1) cells has been seen; who is twice as far as the farthest corner cuts nothing.
      const double seen = (k - 1) * grid_.cell();
      if (k > 0 && seen * seen >= 4 * reach2_) break;
      if (!grid_.for_each_in_ring(p, k, one)) break;
    }
  }

  /// True when more than a touch of the segment from a to b lies inside the cell.
  bool meets(Vec2 a, Vec2 b) const {
    const Vec2 d = b - a;
    double from = 0, to = 1;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Vec2 p = corners_[k].p, e = corners_[k + 1 == corners_.size() ? 0 : k + 1].p - p;
      const double l = length(e);
      if (l < kTouch) continue;
      const Vec2 out{e.y / l, -e.x / l};
      const double depth = dot(out, p - a) - kTouch, speed = dot(out, d);  // inside where t * speed < depth
      if (speed > 0)
        to = std::min(to, depth / speed);
      else if (speed < 0)
        from = std::max(from, depth / speed);
      else if (depth <= 0)
        return false;
    }
    return from < to;
  }

  /// Cuts off what lies behind the walls that the cell meets, nearest first. False when that is not the whole truth: at
  /// reflex corners, and where walls turn their back. Why it is exact otherwise: the remainder is convex, no wall
  /// passes through it, so it lies on the ground; and each of its sides lies on the cell's border or within a wall, so
  /// that nothing connected to it is missing.
  bool cut_by_walls(Vec2 p) {
    near_.clear();
    for (std::size_t k = 0; k < ground_.walls_.size(); ++k) {
      const Wall& wall = ground_.walls_[k];
      const Vec2 nearest = nearest_on_segment(wall.a - p, wall.b - p, {});
      const double d2 = dot(nearest, nearest);
      if (d2 < reach2_) near_.emplace_back(d2, static_cast<std::int32_t>(k));
    }
    std::sort(near_.begin(), near_.end());
    for (const auto& [d2, k] : near_) {
      if (d2 >= reach2_) break;
      const Vec2 a = ground_.walls_[k].a - p, b = ground_.walls_[k].b - p;
      if (!meets(a, b)) continue;
      const Vec2 d = b - a, out{d.y, -d.x};
      if (dot(out, a) <= 0) return false;
      cut(out, dot(out, a), k);
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i].wall < 0) continue;
      const Vec2 a = ground_.walls_[corners_[i].wall].a - p, d = ground_.walls_[corners_[i].wall].b - p - a;
      for (const std::size_t end : {i, (i + 1) % corners_.size()}) {
        const double along = dot(corners_[end].p - a, d) / length(d);
        if (along < -kTouch || along > length(d) + kTouch) return false;
      }
    }
    return corners_.size() >= 3;
  }

  /// The same by GEOS, for any ground.
  Area cut_by_geos(Vec2 p) const {
    Ring ring;
    for (const Corner& c : convex_) ring.push_back(p + c.p);
    std::vector<Area> pieces = intersection(ground_.walkable_, ring, 0);
    if (pieces.empty()) return {};
    const auto gap = [&](const Area& piece) { return outside_distance(make_floor(piece.outline, piece.holes), p); };
    return *std::ranges::min_element(pieces, {}, gap);
  }

  const VoronoiGround& ground_;
  std::span<const Vec2> points_;
  PointGrid grid_;
  std::vector<Corner> corners_, next_;
  std::vector<Corner> convex_;  ///< before the walls
  std::vector<std::pair<double, std::int32_t>> near_;
  double reach2_ = 0;
};

namespace {

double gap(const Bounds& b, Vec2 p) {
  return length({std::max({b.min.x - p.x, 0.0, p.x - b.max.x}), std::max({b.min.y - p.y, 0.0, p.y - b.max.y})});
}

/// No place in `where` is farther than this from the nearest point: looked up at the middles of 8 × 8 tiles. Requires:
/// at least one point.
double farthest_from_points(std::span<const Vec2> points, const PointGrid& grid, const Bounds& where) {
  constexpr int n = 8;
  const Vec2 tile = (1.0 / n) * where.size();
  double farthest = 0;
  for (int i = 0; i < n * n; ++i) {
    const Vec2 p = where.min + Vec2{(i % n + 0.5) * tile.x, (i / n + 0.5) * tile.y};
    double nearest = 1e300;
    for (std::int32_t k = 0; k == 0 || (k - 1) * grid.cell() < nearest; ++k)
      if (!grid.for_each_in_ring(p, k, [&](std::size_t j) { nearest = std::min(nearest, length(points[j] - p)); }) &&
          nearest < 1e300)
        break;
    farthest = std::max(farthest, nearest);
  }
  return farthest + length(tile) / 2;
}

}  // namespace

std::vector<Area> VoronoiGround::cells(std::span<const Vec2> points) const { return cells(points, nullptr); }

std::vector<Area> VoronoiGround::cells_meeting(std::span<const Vec2> points, const Bounds& where) const {
  return cells(points, &where);
}

std::vector<Area> VoronoiGround::cells(std::span<const Vec2> points, const Bounds* where) const {
  std::vector<Area> cells(points.size());
  std::vector<std::size_t> standing;
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!on_ground(points[i])) continue;
    standing.push_back(i);
    places.push_back(points[i]);
  }
  if (places.empty()) return cells;
  // About one point in each cell of the grid.
  const Vec2 size = bounds(places).size();
  const double spacing = std::sqrt(std::max(size.x * size.y, 1e-6) / static_cast<double>(places.size()));
  Cutter cutter(*this, places, std::max(spacing, 0.05));
  const double reach = where != nullptr ? farthest_from_points(places, cutter.grid(), *where) + kTouch : 0;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (where == nullptr || gap(*where, places[k]) <= reach) cells[standing[k]] = cutter.cell(k);
  return cells;
}

}  // namespace inhabit::geometry
