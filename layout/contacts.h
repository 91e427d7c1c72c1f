#pragma once
#include "core/index_set.h"
#include "layout/constraints/collision.h"

namespace inhabit::layout {

/// How good a state is: hard violations and the energy.
struct Score {
  double energy = 0;     ///< TVCG eq. 1
  double violation = 0;  ///< summed depth of overlaps and of boxes outside, metres
  double worst = 0;      ///< deepest of them
  double slack = 0;      ///< largest |C| of everything else, metres or radians
  /// A little stricter than the 1 mm of check: a corner that far beyond two walls at once is 1.4 times as far outside.
  bool feasible() const { return worst <= 0.7e-3; }
  /// Feasible before infeasible, then by energy.
  bool better_than(const Score& b) const { return feasible() != b.feasible() ? feasible() : energy < b.energy; }
};

/// The pairs of boxes, and of zones and boxes, that may meet: found by a uniform grid with a margin, and kept until
/// something has moved by half of it. Small scenes keep all pairs.
class Contacts {
 public:
  explicit Contacts(const Problem& problem);

  /// Brings the pairs up to date with x; cheap when little has moved.
  void refresh(const State& x);

  template <class Sink>
  void project_collisions(const State& x, double k, Sink& sink) const {
    for (const Pair& pair : pairs_) project_pair(x, pair, k, sink);
  }
  template <class Sink>
  void project_zones(const State& x, std::span<const double> stiffness, bool sphere, Sink& sink) const;

  /// Adds overlaps to the sums of the score (squares, before the root).
  void score_collisions(const State& x, Score& s, double& squares) const;
  /// Adds occupied zones.
  void score_zones(const State& x, Score& s, double& squares) const;
  void score(const State& x, Score& s, double& squares) const {
    score_collisions(x, s, squares);
    score_zones(x, s, squares);
  }
  /// Adds every box's overlap depth, shared among the bodies of each pair, to `load`.
  void add_load(const State& x, std::span<double> load) const;

  struct Pair {
    std::uint32_t a = 0, b = 0;
    float reach_square = 0;  ///< of the two circles about them, rounded up: farther apart they cannot meet
  };
  const std::vector<Pair>& pairs() const { return pairs_; }
  /// Parts the two; false when they did not overlap by more than `least`.
  template <class Sink>
  bool project_pair(const State& x, const Pair& pair, double k, Sink& sink, double least = 0) const;
  void score_pair(const State& x, const Pair& pair, Score& s, double& squares) const;
  /// The box has moved so far from where it was listed that its pairs are to be found anew.
  bool strayed(const State& x, std::uint32_t box, Vec2 listed_at) const {
    const Vec2 d = x.boxes[box].center - listed_at;
    return dot(d, d) > margin_ * margin_ / 4;
  }
  /// Where each box was when its pairs were found. Empty when all pairs are kept.
  const std::vector<Vec2>& built_at() const { return built_at_; }
  /// Boxes whose circles were farther apart than this when they were listed are no pair.
  double margin() const { return margin_; }
  Pair pair_of(std::uint32_t i, std::uint32_t j) const;
  /// Calls f(box) for every box that was listed where its pairs with a box at p may be, `radius` large, and for others.
  template <class F>
  void visit_boxes(Vec2 p, double radius, F&& f) const {
    visit_cells(p, radius + small_radius_ + margin_, [&](const Item& item) {
      if (!outcast_.contains(item.box)) f(item.box);
    });
    for (const std::uint32_t i : outcasts_) f(i);
    for (const std::uint32_t i : large_) f(i);
  }

 private:
  Pair zone_pair_of(std::uint32_t z, std::uint32_t b) const;
  void rebuild(const State& x);
  /// Finds the pairs of these boxes, and of zones that ride with them, anew: in a large hall somebody strays in every
  /// iteration.
  void relist(const State& x, std::span<const std::uint32_t> strays);
  void all_pairs();
  /// In the order of their first boxes: what stands together in the document stands together in memory.
  void sort_pairs();
  void separate_along_wall(const State& x, const Pair& pair, const Separation& s, double k, auto& sink) const;

  const Problem& p_;
  std::vector<Pair> pairs_;
  std::vector<Pair> zone_pairs_;  ///< a: zone, b: box
  std::vector<double> zone_reach_;
  std::vector<Vec2> built_at_;
  /// A small box with what finding its pairs needs, in the order of the cells.
  struct Item {
    Vec2 center;
    double radius = 0;
    std::uint32_t box = 0;
  };
  std::vector<Item> cell_items_;
  struct Grid {
    Vec2 min;
    double cell = 1;
    std::int64_t columns = 0, rows = 0;
    // Truncation is floor here: nothing lies below the bounds' corner, and queries that do are clamped to it.
    std::int64_t column(double v) const {
      return std::min(static_cast<std::int64_t>(std::max(0.0, (v - min.x) / cell)), columns - 1);
    }
    std::int64_t row(double v) const {
      return std::min(static_cast<std::int64_t>(std::max(0.0, (v - min.y) / cell)), rows - 1);
    }
  };
  Grid grid_;
  /// Calls f(item) for the items of every cell within `reach` of p, at least.
  template <class F>
  void visit_cells(Vec2 p, double reach, F&& f) const {
    for (std::int64_t r = grid_.row(p.y - reach); r <= grid_.row(p.y + reach); ++r) {
      for (std::int64_t c = grid_.column(p.x - reach); c <= grid_.column(p.x + reach); ++c) {
        const auto k = static_cast<std::size_t>(r * grid_.columns + c);
        for (std::uint32_t s = cell_first_[k]; s < cell_first_[k + 1]; ++s) f(cell_items_[s]);
      }
    }
  }
  std::vector<std::uint32_t> outcasts_;  ///< boxes that are no longer in the cell of their item
  core::IndexSet outcast_;
  std::size_t most_outcasts_ = 0;          ///< 0: pairs are always found anew
  std::vector<std::uint32_t> wide_zones_;  ///< asked one by one: they reach far, or ride on nobody in a cell
  double small_zone_reach_ = 0;            ///< of all others, from their body's boxes
  std::vector<std::uint32_t> large_, cell_of_, cell_first_;
  double margin_ = 0, small_radius_ = 0;
  bool all_ = false;
};

/// Adds how far the body's boxes are outside to the sums of the score.
inline void score_boundary(const Problem& p, const State& x, std::uint32_t body, Score& s, double& squares) {
  const BodyData& d = p.data.bodies[body];
  // What cannot move stands as it is given.
  for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes && d.w > 0 && p.boundary; ++i) {
    double deepest = 0;
    p.room.for_each_violation(x.boxes[i], [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
    s.violation += deepest;
    s.worst = std::max(s.worst, deepest);
    squares += p.boundary_gamma * deepest * deepest;
  }
}

/// Overlap that two boxes have as circles at least: a cheap way to say no.
inline bool near(const Box& a, double ra, const Box& b, double rb) {
  const Vec2 d = a.center - b.center;
  const double r = ra + rb;
  return dot(d, d) < r * r;
}

template <class Sink>
bool Contacts::project_pair(const State& x, const Pair& pair, double k, Sink& sink, double least) const {
  const Vec2 d = x.boxes[pair.a].center - x.boxes[pair.b].center;
  if (dot(d, d) >= pair.reach_square) return false;
  const BoxData &da = p_.data.boxes[pair.a], &db = p_.data.boxes[pair.b];
  const Separation s = contact(p_, x, pair.a, pair.b);
  // Circles that touch round boxes that overlap: nothing to do, but not apart either.
  if (s.depth <= least) return (da.sphere & db.sphere) != 0;
  const Anchor a{da.body}, b{db.body};
  part(a, b, p_.data.bodies[da.body].w, p_.data.bodies[db.body].w, s.normal, -k * s.depth, sink);
  if (da.at_wall && db.at_wall) separate_along_wall(x, pair, s, k, sink);
  return true;
}

/// Two objects held to the same wall part along it, as well as along the shortest way (TVCG 3.3.9, fig. 8b).
void Contacts::separate_along_wall(const State& x, const Pair& pair, const Separation& s, double k, auto& sink) const {
  const Box &a = x.boxes[pair.a], &b = x.boxes[pair.b];
  const WallPoint wa = x.room->nearest_wall(a.center - a.half_depth * a.front);
  const WallPoint wb = x.room->nearest_wall(b.center - b.half_depth * b.front);
  if (wa.wall != wb.wall) return;
  const Vec2 t = x.room->walls()[wa.wall].along;
  if (std::abs(dot(s.normal, t)) > 0.7) return;
  const double gap = dot(a.center - b.center, t);
  const double depth = a.extent(t) + b.extent(t) - std::abs(gap);
  if (depth <= 0) return;
  const std::uint32_t ba = p_.data.boxes[pair.a].body, bb = p_.data.boxes[pair.b].body;
  part(Anchor{ba}, Anchor{bb}, p_.data.bodies[ba].w, p_.data.bodies[bb].w, gap < 0 ? -t : t, -k * depth, sink);
}

template <class Sink>
void Contacts::project_zones(const State& x, std::span<const double> stiffness, bool sphere, Sink& sink) const {
  // Pairs of one zone follow each other: its centre is worked out once, and again when somebody has moved.
  const Zone* at = nullptr;
  Vec2 center;
  for (const Pair& pair : zone_pairs_) {
    const Zone& z = p_.zones[pair.a];
    if (&z != at) at = &z, center = zone_center(z, x);
    const Box& box = x.boxes[pair.b];
    const Vec2 gap = box.center - center;
    if (dot(gap, gap) >= pair.reach_square) continue;
    const BoxData& d = p_.data.boxes[pair.b];
    const Separation s = zone_separation(z, box, x, sphere);
    if (s.depth <= 0) continue;
    at = nullptr;
    const Anchor a{d.body};
    const double w = p_.data.bodies[d.body].w, k = stiffness[z.slot];
    if (z.owner) {
      part(a, *z.owner, w, x.w(*z.owner), s.normal, -k * s.depth, sink);
    } else if (w > 0) {
      sink.shift(a, (k * s.depth) * s.normal);
    }
  }
}

}  // namespace inhabit::layout
