#include "layout/jams.h"

#include <algorithm>

namespace inhabit::layout {
namespace {

/// Metres. What was parted overlaps by rounding errors ever after, and what is feasible may do so by 700 of these.
constexpr double kTouching = 1e-6;

}  // namespace

void Jams::reset(const State& x) {
  contacts_.refresh(x);
  pairs_ = contacts_.pairs(), listed_at_ = contacts_.built_at();
  first_.assign(p_.data.boxes.size() + 2, 0);
  for (const Contacts::Pair& pair : pairs_) ++first_[pair.a + 2], ++first_[pair.b + 2];
  for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
  pairs_of_.resize(2 * pairs_.size());
  // Filling moves every box's first to its last, which is the next one's first: hence the one place more.
  for (std::uint32_t i = 0; i < pairs_.size(); ++i)
    pairs_of_[first_[pairs_[i].a + 1]++] = i, pairs_of_[first_[pairs_[i].b + 1]++] = i;
  more_of_.clear(), strays_.clear();
  overlapping_ = core::IndexSet(pairs_.size(), true);
  outside_ = core::IndexSet(p_.data.bodies.size(), true);
  moved_ = core::IndexSet(p_.data.bodies.size(), false);
  stray_ = core::IndexSet(p_.data.boxes.size(), false);
}

template <class F>
void Jams::for_each_pair_of(std::uint32_t box, F&& f) const {
  for (std::uint32_t k = first_[box]; k < first_[box + 1]; ++k) f(pairs_of_[k]);
  if (more_of_.empty()) return;
  const auto more = more_of_.find(box);
  if (more != more_of_.end()) std::ranges::for_each(more->second, f);
}

void Jams::note(std::uint32_t body) {
  outside_.insert(body), moved_.insert(body);
  const BodyData& d = p_.data.bodies[body];
  for (std::uint32_t k = d.first_box; k < d.first_box + d.boxes; ++k)
    for_each_pair_of(k, [&](std::uint32_t i) { overlapping_.insert(i); });
}

/// As Contacts does it, but nothing is moved in memory: old pairs die, new ones come last.
void Jams::relist(const State& x, std::uint32_t box) {
  const auto& boxes = p_.data.boxes;
  for_each_pair_of(box, [&](std::uint32_t i) { pairs_[i].reach_square = 0; });
  if (!stray_.contains(box)) strays_.push_back(box), stray_.insert(box);
  listed_at_[box] = x.boxes[box].center;
  const auto consider = [&](std::uint32_t other) {
    const double reach = boxes[box].radius + boxes[other].radius + contacts_.margin();
    const Vec2 d = listed_at_[box] - listed_at_[other];
    if (other == box || dot(d, d) >= reach * reach || !p_.collide(box, other)) return;
    const auto i = static_cast<std::uint32_t>(pairs_.size());
    pairs_.push_back(contacts_.pair_of(std::min(box, other), std::max(box, other)));
    more_of_[box].push_back(i), more_of_[other].push_back(i);
    overlapping_.grow(pairs_.size());
    overlapping_.insert(i);
  };
  if (!p_.collisions) return;
  contacts_.visit_boxes(listed_at_[box], boxes[box].radius, [&](std::uint32_t other) {
    if (!stray_.contains(other)) consider(other);
  });
  for (const std::uint32_t other : strays_) consider(other);
}

void Jams::sweep(State& x) {
  Noting sink{x, *this};
  overlapping_.for_each([&](std::uint32_t i) {
    overlapping_.erase(i);
    if (contacts_.project_pair(x, pairs_[i], 1, sink, kTouching)) overlapping_.insert(i);
  });
  outside_.for_each([&](std::uint32_t body) {
    outside_.erase(body);
    const BodyData& d = p_.data.bodies[body];
    if (!p_.boundary || d.w <= 0) return;
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) {
      p_.room.for_each_violation(x.boxes[i], [&](Vec2 n, double depth) {
        if (depth > kTouching) sink.shift(Anchor{body}, depth * n);
      });
    }
  });
}

void Jams::score(const State& x, Score& s, double& squares) {
  outside_.for_each([&](std::uint32_t body) { score_boundary(p_, x, body, s, squares); });
  moved_.for_each([&](std::uint32_t body) {
    moved_.erase(body);
    const BodyData& d = p_.data.bodies[body];
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes && !listed_at_.empty(); ++i) {
      if (contacts_.strayed(x, i, listed_at_[i])) relist(x, i);
    }
  });
  overlapping_.for_each([&](std::uint32_t i) { contacts_.score_pair(x, pairs_[i], s, squares); });
}

}  // namespace inhabit::layout
