#include <algorithm>

#include "layout/contacts.h"

namespace inhabit::layout {
namespace {

/// Takes from the sorted `list` what is `gone` and puts what is `fresh` where it belongs.
template <class Pair, class F>
void replace(std::vector<Pair>& list, std::vector<Pair>& fresh, F gone) {
  const auto by_both = [](const Pair& a, const Pair& b) { return std::pair{a.a, a.b} < std::pair{b.a, b.b}; };
  const auto same = [](const Pair& a, const Pair& b) { return a.a == b.a && a.b == b.b; };
  std::ranges::sort(fresh, by_both);
  fresh.erase(std::unique(fresh.begin(), fresh.end(), same), fresh.end());
  std::vector<Pair> result;
  result.reserve(list.size() + fresh.size());
  auto next = fresh.begin();
  for (const Pair& pair : list) {
    while (next != fresh.end() && next->a < pair.a) result.push_back(*next++);
    if (!gone(pair)) result.push_back(pair);
  }
  result.insert(result.end(), next, fresh.end());
  list = std::move(result);
}

}  // namespace

/// Distances are between the places at which pairs were listed, from which nobody is farther than half of the margin.
void Contacts::relist(const State& x, std::span<const std::uint32_t> strays) {
  const auto& boxes = p_.data.boxes;
  core::IndexSet stray(boxes.size(), false), owner(p_.data.bodies.size(), false);
  for (const std::uint32_t s : strays) {
    stray.insert(s), owner.insert(boxes[s].body);
    built_at_[s] = x.boxes[s].center;
    if (outcast_.contains(s) || boxes[s].radius > small_radius_) continue;
    outcasts_.push_back(s), outcast_.insert(s);
  }
  const auto within = [&](Vec2 at, std::uint32_t i, double reach) {
    const Vec2 d = at - built_at_[i];
    return dot(d, d) < reach * reach;
  };
  std::vector<Pair> fresh;
  for (const std::uint32_t s : strays) {
    if (!p_.collisions) break;
    const double reach = boxes[s].radius + margin_;
    visit_boxes(built_at_[s], boxes[s].radius, [&](std::uint32_t i) {
      if (i != s && within(built_at_[s], i, reach + boxes[i].radius) && p_.collide(i, s))
        fresh.push_back(pair_of(std::min(i, s), std::max(i, s)));
    });
  }
  replace(pairs_, fresh, [&](const Pair& pair) { return stray.contains(pair.a) || stray.contains(pair.b); });

  fresh.clear();
  const auto rides = [&](std::uint32_t z) { return p_.zones[z].owner && owner.contains(p_.zones[z].owner->body); };
  const auto consider = [&](std::uint32_t z, std::uint32_t i, double margin) {
    const auto& on = p_.zones[z].owner;
    const Vec2 at = on ? x.bodies[on->body].p : p_.zones[z].box.center;
    if (within(at, i, zone_reach_[z] + boxes[i].radius + margin) && p_.zone_concerns(z, i))
      fresh.push_back(zone_pair_of(z, i));
  };
  for (const std::uint32_t s : strays) {
    for (const std::uint32_t z : p_.zones_of_body[boxes[s].body]) {
      visit_boxes(x.bodies[boxes[s].body].p, zone_reach_[z], [&](std::uint32_t i) { consider(z, i, margin_); });
    }
    // Where another's zone was when its pairs were listed is half a margin from where it is.
    const double margin = 1.5 * margin_;
    visit_boxes(built_at_[s], small_zone_reach_ + boxes[s].radius + margin, [&](std::uint32_t i) {
      for (const std::uint32_t z : p_.zones_of_body[boxes[i].body]) {
        if (!rides(z)) consider(z, s, margin);
      }
    });
    for (const std::uint32_t z : wide_zones_) {
      if (!rides(z)) consider(z, s, margin);
    }
  }
  replace(zone_pairs_, fresh, [&](const Pair& pair) { return stray.contains(pair.b) || rides(pair.a); });
}

}  // namespace inhabit::layout
