#include "layout/placer.h"

#include <algorithm>

namespace inhabit::layout {
namespace {

constexpr std::uint32_t kEnd = 0xffffffffu;
/// Overlap depth d costs gamma (d^2 + kOverlapEdge d): squares alone would make ten small overlaps cheaper than one.
constexpr double kOverlapEdge = 0.1;
/// Up to this many bodies everybody is a neighbour.
constexpr std::size_t kFew = 32;
/// Of the proposals, how many keep to the directions of the walls. People furnish at right angles, and it packs better.
constexpr double kAligned = 0.9;
/// While every sampled pose overlaps something or misses the particle's own constraints, up to so many times as many
/// are sampled.
constexpr int kLongSearch = 4;
/// Squared energy of a pose that misses them by centimetres only.
constexpr double kFits = 0.01;

}  // namespace

Placer::Placer(const Problem& problem, State& x) : p_(problem), x_(x) {
  const std::size_t n = p_.data.bodies.size();
  std::vector<std::pair<std::uint32_t, Share>> shares;
  const auto& centers = p_.of<CenterTerm>();
  for (std::uint32_t t = 0; t < centers.size(); ++t) {
    for (std::size_t i = 0; i < centers[t].members.size(); ++i) {
      const Anchor& a = centers[t].members[i];
      if (!a.group()) shares.emplace_back(a.body, Share{t, static_cast<std::uint32_t>(i)});
    }
  }
  shares_ = Lists<Share>(n, shares);
  center_sum_.resize(centers.size());
  center_mass_.resize(centers.size());
  reach_.resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    reach_[b] = p_.data.bodies[b].radius;
    for (const std::uint32_t z : p_.zones_of_body[b]) reach_[b] = std::max(reach_[b], p_.zone_reach(z));
  }
  all_ = n <= kFew;
  is_large_.assign(n, false);
  if (!all_) {
    std::vector<double> sorted = reach_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::ranges::nth_element(sorted, middle);
    for (std::uint32_t b = 0; b < n; ++b) {
      is_large_[b] = reach_[b] > 3 * *middle;
      if (is_large_[b])
        large_.push_back(b);
      else
        small_reach_ = std::max(small_reach_, reach_[b]);
    }
    const Bounds room = p_.room.extent();
    cell_size_ = std::max(2 * small_reach_, std::sqrt(room.size().x * room.size().y / (4.0 * static_cast<double>(n))));
    origin_ = room.min - Vec2{cell_size_, cell_size_};
    columns_ = static_cast<std::int64_t>(room.size().x / cell_size_) + 3;
    rows_ = static_cast<std::int64_t>(room.size().y / cell_size_) + 3;
    next_.resize(n), prev_.resize(n), cell_of_.assign(n, kEnd);
  }
  for (const Wall& w : p_.room.walls()) {
    if (std::ranges::any_of(wall_headings_, [&](const Heading& h) {
          return std::abs(dot(h.front, w.along) * cross(h.front, w.along)) < 1e-6;
        }))
      continue;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double angle = wrap_angle(angle_of(w.along) + quarter * (kPi / 2));
      wall_headings_.push_back({angle, direction(angle)});
    }
  }
}

std::size_t Placer::cell(Vec2 p) const {
  const auto c =
      std::clamp(static_cast<std::int64_t>(std::floor((p.x - origin_.x) / cell_size_)), std::int64_t{0}, columns_ - 1);
  const auto r =
      std::clamp(static_cast<std::int64_t>(std::floor((p.y - origin_.y) / cell_size_)), std::int64_t{0}, rows_ - 1);
  return static_cast<std::size_t>(r * columns_ + c);
}

void Placer::reset(const std::vector<bool>& placed) {
  placed_.assign(p_.data.bodies.size(), false);
  std::ranges::fill(center_sum_, Vec2{});
  std::ranges::fill(center_mass_, 0.0);
  if (!all_) head_.assign(static_cast<std::size_t>(columns_ * rows_), kEnd);
  for (std::uint32_t b = 0; b < placed.size(); ++b) {
    if (placed[b]) drop(b);
  }
}

void Placer::count_centers(std::uint32_t body, double sign) {
  for (const Share& s : shares_[body]) {
    const CenterTerm& c = p_.of<CenterTerm>()[s.term];
    const double mass = c.masses[s.member];
    center_sum_[s.term] += sign * mass * x_.position(c.members[s.member]);
    center_mass_[s.term] += sign * mass;
  }
}

void Placer::lift(std::uint32_t body) {
  if (!placed_[body]) return;
  placed_[body] = false;
  count_centers(body, -1);
  if (all_ || is_large_[body]) return;
  const std::uint32_t before = prev_[body], after = next_[body];
  (before == kEnd ? head_[cell_of_[body]] : next_[before]) = after;
  if (after != kEnd) prev_[after] = before;
}

void Placer::drop(std::uint32_t body) {
  placed_[body] = true;
  count_centers(body, 1);
  if (all_ || is_large_[body]) return;
  const std::size_t c = cell(x_.bodies[body].p);
  cell_of_[body] = static_cast<std::uint32_t>(c);
  prev_[body] = kEnd, next_[body] = head_[c];
  if (head_[c] != kEnd) prev_[head_[c]] = body;
  head_[c] = body;
}

template <class F>
void Placer::for_neighbours(std::uint32_t body, F&& f) const {
  if (all_ || is_large_[body]) {
    for (std::uint32_t b = 0; b < placed_.size(); ++b) {
      if (b != body && placed_[b] && !f(b)) return;
    }
    return;
  }
  for (const std::uint32_t b : large_) {
    if (b != body && placed_[b] && !f(b)) return;
  }
  const Vec2 p = x_.bodies[body].p;
  const double r = reach_[body] + small_reach_;
  const auto clamp_column = [&](double v) {
    return std::clamp(static_cast<std::int64_t>(std::floor((v - origin_.x) / cell_size_)), std::int64_t{0},
                      columns_ - 1);
  };
  const auto clamp_row = [&](double v) {
    return std::clamp(static_cast<std::int64_t>(std::floor((v - origin_.y) / cell_size_)), std::int64_t{0}, rows_ - 1);
  };
  for (std::int64_t row = clamp_row(p.y - r); row <= clamp_row(p.y + r); ++row) {
    for (std::int64_t column = clamp_column(p.x - r); column <= clamp_column(p.x + r); ++column) {
      for (std::uint32_t b = head_[static_cast<std::size_t>(row * columns_ + column)]; b != kEnd; b = next_[b]) {
        if (b != body && !f(b)) return;
      }
    }
  }
}

double Placer::pair_cost(std::uint32_t a, std::uint32_t b) const {
  const Vec2 gap = x_.bodies[a].p - x_.bodies[b].p;
  const double far = reach_[a] + reach_[b];
  if (dot(gap, gap) >= far * far) return 0;
  const BodyData &da = p_.data.bodies[a], &db = p_.data.bodies[b];
  double sum = 0;
  if (p_.collisions && meet(a, b)) {
    for (std::uint32_t i = da.first_box; i < da.first_box + da.boxes; ++i) {
      for (std::uint32_t j = db.first_box; j < db.first_box + db.boxes; ++j) {
        if (!near(x_.boxes[i], p_.data.boxes[i].radius, x_.boxes[j], p_.data.boxes[j].radius) || !p_.collide(i, j))
          continue;
        const double d = separation(x_.boxes[i], x_.boxes[j]).depth;
        if (d > 0) sum += p_.collision_gamma * d * (d + kOverlapEdge);
      }
    }
  }
  const auto zones = [&](std::uint32_t owner, const BodyData& other) {
    for (const std::uint32_t z : p_.zones_of_body[owner]) {
      const Zone& zone = p_.zones[z];
      for (std::uint32_t j = other.first_box; j < other.first_box + other.boxes; ++j) {
        if (!near({zone_center(zone, x_)}, zone.radius, x_.boxes[j], p_.data.boxes[j].radius) || !zone.concerns(j))
          continue;
        if (p_.data.boxes[j].low >= zone.high || zone.low >= p_.data.boxes[j].high) continue;
        const double d = zone_separation(zone, x_.boxes[j], x_, false).depth;
        if (d > 0) sum += p_.gamma(zone) * d * d;
      }
    }
  };
  zones(a, db), zones(b, da);
  return sum;
}

double Placer::border_cost(std::uint32_t body) const {
  const BodyData& d = p_.data.bodies[body];
  double sum = 0;
  for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) {
    if (p_.boundary) {
      p_.room.for_each_violation(
          x_.boxes[i], [&](Vec2, double depth) { sum += p_.collision_gamma * depth * (depth + kOverlapEdge); });
    }
    for (const std::uint32_t z : p_.room_zones) {
      const Zone& zone = p_.zones[z];
      if (p_.data.boxes[i].low >= zone.high || zone.low >= p_.data.boxes[i].high) continue;
      if (!near({zone_center(zone, x_)}, zone.radius, x_.boxes[i], p_.data.boxes[i].radius) || !zone.concerns(i))
        continue;
      const double depth = zone_separation(zone, x_.boxes[i], x_, false).depth;
      if (depth > 0) sum += p_.gamma(zone) * depth * depth;
    }
  }
  return sum;
}

double Placer::center_cost(std::uint32_t body) const {
  double sum = 0;
  const auto& centers = p_.of<CenterTerm>();
  for (const Share& s : shares_[body]) {
    const CenterTerm& c = centers[s.term];
    if (c.on && !all_placed(*c.on, body)) continue;
    const double own = c.masses[s.member], mass = center_mass_[s.term] + own;
    const Vec2 mu = (1 / mass) * (center_sum_[s.term] + own * x_.position(c.members[s.member]));
    const Vec2 off = mu - detail::center_target(c, x_, mu);
    // While members are missing their centre says little: count it by the mass that is there.
    sum += p_.gamma(c) * std::min(1.0, mass / c.mass) * dot(off, off);
  }
  return sum;
}

bool Placer::all_placed(const Anchor& a, std::uint32_t self) const {
  if (!a.group()) return a.body == self || placed_[a.body];
  return std::ranges::all_of(p_.data.groups[a.index()].bodies,
                             [&](std::uint32_t b) { return b == self || placed_[b]; });
}

double Placer::term_cost(std::uint32_t body, double limit) const {
  double sum = 0;
  for (std::uint32_t k = p_.touching_first[body]; k < p_.touching_first[body + 1] && sum < limit; ++k) {
    p_.with_term(p_.touching[k], [&]<class T>(const T& term) {
      if constexpr (std::is_same_v<T, CenterTerm>) {
        return;
      } else if constexpr (std::is_same_v<T, CurveTerm>) {
        const Vec2 at = x_.bodies[body].p;
        if (term.curve.medial_axis) return;
        const double d = length(at - detail::nearest_on_curve(detail::placed_curve(term, x_), at).point);
        sum += p_.gamma(term) * d * d;
      } else {
        bool there = true;
        anchors(term, [&](const Anchor& a) { there = there && all_placed(a, body); });
        if (!there) return;
        const double e = error(term, x_);
        sum += p_.gamma(term) * e * e;
      }
    });
  }
  return sum;
}

double Placer::hard_cost(std::uint32_t body, double limit) const {
  double sum = border_cost(body);
  if (sum >= limit) return sum;
  for_neighbours(body, [&](std::uint32_t b) {
    sum += pair_cost(body, b);
    return sum < limit;
  });
  return sum;
}

double Placer::cost(std::uint32_t body) const {
  return hard_cost(body, 1e300) + term_cost(body, 1e300) + center_cost(body);
}

void Placer::overlaps(std::uint32_t body, std::vector<std::pair<std::uint32_t, double>>& out) const {
  out.clear();
  const BodyData& da = p_.data.bodies[body];
  for_neighbours(body, [&](std::uint32_t b) {
    const BodyData& db = p_.data.bodies[b];
    double depth = 0;
    for (std::uint32_t i = da.first_box; i < da.first_box + da.boxes; ++i) {
      for (std::uint32_t j = db.first_box; j < db.first_box + db.boxes; ++j) {
        if (p_.collide(i, j)) depth = std::max(depth, separation(x_.boxes[i], x_.boxes[j]).depth);
      }
    }
    if (depth > 1e-3) out.emplace_back(b, depth);
    return true;
  });
}

State::Body Placer::propose(std::uint32_t body, Rng& rng) const {
  const BodyData& d = p_.data.bodies[body];
  State::Body pose = x_.bodies[body];
  if (d.turns) {
    if (rng.uniform() < kAligned) {
      const std::uint32_t axis = rng.index(static_cast<std::uint32_t>(wall_headings_.size() / 4));
      const Heading& h = wall_headings_[4 * axis + rng.index(4)];
      pose.angle = h.angle, pose.front = h.front;
    } else {
      pose.angle = rng.uniform(-kPi, kPi), pose.front = direction(pose.angle);
    }
  }
  if (d.w <= 0) return pose;
  const Bounds& b = p_.room.extent();
  for (int i = 0; i < 8; ++i) {
    pose.p = {rng.uniform(b.min.x, b.max.x), rng.uniform(b.min.y, b.max.y)};
    if (p_.room.contains(pose.p)) break;
  }
  // A member of a centre of mass: half of the time about where the centre should be, as far as its like take room.
  if (!shares_[body].empty() && rng.uniform() < 0.5) {
    const Share& s = shares_[body][rng.index(static_cast<std::uint32_t>(shares_[body].size()))];
    const CenterTerm& c = p_.of<CenterTerm>()[s.term];
    if (c.target != CenterTerm::Target::room && (!c.on || all_placed(*c.on, body))) {
      const double spread = d.radius * std::sqrt(static_cast<double>(c.members.size()));
      const Vec2 to = detail::center_target(c, x_, pose.p);
      pose.p = to + rng.uniform(0, 1.5 * spread) * direction(rng.uniform(-kPi, kPi));
    }
  }
  return pose;
}

void Placer::fit(std::uint32_t body, bool push) {
  const BodyData& d = p_.data.bodies[body];
  Direct sink{x_};
  x_.solo = body;
  for (int round = 0; round < 2; ++round) {
    for (std::uint32_t k = p_.touching_first[body]; k < p_.touching_first[body + 1]; ++k) {
      p_.with_term(p_.touching[k], [&]<class T>(const T& term) {
        if constexpr (std::is_same_v<T, CurveTerm>) {
          if (term.curve.medial_axis) return;
          const Vec2 at = x_.bodies[body].p;
          x_.shift(body, detail::nearest_on_curve(detail::placed_curve(term, x_), at).point - at);
        } else {
          if constexpr (std::is_same_v<T, CenterTerm>) {
            if (term.members.size() > 1) return;
          }
          bool there = true;
          anchors(term, [&](const Anchor& a) { there = there && all_placed(a, body); });
          if (there) project(term, x_, 1, sink);
        }
      });
    }
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes && d.w > 0 && p_.boundary; ++i)
      p_.room.for_each_violation(x_.boxes[i], [&](Vec2 n, double depth) { x_.shift(body, depth * n); });
    if (!push || d.w <= 0) continue;
    for_neighbours(body, [&](std::uint32_t b) {
      if (!meet(body, b)) return true;
      const BodyData& o = p_.data.bodies[b];
      for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) {
        for (std::uint32_t j = o.first_box; j < o.first_box + o.boxes; ++j) {
          if (!near(x_.boxes[i], p_.data.boxes[i].radius, x_.boxes[j], p_.data.boxes[j].radius) || !p_.collide(i, j))
            continue;
          const Separation s = separation(x_.boxes[i], x_.boxes[j]);
          if (s.depth > 0) x_.shift(body, s.depth * s.normal);
        }
      }
      return true;
    });
  }
  x_.solo = State::kNobody;
}

double Placer::place(std::uint32_t body, Rng& rng, int tries) {
  double best = 1e300, least_fit = 1e300;
  State::Body pose = x_.bodies[body];
  for (int t = 0; t < kLongSearch * tries && best > 1e-9; ++t) {
    if (t >= tries && least_fit < kFits) break;
    const State::Body q = propose(body, rng);
    x_.place(body, q.p, q.angle, q.front);
    fit(body, p_.collisions && (t & 1) != 0);
    // The cheapest first: most poses are worse than the best by one part of their cost alone.
    const double center = center_cost(body);
    if (center >= best) continue;
    const double hard = hard_cost(body, best - center);
    if (hard >= best - center) continue;
    const double fit_cost = hard + term_cost(body, best - center - hard);
    const double c = fit_cost + center;
    if (c < best) best = c, least_fit = fit_cost, pose = x_.bodies[body];
  }
  x_.place(body, pose.p, pose.angle, pose.front);
  drop(body);
  return best;
}

}  // namespace inhabit::layout
