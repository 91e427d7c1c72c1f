#include "layout/contacts.h"

#include <algorithm>
#include <limits>

namespace inhabit::layout {
namespace {

/// Below this many boxes every pair is kept: 24 * 23 / 2 circle tests cost less than finding out which to leave.
constexpr std::size_t kFew = 24;

/// Above this many boxes, which no longer fit into a core's own cache, pairs are visited in the order of their boxes.
constexpr std::size_t kLarge = 2000;

/// So many boxes may have left the cells that they were sorted into before all are sorted anew.
constexpr std::size_t kOutcasts = 256;

/// The next float that is not less.
float rounded_up(double v) {
  const auto f = static_cast<float>(v);
  return f < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// Gives back what growing by doubling took too much.
template <class T>
void trim(std::vector<T>& list) {
  if (list.capacity() > list.size() + list.size() / 4) list.shrink_to_fit();
}

}  // namespace

Contacts::Contacts(const Problem& problem) : p_(problem) {
  const auto& boxes = p_.data.boxes;
  for (std::uint32_t z = 0; z < p_.zones.size(); ++z) zone_reach_.push_back(p_.zone_reach(z));
  all_ = boxes.size() <= kFew;
  if (all_) {
    all_pairs();
    return;
  }
  std::vector<double> radii;
  for (const BoxData& b : boxes) radii.push_back(b.radius);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  const double limit = 3 * *middle;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].radius > limit) {
      large_.push_back(i);
    } else {
      small_radius_ = std::max(small_radius_, boxes[i].radius);
    }
  }
  margin_ = *middle;
  // A group's zone moves when any member does.
  const auto of_group = [](const Zone& z) { return z.owner && z.owner->group(); };
  most_outcasts_ = boxes.size() > kLarge && std::ranges::none_of(p_.zones, of_group) ? kOutcasts : 0;
  for (std::uint32_t z = 0; z < p_.zones.size(); ++z) {
    const auto& owner = p_.zones[z].owner;
    const double reach = owner && !owner->group() ? zone_reach_[z] + p_.data.bodies[owner->body].radius : 1e300;
    if (reach > 2 * limit || boxes[p_.data.bodies[owner->body].first_box].radius > limit) {
      wide_zones_.push_back(z);
    } else {
      small_zone_reach_ = std::max(small_zone_reach_, reach);
    }
  }
}

Contacts::Pair Contacts::pair_of(std::uint32_t i, std::uint32_t j) const {
  const double reach = p_.data.boxes[i].radius + p_.data.boxes[j].radius;
  return {i, j, rounded_up(reach * reach)};
}

Contacts::Pair Contacts::zone_pair_of(std::uint32_t z, std::uint32_t b) const {
  const double reach = p_.zones[z].radius + p_.data.boxes[b].radius;
  return {z, b, rounded_up(reach * reach)};
}

void Contacts::all_pairs() {
  const auto n = static_cast<std::uint32_t>(p_.data.boxes.size());
  for (std::uint32_t i = 0; i < n && p_.collisions; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      if (p_.collide(i, j)) pairs_.push_back(pair_of(i, j));
    }
  }
  for (std::uint32_t z = 0; z < p_.zones.size(); ++z) {
    for (std::uint32_t b = 0; b < n; ++b) {
      if (p_.zone_concerns(z, b)) zone_pairs_.push_back(zone_pair_of(z, b));
    }
  }
}

void Contacts::refresh(const State& x) {
  if (all_) return;
  if (built_at_.empty()) return rebuild(x);
  std::vector<std::uint32_t> strays;
  for (std::uint32_t i = 0; i < x.boxes.size(); ++i) {
    if (!strayed(x, i, built_at_[i])) continue;
    if (outcasts_.size() + strays.size() >= most_outcasts_) return rebuild(x);
    strays.push_back(i);
  }
  if (!strays.empty()) relist(x, strays);
}

void Contacts::rebuild(const State& x) {
  const auto& boxes = p_.data.boxes;
  const std::size_t n = boxes.size();
  built_at_.resize(n);
  Bounds b;
  for (std::size_t i = 0; i < n; ++i) built_at_[i] = x.boxes[i].center, b.add(built_at_[i]);
  // A cell holds the reach of the widest small pair; sparse scenes get larger cells, so that there are about 4 n of
  // them, and no more than that along a row of things, whose extent has no area.
  const Vec2 extent = b.size();
  const double most = 4.0 * static_cast<double>(n);
  grid_.min = b.min;
  grid_.cell = std::max(
      {2 * small_radius_ + margin_, std::sqrt(extent.x * extent.y / most), std::max(extent.x, extent.y) / most});
  grid_.columns = static_cast<std::int64_t>(extent.x / grid_.cell) + 1;
  grid_.rows = static_cast<std::int64_t>(extent.y / grid_.cell) + 1;
  const std::int64_t columns = grid_.columns, rows = grid_.rows;
  // Counting sort of the small boxes by cell.
  cell_first_.assign(static_cast<std::size_t>(columns * rows) + 1, 0);
  cell_of_.assign(n, 0xffffffffu);
  for (std::uint32_t i = 0, next = 0; i < n; ++i) {
    if (next < large_.size() && large_[next] == i) {
      ++next;
      continue;
    }
    cell_of_[i] = static_cast<std::uint32_t>(grid_.row(built_at_[i].y) * columns + grid_.column(built_at_[i].x));
    ++cell_first_[cell_of_[i] + 1];
  }
  for (std::size_t c = 1; c < cell_first_.size(); ++c) cell_first_[c] += cell_first_[c - 1];
  cell_items_.resize(cell_first_.back());
  std::vector<std::uint32_t> fill(cell_first_.begin(), cell_first_.end() - 1);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (cell_of_[i] != 0xffffffffu) cell_items_[fill[cell_of_[i]]++] = {built_at_[i], boxes[i].radius, i};
  }
  outcasts_.clear(), outcast_ = core::IndexSet(n, false);
  pairs_.clear();
  if (p_.collisions) {
    const auto consider = [&](const Item& i, const Item& j) {
      const double reach = i.radius + j.radius + margin_;
      const Vec2 d = i.center - j.center;
      if (dot(d, d) < reach * reach && p_.collide(i.box, j.box))
        pairs_.push_back(pair_of(std::min(i.box, j.box), std::max(i.box, j.box)));
    };
    // Small with small: a cell is as wide as any such pair reaches, so each cell meets itself and four of its
    // neighbours.
    for (std::int64_t r = 0; r < rows; ++r) {
      for (std::int64_t c = 0; c < columns; ++c) {
        const auto k = static_cast<std::size_t>(r * columns + c);
        for (std::uint32_t s = cell_first_[k]; s < cell_first_[k + 1]; ++s) {
          for (std::uint32_t t = s + 1; t < cell_first_[k + 1]; ++t) consider(cell_items_[s], cell_items_[t]);
          for (const auto& [dc, dr] : {std::pair{1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
            if (c + dc < 0 || c + dc >= columns || r + dr >= rows) continue;
            const auto other = static_cast<std::size_t>((r + dr) * columns + c + dc);
            for (std::uint32_t t = cell_first_[other]; t < cell_first_[other + 1]; ++t)
              consider(cell_items_[s], cell_items_[t]);
          }
        }
      }
    }
    for (const std::uint32_t i : large_) {
      for (std::uint32_t j = 0; j < n; ++j) {
        if (cell_of_[j] != 0xffffffffu || j > i)
          consider({built_at_[i], boxes[i].radius, i}, {built_at_[j], boxes[j].radius, j});
      }
    }
  }
  if (n > kLarge) sort_pairs();
  zone_pairs_.clear();
  for (std::uint32_t z = 0; z < p_.zones.size(); ++z) {
    const Zone& zone = p_.zones[z];
    const Vec2 at = zone.owner && !zone.owner->group() ? x.bodies[zone.owner->body].p : zone_center(zone, x);
    const auto consider = [&](const Item& j) {
      const double reach = zone_reach_[z] + j.radius + margin_;
      const Vec2 gap = at - j.center;
      if (dot(gap, gap) >= reach * reach) return;
      if (p_.zone_concerns(z, j.box)) zone_pairs_.push_back(zone_pair_of(z, j.box));
    };
    visit_cells(at, zone_reach_[z] + small_radius_ + margin_, consider);
    for (const std::uint32_t j : large_) consider({built_at_[j], boxes[j].radius, j});
  }
  trim(pairs_), trim(zone_pairs_);
}

void Contacts::sort_pairs() {
  std::vector<std::uint32_t> next(p_.data.boxes.size() + 1);
  for (const Pair& pair : pairs_) ++next[pair.a + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Pair> sorted(pairs_.size());
  for (const Pair& pair : pairs_) sorted[next[pair.a]++] = pair;
  pairs_ = std::move(sorted);
}

void Contacts::score_pair(const State& x, const Pair& pair, Score& s, double& squares) const {
  const Vec2 d = x.boxes[pair.a].center - x.boxes[pair.b].center;
  if (dot(d, d) >= pair.reach_square) return;
  const double depth = separation(x.boxes[pair.a], x.boxes[pair.b]).depth;
  if (depth <= 0) return;
  s.violation += depth;
  s.worst = std::max(s.worst, depth);
  squares += p_.collision_gamma * depth * depth;
}

void Contacts::score_collisions(const State& x, Score& s, double& squares) const {
  for (const Pair& pair : pairs_) score_pair(x, pair, s, squares);
}

void Contacts::score_zones(const State& x, Score& s, double& squares) const {
  const Zone* at = nullptr;
  Vec2 center;
  for (const Pair& pair : zone_pairs_) {
    const Zone& z = p_.zones[pair.a];
    if (&z != at) at = &z, center = zone_center(z, x);
    const Box& box = x.boxes[pair.b];
    const Vec2 gap = box.center - center;
    if (dot(gap, gap) >= pair.reach_square) continue;
    const double depth = zone_separation(z, box, x, false).depth;
    if (depth <= 0) continue;
    s.slack = std::max(s.slack, depth);
    squares += p_.gamma(z) * depth * depth;
  }
}

void Contacts::add_load(const State& x, std::span<double> load) const {
  for (const Pair& pair : pairs_) {
    const Vec2 d = x.boxes[pair.a].center - x.boxes[pair.b].center;
    if (dot(d, d) >= pair.reach_square) continue;
    const double depth = separation(x.boxes[pair.a], x.boxes[pair.b]).depth;
    if (depth <= 0) continue;
    load[p_.data.boxes[pair.a].body] += depth, load[p_.data.boxes[pair.b].body] += depth;
  }
}

}  // namespace inhabit::layout
