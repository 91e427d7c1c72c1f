#include "crowd/planners/corners.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace inhabit::crowd {
namespace {

/// Touching is not crossing: metres, and radians on circles of about a metre.
constexpr double kTouch = 1e-7;
/// Circles on both sides of a gap take so much of it each. Half would leave a line of no width, which no tangent of
/// circles that differ in the last digit finds.
constexpr double kShare = 0.48;
/// The grid of walls has at most so many cells.
constexpr double kCells = 1e6;

constexpr Vec2 clockwise(Vec2 v) { return {v.y, -v.x}; }

bool crosses(Vec2 a, Vec2 b, Vec2 p, Vec2 q) {
  const double u = cross(b - a, p - a), v = cross(b - a, q - a);
  if ((u > 0) == (v > 0) || u == 0 || v == 0) return false;
  const double s = cross(q - p, a - p), t = cross(q - p, b - p);
  return (s > 0) != (t > 0) && s != 0 && t != 0;
}

/// The line that has c0 at its left by r0 and c1 by r1 (negative: at its right), where it touches both circles.
struct Line {
  Vec2 direction, from, to;
  double length = 0;
};
std::optional<Line> touching(Vec2 c0, double r0, Vec2 c1, double r1) {
  const Vec2 d = c1 - c0;
  const double dd = dot(d, d), k = r1 - r0;
  if (dd < k * k || dd == 0) return std::nullopt;
  const double along = std::sqrt(dd - k * k);
  // cross(direction, d) = k and dot(direction, d) = along.
  const Vec2 direction = (1 / dd) * Vec2{along * d.x + k * d.y, along * d.y - k * d.x};
  return Line{direction, c0 - r0 * perp(direction), c1 - r1 * perp(direction), along};
}

}  // namespace

Corners::Corners(const World& world, double body, double clearance, int threads) : body_(body) {
  find_corners(world);
  if (walls_.empty()) return;
  for (Corner& c : corners_) c.radius = clearance;
  build_grid();
  fit_radii(body, clearance);
  std::vector<std::vector<Tangent>> found(corners_.size());
  parallel_for(corners_.size(), threads,
               [&](std::size_t k) { found[k] = tangents_from(static_cast<std::uint32_t>(k)); });
  for (const auto& some : found) tangents_.insert(tangents_.end(), some.begin(), some.end());
  first_into_.assign(nodes() + 1, 0), into_.resize(tangents_.size());
  for (const Tangent& t : tangents_) ++first_into_[t.to + 1];
  for (std::size_t n = 0; n < nodes(); ++n) first_into_[n + 1] += first_into_[n];
  std::vector<std::uint32_t> next(first_into_.begin(), first_into_.end() - 1);
  for (std::uint32_t k = 0; k < tangents_.size(); ++k) into_[next[tangents_[k].to]++] = k;
}

void Corners::find_corners(const World& world) {
  const auto add = [&](const Ring& ring, bool floor_is_left) {
    const std::size_t n = ring.size();
    const std::size_t base = walls_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 a = ring[k] - world.origin, b = ring[(k + 1) % n] - world.origin;
      walls_.push_back(floor_is_left ? Wall{a, b} : Wall{b, a});
    }
    for (std::size_t k = 0; k < n; ++k) {
      // Side k starts at corner k: reversed, it ends there.
      const std::size_t before = base + (k + n - 1) % n, after = base + k;
      const Wall& ending = walls_[floor_is_left ? before : after];
      const Wall& beginning = walls_[floor_is_left ? after : before];
      const Vec2 u = unit(ending.b - ending.a), v = unit(beginning.b - beginning.a);
      const double fan = direction_angle(dot(u, v), -cross(u, v));
      if (fan < 1e-6) continue;
      corners_.push_back({ending.b, perp(u), rotate_back(perp(u), direction(fan / 2)), fan});
      walls_of_.emplace_back(floor_is_left ? before : after, floor_is_left ? after : before);
    }
  };
  for (const Floor& floor : world.floors) {
    Floor own = make_floor(floor.outline, floor.holes);
    add(own.outline, signed_area(own.outline) > 0);
    for (const Ring& hole : own.holes) add(hole, signed_area(hole) < 0);
    for (Vec2& p : own.outline) p -= world.origin;
    for (Ring& hole : own.holes)
      for (Vec2& p : hole) p -= world.origin;
    floors_.push_back(make_floor(std::move(own.outline), std::move(own.holes)));
  }
}

void Corners::build_grid() {
  Bounds box;
  for (const Wall& w : walls_) box.add(w.a);
  const Vec2 size = box.size();
  cell_ = std::max(1.0, std::sqrt(size.x * size.y / kCells));
  low_ = box.min;
  columns_ = static_cast<std::int32_t>(size.x / cell_) + 1, rows_ = static_cast<std::int32_t>(size.y / cell_) + 1;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto index = [&](double at, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(at / cell_), 0.0, count - 1.0));
  };
  for (std::uint32_t k = 0; k < walls_.size(); ++k)
    any_cell(walls_[k].a, walls_[k].b, [&](std::size_t place) {
      pairs.emplace_back(static_cast<std::uint32_t>(place), k);
      return false;
    });
  for (std::uint32_t k = 0; k < corners_.size(); ++k) {
    const Vec2 p = corners_[k].at - low_;
    const double r = corners_[k].radius;
    for (std::int32_t row = index(p.y - r, rows_); row <= index(p.y + r, rows_); ++row)
      for (std::int32_t column = index(p.x - r, columns_); column <= index(p.x + r, columns_); ++column)
        pairs.emplace_back(static_cast<std::uint32_t>(row * columns_ + column),
                           static_cast<std::uint32_t>(walls_.size()) + k);
  }
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  items_.resize(pairs.size());
  for (const auto& [place, k] : pairs) ++first_[place + 1];
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [place, k] : pairs) items_[next[place]++] = k;
}

/// Calls f(cell) for the cells that the segment ab meets, until it returns true; says whether it did.
template <class F>
bool Corners::any_cell(Vec2 a, Vec2 b, F&& f) const {
  const auto index = [&](double at, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(at / cell_), 0.0, count - 1.0));
  };
  Vec2 p = a - low_, q = b - low_;
  if (p.y > q.y) std::swap(p, q);
  const std::int32_t r0 = index(p.y - kTouch, rows_), r1 = index(q.y + kTouch, rows_);
  const bool level = q.y - p.y < 2 * kTouch;
  const double slope = level ? 0 : (q.x - p.x) / (q.y - p.y);
  for (std::int32_t row = r0; row <= r1; ++row) {
    // The piece of the segment within the row.
    double x0 = p.x, x1 = q.x;
    if (row > r0 && !level) x0 = p.x + slope * (row * cell_ - p.y);
    if (row < r1 && !level) x1 = p.x + slope * ((row + 1) * cell_ - p.y);
    const std::int32_t c1 = index(std::max(x0, x1) + kTouch, columns_);
    for (std::int32_t column = index(std::min(x0, x1) - kTouch, columns_); column <= c1; ++column)
      if (f(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)))
        return true;
  }
  return false;
}

bool Corners::clear(Vec2 a, Vec2 b, std::uint32_t from, std::uint32_t to, Leaving leaving) const {
  const Vec2 d = b - a;
  const double dd = dot(d, d);
  return !any_cell(a, b, [&](std::size_t place) {
    for (std::uint32_t i = first_[place]; i < first_[place + 1]; ++i) {
      const std::uint32_t k = items_[i];
      if (k < walls_.size()) {
        if (crosses(a, b, walls_[k].a, walls_[k].b)) return true;
        continue;
      }
      if (leaving == Leaving::no_circles) continue;
      const auto corner = static_cast<std::uint32_t>(k - walls_.size());
      if ((from != kNone && corner == corner_of(from)) || (to != kNone && corner == corner_of(to))) continue;
      const Vec2 c = corners_[corner].at - a;
      const double t = dd > 0 ? std::clamp(dot(c, d) / dd, 0.0, 1.0) : 0;
      const double r = corners_[corner].radius - kTouch;
      const Vec2 gap = c - t * d;
      if (!(dot(gap, gap) < r * r)) continue;
      if (leaving == Leaving::outwards ? t > 0 : dot(c, c) >= r * r) return true;
    }
    return false;
  });
}

double Corners::turn_of(std::uint32_t node, Vec2 n) const {
  const Corner& c = corners_[corner_of(node)];
  // Measured from the middle of the fan, so that the jump lies behind the corner.
  return c.fan / 2 - sense_of(node) * direction_angle(dot(c.middle, n), -cross(c.middle, n));
}

Touch Corners::arrive(std::uint32_t node, Vec2 p) const {
  const Corner& c = corners_[corner_of(node)];
  const double s = sense_of(node);
  if (const auto line = touching(p, 0, c.at, s * c.radius))
    return {line->to, line->direction, turn_of(node, -s * perp(line->direction)), line->length};
  const Vec2 n = p == c.at ? c.middle : unit(p - c.at);
  const double depth = c.radius - length(p - c.at);
  return {c.at + c.radius * n, unit(s * perp(n) + (2 * depth / c.radius) * n), turn_of(node, n), depth};
}

std::optional<Touch> Corners::leave(std::uint32_t node, Vec2 q) const {
  const Corner& c = corners_[corner_of(node)];
  const double s = sense_of(node);
  const auto line = touching(c.at, s * c.radius, q, 0);
  if (!line) return std::nullopt;
  return Touch{line->from, line->direction, turn_of(node, -s * perp(line->direction)), line->length};
}

bool Corners::arc_clear(std::uint32_t node, double from, double to) const {
  const Corner& c = corners_[corner_of(node)];
  if (c.blocked == 0) return true;
  const auto part = [&](double turn) { return static_cast<int>(std::clamp(turn / c.fan * 64, 0.0, 63.0)); };
  int a = part(from), b = part(to);
  if (node % 2 != 0) a = 63 - a, b = 63 - b;
  if (a > b) std::swap(a, b);
  for (int k = a; k <= b; ++k)
    if ((c.blocked >> k & 1) != 0) return false;
  return true;
}

std::vector<Tangent> Corners::tangents_from(std::uint32_t k) const {
  std::vector<Tangent> found;
  const Corner& a = corners_[k];
  const auto in_fan = [&](double turn, const Corner& c) { return turn > -kBesideFan && turn < c.fan + kBesideFan; };
  for (std::uint32_t other = 0; other < corners_.size(); ++other) {
    if (other == k) continue;
    const Corner& b = corners_[other];
    for (std::uint32_t senses = 0; senses < 4; ++senses) {
      const std::uint32_t from = 2 * k + senses % 2, to = 2 * other + senses / 2;
      const double s = sense_of(from), e = sense_of(to);
      const auto line = touching(a.at, s * a.radius, b.at, e * b.radius);
      if (!line) continue;
      const double leaves = turn_of(from, -s * perp(line->direction));
      if (!in_fan(leaves, a) || !arc_clear(from, leaves, leaves)) continue;
      const double arrives = turn_of(to, -e * perp(line->direction));
      if (!in_fan(arrives, b) || !arc_clear(to, arrives, arrives)) continue;
      if (!clear(line->from, line->to, from, to)) continue;
      found.push_back({from, to, leaves, arrives, line->length});
    }
  }
  return found;
}

/// Radii shrink where a corner is nearer to another wall, or to another corner's circle, than both want to be.
void Corners::fit_radii(double body, double clearance) {
  const auto for_each_near = [&](Vec2 p, double reach, auto&& f) {
    const auto index = [&](double at, std::int32_t count) {
      return static_cast<std::int32_t>(std::clamp(std::floor(at / cell_), 0.0, count - 1.0));
    };
    const Vec2 q = p - low_;
    for (std::int32_t row = index(q.y - reach, rows_); row <= index(q.y + reach, rows_); ++row)
      for (std::int32_t column = index(q.x - reach, columns_); column <= index(q.x + reach, columns_); ++column) {
        const std::size_t place =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        for (std::uint32_t i = first_[place]; i < first_[place + 1]; ++i) f(items_[i]);
      }
  };
  // The gap is looked for where the arc lies, and a little beside: what stands along a wall of the corner is not
  // opposite to it.
  constexpr double kBeside = kPi / 4;
  for (std::uint32_t k = 0; k < corners_.size(); ++k) {
    Corner& c = corners_[k];
    double gap = clearance / kShare;
    const auto consider = [&](Vec2 q) {
      const double turn = turn_of(2 * k, unit(q - c.at));
      if (turn > -kBeside - kTouch && turn < c.fan + kBeside + kTouch) gap = std::min(gap, length(q - c.at));
    };
    const Vec2 first_ray = rotate(c.normal, direction(kBeside));
    const Vec2 last_ray = rotate_back(c.normal, direction(c.fan + kBeside));
    for_each_near(c.at, gap, [&](std::uint32_t item) {
      if (item >= walls_.size() || item == walls_of_[k].first || item == walls_of_[k].second) return;
      const Wall& w = walls_[item];
      const Vec2 nearest = nearest_on_segment(w.a, w.b, c.at);
      if (nearest != c.at) consider(nearest);
      for (const Vec2 ray : {first_ray, last_ray}) {
        const double slope = cross(ray, w.b - w.a);
        if (slope == 0) continue;
        const double along = cross(w.a - c.at, w.b - w.a) / slope, t = cross(w.a - c.at, ray) / slope;
        if (along > kTouch && t >= 0 && t <= 1) consider(c.at + along * ray);
      }
    });
    c.radius = gap < clearance / kShare ? std::max(body, kShare * gap) : clearance;
  }
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    for_each_near(corners_[i].at, 2 * clearance, [&](std::uint32_t item) {
      if (item < walls_.size() + i + 1) return;
      const auto j = static_cast<std::uint32_t>(item - walls_.size());
      Corner& a = corners_[i];
      Corner& b = corners_[j];
      const double d = length(b.at - a.at);
      if (a.radius + b.radius <= 2 * kShare * d) return;
      const bool joined = walls_of_[i].first == walls_of_[j].second || walls_of_[i].second == walls_of_[j].first;
      if (joined || !on_floor(0.5 * (a.at + b.at)) || !clear(a.at, b.at, kNone, kNone, Leaving::no_circles)) return;
      const double least = std::min({a.radius, b.radius, kShare * d});
      a.radius = std::max(body, std::min(a.radius, 2 * kShare * d - least));
      b.radius = std::max(body, std::min(b.radius, 2 * kShare * d - least));
    });
  }
  for (Corner& c : corners_) {
    for (int part = 0; part < 64; ++part) {
      const Vec2 p = c.at + c.radius * rotate_back(c.normal, direction(c.fan * (part + 0.5) / 64));
      bool tight = false;
      for_each_near(p, body, [&](std::uint32_t item) {
        if (item >= walls_.size()) return;
        const Wall& w = walls_[item];
        if (length(p - nearest_on_segment(w.a, w.b, p)) < body * (1 - 1e-4)) tight = true;
      });
      if (tight) c.blocked |= std::uint64_t{1} << part;
    }
  }
}

bool Corners::in_circle(Vec2 p) const {
  return any_cell(p, p, [&](std::size_t place) {
    for (std::uint32_t i = first_[place]; i < first_[place + 1]; ++i) {
      if (items_[i] < walls_.size()) continue;
      const Corner& c = corners_[items_[i] - walls_.size()];
      if (length(p - c.at) < c.radius - kTouch) return true;
    }
    return false;
  });
}

bool Corners::on_floor(Vec2 p) const {
  return std::ranges::any_of(floors_, [&](const Floor& floor) { return contains(floor, p); });
}

Vec2 Corners::nearest_wall(Vec2 p) const {
  Vec2 best;
  double least = 1e300;
  for (const Wall& w : walls_) {
    const Vec2 q = nearest_on_segment(w.a, w.b, p);
    if (const double d = length(q - p); d < least) least = d, best = q;
  }
  return best;
}

}  // namespace inhabit::crowd
