#pragma once
#include "layout/problem.h"

namespace inhabit::layout {

/// How two boxes overlap: the separating-axis test (`box`), or the papers' bounding circles, tested only where the
/// boxes intersect (`sphere`).
///
///   C = |p_i - p_j| - (r_i + r_j) >= 0                              [TVCG eq. 15]
///
/// Deviation: `box` is the default and C its minimum translation, negated: circles keep a long bookcase half its length
/// from everything.
inline Separation contact(const Problem& p, const State& x, std::uint32_t i, std::uint32_t j) {
  const Box &a = x.boxes[i], &b = x.boxes[j];
  Separation s = separation(a, b);
  if (s.depth > 0 && (p.data.boxes[i].sphere & p.data.boxes[j].sphere) != 0) {
    const Vec2 d = a.center - b.center;
    const double l = length(d);
    s = {l > 1e-9 ? (1 / l) * d : s.normal, p.data.boxes[i].radius + p.data.boxes[j].radius - l};
  }
  return s;
}

}  // namespace inhabit::layout
