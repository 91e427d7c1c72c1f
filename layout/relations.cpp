#include "layout/relations.h"

#include <algorithm>
#include <map>

namespace inhabit::layout {
namespace {

std::uint64_t key(Ref ref) { return (static_cast<std::uint64_t>(ref.kind) << 32) | ref.index; }
std::uint64_t object_key(std::uint32_t object) { return key({Ref::Kind::object, object}); }
std::uint32_t index_of(std::uint64_t k) { return static_cast<std::uint32_t>(k); }
bool is_group(std::uint64_t k) { return static_cast<Ref::Kind>(k >> 32) == Ref::Kind::group; }

constexpr Choice kOff = 2;  // Collision::mode

template <class F>
void for_each_ref(const Members& members, F&& f) {
  for (const Ref ref : members.list) f(ref);
  if (!members.all_of.none()) f(members.all_of);
}

/// Calls f(second) for every pair of the sorted list that starts with `first`.
template <class Pairs, class F>
void for_each_second(const Pairs& pairs, std::uint64_t first, F&& f) {
  for (auto it = std::ranges::lower_bound(pairs, std::pair<std::uint64_t, std::uint64_t>{first, 0});
       it != pairs.end() && it->first == first; ++it)
    f(it->second);
}

/// The keys and all that the pairs lead to from them, each once.
template <class Pairs>
std::vector<std::uint64_t> closure(std::vector<std::uint64_t> keys, const Pairs& pairs) {
  for (std::size_t i = 0; i < keys.size(); ++i)
    for_each_second(pairs, keys[i], [&](std::uint64_t next) {
      if (std::ranges::find(keys, next) == keys.end()) keys.push_back(next);
    });
  return keys;
}

}  // namespace

Relations::Relations(const Scene& scene) {
  collect_groups(scene);
  collect_pinned(scene);
  collect_pairs(scene);
  collect_off(scene);
}

void Relations::collect_groups(const Scene& scene) {
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
    rigid_.push_back(scene.groups[g].rigid);
    for (const Ref member : scene.groups[g].members) parents_.emplace_back(key(member), key({Ref::Kind::group, g}));
  }
  for (const auto& [member, group] : parents_) members_.emplace_back(group, member);
  std::ranges::sort(parents_);
  std::ranges::sort(members_);
  first_self_.push_back(0);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    for (const Key k : closure({object_key(i)}, parents_)) selves_.push_back(k);
    first_self_.push_back(selves_.size());
  }
}

void Relations::collect_pinned(const Scene& scene) {
  std::vector<bool> held(scene.groups.size());
  const auto for_each_rigid = [&](std::uint32_t object, auto&& f) {
    for (const Key k : selves(object))
      if (is_group(k) && rigid_[index_of(k)]) f(index_of(k));
  };
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const Object& o = scene.objects[i];
    pinned_.push_back(o.fixed || o.lock == Lock::position || o.lock == Lock::both);
    if (o.fixed || o.lock != Lock::none) for_each_rigid(i, [&](std::uint32_t g) { held[g] = true; });
  }
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    for_each_rigid(i, [&](std::uint32_t g) { pinned_[i] = pinned_[i] || held[g]; });
}

void Relations::collect_pairs(const Scene& scene) {
  const auto bind = [&](Ref a, Ref b) {
    if (!a.none() && !b.none()) bonds_.emplace_back(std::minmax(key(a), key(b)));
  };
  for (const Distance& c : scene.constraints.of<Distance>()) bind(c.between[0], c.between[1]);
  for (const FocalDistance& c : scene.constraints.of<FocalDistance>())
    for_each_ref(c.members, [&](Ref member) { bind(c.focal, member); });
  for (const Orientation& c : scene.constraints.of<Orientation>())
    for_each_ref(c.members, [&](Ref member) { bind(c.to, member); });
  const auto carry = [&](Ref upper, Ref lower) {
    if (upper.none() || lower.none()) return;
    carriers_.emplace_back(key(upper), key(lower));
    bind(upper, lower);
  };
  for (const Stacking& c : scene.constraints.of<Stacking>()) carry(c.object, c.on);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) carry({Ref::Kind::object, i}, scene.objects[i].on);
  std::ranges::sort(carriers_);
  std::ranges::sort(bonds_);
}

void Relations::collect_off(const Scene& scene) {
  std::vector<std::pair<Key, std::uint32_t>> named;
  std::uint32_t set = 0;
  for (const Collision& c : scene.constraints.of<Collision>()) {
    if (c.mode != kOff) continue;
    if (c.members.empty()) all_off_ = true;
    for_each_ref(c.members, [&](Ref ref) { named.emplace_back(key(ref), set); });
    ++set;
  }
  std::ranges::sort(named);
  off_sets_.resize(scene.objects.size());
  if (named.empty()) return;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    auto& sets = off_sets_[i];
    for (const Key k : selves(i)) {
      for (auto it = std::ranges::lower_bound(named, std::pair<Key, std::uint32_t>{k, 0});
           it != named.end() && it->first == k; ++it)
        sets.push_back(it->second);
    }
    std::ranges::sort(sets);
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());  // clang 14 cannot read ranges::unique
  }
}

bool Relations::carried(std::uint32_t upper, std::uint32_t lower) const {
  if (carriers_.empty()) return false;
  const auto targets = selves(lower);
  const auto from = selves(upper);
  std::vector<Key> open(from.begin(), from.end());
  for (std::size_t i = 0; i < open.size(); ++i) {
    bool found = false;
    std::vector<Key> below;
    for_each_second(carriers_, open[i], [&](Key k) {
      found = found || std::ranges::find(targets, k) != targets.end();
      below.push_back(k);
    });
    if (found) return true;
    // What carries a group carries its members, and what stands on a group stands on what carries one of them.
    for (const Key k : closure(closure(std::move(below), members_), parents_))
      if (std::ranges::find(open, k) == open.end()) open.push_back(k);
  }
  return false;
}

bool Relations::rigid_mates(std::uint32_t a, std::uint32_t b) const {
  const auto others = selves(b);
  return std::ranges::any_of(selves(a), [&](Key k) {
    return is_group(k) && rigid_[index_of(k)] && std::ranges::find(others, k) != others.end();
  });
}

bool Relations::bound(std::uint32_t a, std::uint32_t b) const {
  if (rigid_mates(a, b)) return true;
  for (const Key ka : selves(a))
    for (const Key kb : selves(b))
      if (std::ranges::binary_search(bonds_, std::pair<Key, Key>(std::minmax(ka, kb)))) return true;
  return false;
}

bool Relations::collision_off(std::uint32_t a, std::uint32_t b) const {
  if (all_off_) return true;
  const auto &x = off_sets_[a], &y = off_sets_[b];
  for (std::size_t i = 0, j = 0; i < x.size() && j < y.size();) {
    if (x[i] == y[j]) return true;
    (x[i] < y[j] ? i : j)++;
  }
  return false;
}

std::uint64_t Relations::pairs_off() const {
  const std::uint64_t n = off_sets_.size();
  if (all_off_) return n < 2 ? 0 : n * (n - 1) / 2;
  // Objects in the same constraints are alike, so that only the kinds of objects are compared.
  std::map<std::vector<std::uint32_t>, std::pair<std::uint64_t, std::uint32_t>> kinds;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (off_sets_[i].empty()) continue;
    auto& [count, example] = kinds[off_sets_[i]];
    ++count, example = i;
  }
  std::uint64_t pairs = 0;
  for (auto a = kinds.begin(); a != kinds.end(); ++a) {
    pairs += a->second.first * (a->second.first - 1) / 2;
    for (auto b = std::next(a); b != kinds.end(); ++b)
      if (collision_off(a->second.second, b->second.second)) pairs += a->second.first * b->second.first;
  }
  return pairs;
}

}  // namespace inhabit::layout
