#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace inhabit::layout {
using namespace scene;

/// Who belongs to whom, by object indices: what carries what, who is excused from colliding, who may stand in whose
/// clearance. A relation with a group is one with each of its members, and theirs.
class Relations {
 public:
  explicit Relations(const Scene& scene);

  /// `upper` stands on `lower`, directly or on something that does (`on`, stacking).
  bool carried(std::uint32_t upper, std::uint32_t lower) const;
  /// Bound by a distance, focal_distance, stacking or orientation constraint, by `on`, or by a common rigid group.
  bool bound(std::uint32_t a, std::uint32_t b) const;
  /// Both are in one rigid group, however deep.
  bool rigid_mates(std::uint32_t a, std::uint32_t b) const;
  /// It cannot move: fixed, locked in place, or in one rigid group with something that is.
  bool pinned(std::uint32_t object) const { return pinned_[object]; }
  /// A `collision` constraint with mode off names both, or nobody.
  bool collision_off(std::uint32_t a, std::uint32_t b) const;
  /// Number of pairs of objects for which collision_off holds.
  std::uint64_t pairs_off() const;

 private:
  using Key = std::uint64_t;  ///< a Ref as a number
  using Pairs = std::vector<std::pair<Key, Key>>;

  void collect_groups(const Scene& scene);
  void collect_pinned(const Scene& scene);
  void collect_pairs(const Scene& scene);
  void collect_off(const Scene& scene);
  /// The object itself and every group that it is in.
  std::span<const Key> selves(std::uint32_t object) const {
    return {selves_.data() + first_self_[object], selves_.data() + first_self_[object + 1]};
  }

  Pairs parents_;   ///< (member, group), sorted
  Pairs members_;   ///< (group, member), sorted
  Pairs carriers_;  ///< (upper, lower), sorted
  Pairs bonds_;     ///< (smaller key, larger key), sorted
  std::vector<bool> rigid_, pinned_;
  std::vector<Key> selves_;
  std::vector<std::size_t> first_self_;
  bool all_off_ = false;
  std::vector<std::vector<std::uint32_t>> off_sets_;  ///< per object: the constraints that take it out, ascending
};

}  // namespace inhabit::layout
