#include <algorithm>

#include "core/parallel.h"
#include "layout/check_parts.h"

namespace inhabit::layout {
namespace {

struct Pair {
  std::uint32_t a = 0, b = 0;
  double depth = 0;
};

bool deeper(const Pair& x, const Pair& y) {
  if (x.depth != y.depth) return x.depth > y.depth;
  return std::pair(x.a, x.b) < std::pair(y.a, y.b);
}

void keep_deepest(std::vector<Pair>& pairs) {
  if (pairs.size() <= kMostOverlaps) return;
  std::nth_element(pairs.begin(), pairs.begin() + kMostOverlaps, pairs.end(), deeper);
  pairs.resize(kMostOverlaps);
}

}  // namespace

OverlapFindings find_overlaps(const Solids& solids, bool all_collisions) {
  OverlapFindings found;
  std::vector<Pair> pairs;
  solids.grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Solid &a = solids.list[i], &b = solids.list[j];
    if (!a.shares_height(b.base, b.top)) return;
    const double depth = separation(a.box, b.box).depth;
    if (depth <= kFeasibleDepth) return;
    if (solids.relations.carried(a.object, b.object) || solids.relations.carried(b.object, a.object)) return;
    const bool off = solids.relations.collision_off(a.object, b.object);
    const bool rigid = !off && solids.relations.rigid_mates(a.object, b.object);
    const bool pinned = !off && !rigid && solids.relations.pinned(a.object) && solids.relations.pinned(b.object);
    found.exempt += off, found.rigid += rigid, found.pinned += pinned;
    if ((off || rigid || pinned) && !all_collisions) return;
    ++found.count;
    pairs.push_back({i, j, depth});
    if (pairs.size() >= 2 * kMostOverlaps) keep_deepest(pairs);
  });
  keep_deepest(pairs);
  std::ranges::sort(pairs, deeper);
  for (const Pair& p : pairs) found.list.push_back({solids.id(solids.list[p.a]), solids.id(solids.list[p.b]), p.depth});
  return found;
}

OutsideFindings find_outside(const Solids& solids, int threads) {
  std::vector<double> depth(solids.list.size());
  constexpr std::size_t kBlock = 256;
  core::parallel_for((depth.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    const std::size_t end = std::min(depth.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) depth[i] = outside_depth(solids.floor, solids.list[i].box);
  });
  OutsideFindings found;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] <= kFeasibleDepth) continue;
    if (solids.relations.pinned(solids.list[i].object)) {
      ++found.pinned;
    } else {
      found.list.push_back({solids.id(solids.list[i]), depth[i]});
    }
  }
  std::ranges::stable_sort(found.list, [](const auto& x, const auto& y) { return x.depth > y.depth; });
  return found;
}

}  // namespace inhabit::layout
