#include "crowd/models/pbd_lists.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "crowd/models/pbd_lists.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "crowd/models/pbd_vectors-inl.h"

#ifndef INHABIT_PBD_LISTS_ONCE
#define INHABIT_PBD_LISTS_ONCE
namespace inhabit::crowd::pbd_model {

/// Candidates of one agent, in ascending order of index.
struct Candidates {
  static constexpr std::size_t kRoom = 192;
  std::array<float, kRoom + kLanes> d2;
  std::array<std::int32_t, kRoom + kLanes> index;
  std::size_t count = 0;
};

/// Keeps the nearest `limit`, by distance and then by index, in order of index.
inline void keep_nearest(Candidates& c, std::size_t limit) {
  if (c.count <= limit) return;
  std::array<float, Candidates::kRoom + kLanes> sorted{};
  std::copy_n(c.d2.begin(), c.count, sorted.begin());
  std::nth_element(sorted.begin(), sorted.begin() + limit - 1, sorted.begin() + c.count);
  const float farthest = sorted[limit - 1];
  std::size_t nearer = 0;
  for (std::size_t k = 0; k < c.count; ++k) nearer += c.d2[k] < farthest;
  std::size_t ties = limit - nearer, kept = 0;
  for (std::size_t k = 0; k < c.count; ++k) {
    const bool keep = c.d2[k] < farthest || (c.d2[k] == farthest && ties > 0);
    if (!keep) continue;
    ties -= c.d2[k] == farthest;
    c.d2[kept] = c.d2[k], c.index[kept++] = c.index[k];
  }
  c.count = kept;
}

}  // namespace inhabit::crowd::pbd_model
#endif

HWY_BEFORE_NAMESPACE();
namespace inhabit::crowd::pbd_model::HWY_NAMESPACE {

/// Adds those of the run [begin, end) that are nearer than `reach`, plus their own grown radius when `growth` > 0.
HWY_INLINE void collect(const Work& work, std::uint32_t i, std::uint32_t begin, std::uint32_t end, float reach,
                        float growth, std::size_t limit, Candidates& out) {
  const Pair own_place{set(work.at[2 * i]), set(work.at[2 * i + 1])};
  const auto own = hn::Set(kDI, static_cast<std::int32_t>(i)), last = hn::Set(kDI, static_cast<std::int32_t>(end));
  for (std::uint32_t j = begin; j < end; j += static_cast<std::uint32_t>(hn::Lanes(kD))) {
    const VI index = count_from(j);
    const Pair d = load(work.at, j) - own_place;
    const V d2 = dot(d, d);
    auto radius = hn::Set(kD, reach);
    if (growth > 0) radius = hn::Add(radius, hn::Mul(hn::LoadU(kD, work.radius.data() + j), hn::Set(kD, growth)));
    auto near = hn::Lt(d2, hn::Mul(radius, radius));
    near = hn::And(near, hn::RebindMask(kD, hn::And(hn::Lt(index, last), hn::Ne(index, own))));
    hn::CompressStore(d2, near, kD, out.d2.data() + out.count);
    out.count += hn::CompressStore(index, hn::RebindMask(kDI, near), kDI, out.index.data() + out.count);
    if (out.count > Candidates::kRoom) keep_nearest(out, limit);
  }
}

/// keep_nearest for few: bisects for a distance that just so many are nearer than.
HWY_INLINE void keep_within(Candidates& c, std::size_t limit) {
  if (c.count <= limit) return;
  const std::size_t lanes = hn::Lanes(kD);
  for (std::size_t k = c.count; k < c.count + lanes; ++k) c.d2[k] = 3e38f;
  float low = 0, high = *std::max_element(c.d2.begin(), c.d2.begin() + static_cast<std::ptrdiff_t>(c.count));
  // People are about evenly spread, so that numbers grow like squares of distances.
  float border = high * static_cast<float>(limit) / static_cast<float>(c.count);
  for (int round = 0; round < 24; ++round) {
    std::size_t nearer = 0;
    for (std::size_t k = 0; k < c.count; k += lanes)
      nearer += hn::CountTrue(kD, hn::Lt(hn::LoadU(kD, c.d2.data() + k), hn::Set(kD, border)));
    if (nearer == limit) {
      std::size_t kept = 0;
      for (std::size_t k = 0; k < c.count; ++k) {
        const bool keep = c.d2[k] < border;
        c.d2[kept] = c.d2[k], c.index[kept] = c.index[k];
        kept += keep;
      }
      c.count = kept;
      return;
    }
    (nearer < limit ? low : high) = border;
    border = low + (high - low) / 2;
  }
  keep_nearest(c, limit);  // equally far ones
}

void far_candidates(const Work& work, const Grid& grid, const Reach& reach, std::uint32_t i, Candidates& out) {
  const float x = work.at[2 * i], y = work.at[2 * i + 1];
  // In a crowd the nearest few are much nearer than the range: a circle that should hold half as many again.
  std::uint32_t around = 0;
  grid.for_each_run(x, y, grid.cell(), [&](std::uint32_t begin, std::uint32_t end) { around += end - begin; });
  const float side = 3 * grid.cell();
  const float density = static_cast<float>(around) / (side * side);
  const float likely = std::sqrt(1.6f * static_cast<float>(reach.far_count + 1) / (3.14159f * density));
  float range = std::min(likely, reach.far_range);
  for (;;) {
    out.count = 0;
    grid.for_each_run(x, y, range, [&](std::uint32_t begin, std::uint32_t end) {
      collect(work, i, begin, end, range, 0, reach.far_count, out);
    });
    if (out.count >= reach.far_count || range >= reach.far_range) break;
    range = std::min(2 * range, reach.far_range);
  }
  keep_within(out, reach.far_count);
}

/// The lists of one block, one after the other, become rows.
void append_rows(const std::array<Candidates, kLanes>& lists, std::size_t first, NeighbourRows& rows, std::size_t b) {
  std::size_t most = 0;
  for (const Candidates& list : lists) most = std::max(most, list.count);
  const std::size_t at = rows.items.size();
  rows.items.resize(at + most * kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t r = 0; r < most; ++r)
      rows.items[at + r * kLanes + lane] =
          r < lists[lane].count ? lists[lane].index[r] : static_cast<std::int32_t>(first + lane);
  rows.first[b + 1] = rows.first[b] + static_cast<std::uint32_t>(most);
}

/// The narrowest gap between the grown discs of agent i and of those; the skin when there are none.
float gap_of(const Work& work, const Candidates& list, std::size_t i, const Reach& reach) {
  float gap = reach.skin;
  for (std::size_t k = 0; k < list.count; ++k) {
    const float both =
        work.alike() ? 2 * work.common_radius : work.radius[i] + work.radius[static_cast<std::size_t>(list.index[k])];
    gap = std::min(gap, std::sqrt(list.d2[k]) - both * reach.growth);
  }
  return gap;
}

void find_neighbours(Work& work, const Grid& grid, const Reach& reach, std::size_t chunk) {
  Chunk& out = work.chunks[chunk];
  // Collected elsewhere first, so that the chunk gets no more room than it needs: that is a third of all memory.
  thread_local NeighbourRows contact_rows, far_rows;
  contact_rows.items.clear(), far_rows.items.clear();
  contact_rows.first.fill(0), far_rows.first.fill(0);
  std::array<Candidates, kLanes> contacts, far;
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    const std::size_t first = chunk * kChunk + b * kLanes;
    out.gap[b] = reach.skin;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      contacts[lane].count = far[lane].count = 0;
      const auto i = static_cast<std::uint32_t>(first + lane);
      if (i >= work.count) continue;
      const float largest = work.common_radius * reach.growth;
      const float own = work.alike() ? largest : work.radius[i] * reach.growth;
      const float all = own + largest + reach.skin;
      grid.for_each_run(work.at[2 * i], work.at[2 * i + 1], all, [&](std::uint32_t begin, std::uint32_t end) {
        if (work.alike())
          collect(work, i, begin, end, all, 0, kMostContacts, contacts[lane]);
        else
          collect(work, i, begin, end, own + reach.skin, reach.growth, kMostContacts, contacts[lane]);
      });
      keep_nearest(contacts[lane], kMostContacts);
      out.gap[b] = std::min(out.gap[b], gap_of(work, contacts[lane], i, reach));
      if (reach.far) far_candidates(work, grid, reach, i, far[lane]);
    }
    append_rows(contacts, first, contact_rows, b);
    append_rows(far, first, far_rows, b);
  }
  for (const auto& [from, to] : {std::pair{&contact_rows, &out.contacts}, std::pair{&far_rows, &out.far}})
    to->items.assign(from->items.begin(), from->items.end()), to->first = from->first;
}

}  // namespace inhabit::crowd::pbd_model::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::crowd::pbd_model {

HWY_EXPORT(find_neighbours);
void find_neighbours(Work& work, const Grid& grid, const Reach& reach, std::size_t chunk) {
  HWY_DYNAMIC_DISPATCH(find_neighbours)(work, grid, reach, chunk);
}

void find_walls(Work& work, const Walls& walls, const Reach& reach, std::size_t chunk) {
  std::vector<NearWall>& out = work.chunks[chunk].walls;
  out.clear();
  if (walls.empty()) return;
  const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, work.count);
  for (std::size_t i = begin; i < end; ++i) {
    const float x = work.at[2 * i], y = work.at[2 * i + 1];
    const float near = ((work.alike() ? work.common_radius : work.radius[i])) + reach.skin;
    walls.for_each_near(x, y, [&](const WallSegment& s, std::uint32_t k) {
      if ((s.bx - s.ax) * (y - s.ay) - (s.by - s.ay) * (x - s.ax) < 0) return;  // seen from behind
      const WallPoint p = nearest_point(s, x, y);
      if ((x - p.x) * (x - p.x) + (y - p.y) * (y - p.y) >= near * near) return;
      out.push_back({static_cast<std::uint32_t>(i), k});
      work.chunks[chunk].gap[(i - begin) / kLanes] = -1;
    });
  }
}

}  // namespace inhabit::crowd::pbd_model
#endif  // HWY_ONCE
