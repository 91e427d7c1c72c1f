#include "crowd/planners/ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace inhabit::crowd {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// Tangents that meet in one line leave a circle where they touch it: radians.
constexpr double kSameTurn = 1e-6;
/// A circle counts as passed this much before its end, and its end is not missed by who steps over it by that much:
/// radians.
constexpr double kPassed = 0.02, kOvershoot = 0.4;

/// Removes from the intervals what lies between `low` and `high`.
void cut(std::vector<std::pair<double, double>>& intervals, double low, double high) {
  std::vector<std::pair<double, double>> left;
  for (const auto& [a, b] : intervals) {
    if (std::min(b, low) > a) left.emplace_back(a, std::min(b, low));
    if (b > std::max(a, high)) left.emplace_back(std::max(a, high), b);
  }
  intervals = std::move(left);
}

/// Removes the part of a + t d that is nearer than `radius` to a point.
void cut_disc(std::vector<std::pair<double, double>>& intervals, Vec2 a, Vec2 d, Vec2 center, double radius) {
  const double middle = dot(center - a, d) / dot(d, d);
  const Vec2 off = center - a - middle * d;
  const double left = radius * radius - dot(off, off);
  if (left <= 0) return;
  const double half = std::sqrt(left / dot(d, d));
  cut(intervals, middle - half, middle + half);
}

/// Removes the part of a + t d that is nearer than `radius` to a wall.
void cut_near(std::vector<std::pair<double, double>>& intervals, Vec2 a, Vec2 d, const Corners::Wall& w,
              double radius) {
  if (radius <= 0) return;
  cut_disc(intervals, a, d, w.a, radius);
  cut_disc(intervals, a, d, w.b, radius);
  // The strip on both sides of the wall: within `radius` across it, within its length along it.
  const Vec2 along = unit(w.b - w.a);
  double low = -kFar, high = kFar;
  const auto clip = [&](double at, double slope, double least, double most) {
    if (slope == 0) {
      if (at <= least || at >= most) high = -kFar;
      return;
    }
    const double t0 = (least - at) / slope, t1 = (most - at) / slope;
    low = std::max(low, std::min(t0, t1)), high = std::min(high, std::max(t0, t1));
  };
  clip(cross(along, a - w.a), cross(along, d), -radius, radius);
  clip(dot(along, a - w.a), dot(along, d), 0, length(w.b - w.a));
  if (high > low) cut(intervals, low, high);
}

}  // namespace

Ways::Ways(const Corners& corners, const std::vector<const Place*>& places) : corners_(&corners) {
  // An aim off the floor leaves the area; one that no body's middle gets to is headed for all the same.
  for (const auto& [areas, body] :
       {std::pair{false, corners.body()}, {false, 0.0}, {true, corners.body()}, {true, 0.0}})
    if (pieces_.empty()) find_pieces(places, areas, body);
  search();
}

void Ways::find_pieces(const std::vector<const Place*>& places, bool areas, double body) {
  for (const Place* place : places) {
    const Ring& ring = areas ? place->area.ring : place->aim.ring;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], d = ring[(k + 1) % ring.size()] - a;
      if (dot(d, d) == 0) continue;
      std::vector<double> ends = {0, 1};
      for (const Corners::Wall& w : corners_->walls()) {
        const Vec2 e = w.b - w.a;
        const double slope = cross(d, e);
        if (slope == 0) {  // along a wall: it may begin or end on the side
          if (std::abs(cross(d, w.a - a)) > 1e-9 * dot(d, d)) continue;
          for (const Vec2 p : {w.a, w.b}) ends.push_back(dot(p - a, d) / dot(d, d));
          continue;
        }
        const double t = cross(w.a - a, e) / slope, u = cross(w.a - a, d) / slope;
        if (u >= -1e-9 && u <= 1 + 1e-9) ends.push_back(t);
      }
      std::ranges::sort(ends);
      std::vector<std::pair<double, double>> intervals;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double from = std::max(ends[i], 0.0), to = std::min(ends[i + 1], 1.0);
        if (to > from && corners_->on_floor(a + 0.5 * (from + to) * d)) intervals.emplace_back(from, to);
      }
      for (const Corner& c : corners_->all()) cut_disc(intervals, a, d, c.at, c.radius);
      for (const Corners::Wall& w : corners_->walls()) cut_near(intervals, a, d, w, body);
      for (const auto& [from, to] : intervals) pieces_.push_back({a + from * d, a + to * d});
    }
  }
}

/// Dijkstra's search over the tangents, from the goal backwards. What a tangent costs is its own length, the arc at its
/// end, and what that arc's exit costs.
void Ways::search() {
  const auto tangents = corners_->tangents();
  struct Last {  // from a circle to the goal
    std::uint32_t node, landing;
    double turn;
  };
  std::vector<Last> lasts;
  std::vector<double> cost(tangents.size(), kFar);
  struct Entry {
    double cost;
    std::uint32_t index;  // of a tangent, or from tangents.size() on of a last
    bool operator>(const Entry& b) const { return cost != b.cost ? cost > b.cost : index > b.index; }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::uint32_t node = 0; node < corners_->nodes(); ++node) {
    const double s = sense_of(node), fan = corners_->all()[corner_of(node)].fan;
    const auto add = [&](Vec2 from, Vec2 to, double turn, std::uint32_t index) {
      if (turn < -kBesideFan || turn > fan + kBesideFan || !corners_->arc_clear(node, turn, turn)) return;
      if (!corners_->clear(from, to, node, kNone)) return;
      open.push({length(to - from), static_cast<std::uint32_t>(tangents.size() + lasts.size())});
      lasts.push_back({node, index, turn});
    };
    const Corner& c = corners_->all()[corner_of(node)];
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      const Piece& piece = pieces_[k];
      const auto base = static_cast<std::uint32_t>(corners_->nodes()) + 3 * k;
      // The shortest way to a line ends at right angles; to an end of the piece from wherever.
      const Vec2 along = unit(piece.b - piece.a);
      for (const Vec2 direction : {perp(along), -perp(along)}) {
        const Vec2 from = c.at - s * c.radius * perp(direction);
        const Vec2 to = nearest_on_segment(piece.a, piece.b, from);
        if (std::abs(dot(to - from, along)) > 1e-9 || dot(to - from, direction) < 0) continue;
        add(from, to, corners_->turn_of(node, -s * perp(direction)), base);
      }
      for (std::uint32_t end = 0; end < 2; ++end) {
        const Vec2 q = end == 0 ? piece.a : piece.b;
        if (const auto touch = corners_->leave(node, q)) add(touch->at, q, touch->turn, base + 1 + end);
      }
    }
  }
  std::vector<std::vector<Exit>> exits(corners_->nodes());
  while (!open.empty()) {
    const Entry e = open.top();
    open.pop();
    const bool is_last = e.index >= tangents.size();
    if (!is_last && e.cost > cost[e.index]) continue;
    const std::uint32_t node = is_last ? lasts[e.index - tangents.size()].node : tangents[e.index].from;
    const double turn = is_last ? lasts[e.index - tangents.size()].turn : tangents[e.index].from_turn;
    const double radius = corners_->all()[corner_of(node)].radius;
    exits[node].push_back({turn, e.cost + radius * turn,
                           is_last ? lasts[e.index - tangents.size()].landing : tangents[e.index].to, turn});
    for (const std::uint32_t k : corners_->into(node)) {
      const Tangent& t = tangents[k];
      if (t.to_turn > turn + kSameTurn) continue;
      const double total = t.length + radius * std::max(0.0, turn - t.to_turn) + e.cost;
      if (!(total < cost[k]) || !corners_->arc_clear(node, t.to_turn, turn)) continue;
      cost[k] = total;
      open.push({total, k});
    }
  }
  first_exit_.push_back(0);
  for (std::uint32_t node = 0; node < corners_->nodes(); ++node) {
    auto& own = exits[node];
    std::ranges::stable_sort(own, {}, &Exit::turn);
    for (std::size_t k = own.size(); k-- > 1;) {
      const Exit& after = own[k];
      if (after.cost >= own[k - 1].cost || !corners_->arc_clear(node, own[k - 1].turn, after.leaves)) continue;
      own[k - 1].cost = after.cost, own[k - 1].to = after.to, own[k - 1].leaves = after.leaves;
    }
    // From anywhere outside the circle, a tangent is longer than the distance to the middle less a radius, and the arc
    // behind it ends at an exit.
    double least = kFar;
    for (const Exit& e : own) least = std::min(least, e.cost);
    const Corner& c = corners_->all()[corner_of(node)];
    least_.push_back(least - c.radius * (1 + c.fan + kBesideFan));
    exits_.insert(exits_.end(), own.begin(), own.end());
    first_exit_.push_back(static_cast<std::uint32_t>(exits_.size()));
  }
}

const Ways::Exit* Ways::exit_after(std::uint32_t node, double turn) const {
  const auto begin = exits_.begin() + first_exit_[node], end = exits_.begin() + first_exit_[node + 1];
  const auto found = std::lower_bound(begin, end, turn, [](const Exit& e, double t) { return e.turn < t; });
  if (found == end || !corners_->arc_clear(node, turn, found->leaves)) return nullptr;
  return &*found;
}

double Ways::left(std::uint32_t node, double turn) const {
  const Exit* exit = exit_after(node, turn - kSameTurn);
  return exit == nullptr ? kFar : exit->cost - corners_->all()[corner_of(node)].radius * turn;
}

Ways::Landing Ways::landing(Vec2 p, std::uint32_t index) const {
  const std::uint32_t k = index - static_cast<std::uint32_t>(corners_->nodes());
  const Piece& piece = pieces_[k / 3];
  const Vec2 q = k % 3 == 0 ? nearest_on_segment(piece.a, piece.b, p) : k % 3 == 1 ? piece.a : piece.b;
  return {q, length(q - p)};
}

Ways::Choice Ways::choose(Vec2 p, std::uint32_t before) const {
  const Choice best = choose(p, before, Corners::Leaving::outwards);
  if (best.target != kNone && !corners_->in_circle(p)) return best;
  // Somebody pushed into a circle, or into several where they overlap, may find no way that leads straight out, or one
  // that leads far round.
  const Choice inwards = choose(p, before, Corners::Leaving::anywhere);
  return inwards.length < 0.8 * best.length ? inwards : best;
}

Ways::Choice Ways::choose(Vec2 p, std::uint32_t before, Corners::Leaving leaving) const {
  Choice best;
  const auto consider = [&](std::uint32_t target, double factor) {
    double length = 0;
    Vec2 to;
    if (target >= corners_->nodes()) {
      const Landing at = landing(p, target);
      length = at.length, to = at.at;
    } else {
      const Touch touch = corners_->arrive(target, p);
      length = touch.length + left(target, touch.turn), to = touch.at;
    }
    if (!(factor * length < best.length)) return;
    if (!corners_->clear(p, to, kNone, target < corners_->nodes() ? target : kNone, leaving)) return;
    best = {target, factor * length};
  };
  if (before != kNone) consider(before, 0.99);
  const auto targets = static_cast<std::uint32_t>(corners_->nodes() + 3 * pieces_.size());
  for (std::uint32_t k = static_cast<std::uint32_t>(corners_->nodes()); k < targets; ++k) consider(k, 1);
  // Nodes in order of a bound on the way over them, as long as one may be better: few need to be looked at.
  struct Bound {
    double least;
    std::uint32_t node;
    bool operator>(const Bound& b) const { return least != b.least ? least > b.least : node > b.node; }
  };
  thread_local std::vector<Bound> bounds;
  bounds.clear();
  for (std::uint32_t node = 0; node < corners_->nodes(); ++node) {
    const double least = geometry::length(corners_->all()[corner_of(node)].at - p) + least_[node];
    if (least < best.length) bounds.push_back({least, node});
  }
  std::ranges::make_heap(bounds, std::greater<>());
  while (!bounds.empty() && bounds.front().least < best.length) {
    consider(bounds.front().node, 1);
    std::ranges::pop_heap(bounds, std::greater<>());
    bounds.pop_back();
  }
  if (best.target != kNone && best.target == before) best.length /= 0.99;
  return best;
}

Ways::Step Ways::step(Vec2 p, std::uint32_t target, bool chosen_now) const {
  for (int passed = 0; passed < 4; ++passed) {
    if (target >= corners_->nodes()) {
      if (target >= corners_->nodes() + 3 * pieces_.size()) break;
      const Landing at = landing(p, target);
      return {at.length > 0 ? unit(at.at - p) : Vec2{}, at.at, target};
    }
    const Touch touch = corners_->arrive(target, p);
    const Exit* exit = exit_after(target, touch.turn - (chosen_now ? kSameTurn : kOvershoot));
    if (exit == nullptr) break;
    const double radius = corners_->all()[corner_of(target)].radius;
    const bool there = length(p - corners_->all()[corner_of(target)].at) < radius + std::max(0.1, 0.5 * radius);
    if (chosen_now || !there || exit->leaves > touch.turn + kPassed) return {touch.direction, touch.at, target};
    target = exit->to;
  }
  return {};
}

bool Ways::in_sight(Vec2 p, std::uint32_t target, Vec2 towards) const {
  return corners_->clear(p, towards, kNone, target < corners_->nodes() ? target : kNone, Corners::Leaving::anywhere);
}

}  // namespace inhabit::crowd
