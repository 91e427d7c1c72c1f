#include "layout/jams.h"

#include <algorithm>

namespace inhabit::layout {
namespace {

/// Metres. What was parted overlaps by rounding errors ever after, and what is feasible may do so by 700 of these.
constexpr double kTouching = 1e-6;

}  // namespace

void Jams::list_pairs() {
  const auto& pairs = contacts_.pairs();
  first_.assign(p_.data.boxes.size() + 2, 0);
  for (const Contacts::Pair& pair : pairs) ++first_[pair.a + 2], ++first_[pair.b + 2];
  for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
  pairs_of_.resize(2 * pairs.size());
  // Filling moves every box's first to its last, which is the next one's first: hence the one place more.
  for (std::uint32_t i = 0; i < pairs.size(); ++i)
    pairs_of_[first_[pairs[i].a + 1]++] = i, pairs_of_[first_[pairs[i].b + 1]++] = i;
  pairs_ = core::IndexSet(pairs.size(), true);
}

void Jams::reset(const State& x) {
  contacts_.refresh(x);
  list_pairs();
  bodies_ = core::IndexSet(p_.data.bodies.size(), true);
  moved_ = core::IndexSet(p_.data.bodies.size(), false);
}

void Jams::note(std::uint32_t body) {
  bodies_.insert(body), moved_.insert(body);
  const BodyData& d = p_.data.bodies[body];
  for (std::uint32_t k = first_[d.first_box]; k < first_[d.first_box + d.boxes]; ++k) pairs_.insert(pairs_of_[k]);
}

void Jams::sweep(State& x) {
  Noting sink{x, *this};
  pairs_.for_each([&](std::uint32_t i) {
    pairs_.erase(i);
    if (contacts_.project_pair(x, contacts_.pairs()[i], 1, sink, kTouching)) pairs_.insert(i);
  });
  bodies_.for_each([&](std::uint32_t body) {
    bodies_.erase(body);
    const BodyData& d = p_.data.bodies[body];
    if (!p_.boundary || d.w <= 0) return;
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i)
      p_.room.for_each_violation(x.boxes[i], [&](Vec2 n, double depth) {
        if (depth > kTouching) sink.shift(Anchor{body}, depth * n);
      });
  });
}

void Jams::score(const State& x, Score& s, double& squares) {
  bodies_.for_each([&](std::uint32_t body) { score_boundary(p_, x, body, s, squares); });
  bool stray = false;
  moved_.for_each([&](std::uint32_t body) {
    moved_.erase(body);
    const BodyData& d = p_.data.bodies[body];
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) stray = stray || contacts_.strayed(x, i);
  });
  if (stray) {
    contacts_.refresh(x);
    list_pairs();
  }
  pairs_.for_each([&](std::uint32_t i) { contacts_.score_pair(x, contacts_.pairs()[i], s, squares); });
}

}  // namespace inhabit::layout
