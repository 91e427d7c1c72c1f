#include "crowd/models/pbd_kernels.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "crowd/models/pbd_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "crowd/models/pbd_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace inhabit::crowd::pbd_model::HWY_NAMESPACE {
/// A pair's geometry: n points from the neighbour to the agent, depth > 0 where the discs overlap.
struct Contact {
  M touching;
  Pair d, n;  ///< the way from the neighbour to the agent, and its direction
  V depth;
};

/// Whether two touch of whom the first is d away from the second.
HWY_INLINE M touch(const Work& work, const Self& self, VI other, Pair d, float growth) {
  const V reach = reach_of(work, self, other, growth);
  return hn::AndNot(hn::RebindMask(kD, hn::Eq(self.index, other)), hn::Lt(dot(d, d), hn::Mul(reach, reach)));
}

/// Contact of agents `self` at xi with `other` among `places`. Coincident agents are pushed apart along x, the lower
/// index to the left. [thesis eq. 4.2]
HWY_INLINE Contact contact(const Work& work, const Self& self, VI other, Pair xi, const FloatArray& places,
                           float growth) {
  const Pair d = xi - gather(places, other);
  const V d2 = dot(d, d), reach = reach_of(work, self, other, growth);
  Contact c;
  c.d = d;
  c.touching = touch(work, self, other, d, growth);
  if (hn::AllFalse(kD, c.touching)) return c;
  const M coincident = hn::Lt(d2, set(kCoincident));
  const V inverse = inverse_root(hn::IfThenElse(coincident, set(1), d2));
  const V side = hn::IfThenElse(hn::RebindMask(kD, hn::Lt(self.index, other)), set(-1), set(1));
  c.n = chosen(coincident, {side, hn::Zero(kD)}, scaled(inverse, d));
  c.depth = hn::Sub(reach, hn::Mul(d2, inverse));
  return c;
}

/// The factor on the sum of so many contacts' corrections: the average, over-relaxed. One contact alone is never
/// over-relaxed: the two would bounce.
HWY_INLINE V relaxed(const Constants& k, V touches) {
  const V most = hn::Max(touches, set(1));
  return hn::Div(hn::Min(set(k.over_relaxation), most), most);
}

/// Calls f(first agent, its and the others' indices, their rows, the number of rows) for every vector of a chunk, or of
/// its busy blocks alone.
enum class Which { all, busy };
template <Which which, class F>
HWY_INLINE void for_each_vector(const Work& work, const NeighbourRows& rows, std::size_t chunk, F&& f) {
  const std::size_t lanes = hn::Lanes(kD);
  const Chunk& c = work.chunks[chunk];
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    if (which == Which::busy && !c.busy[b]) continue;
    const std::size_t first = chunk * kChunk + b * kLanes;
    for (std::size_t lane = 0; lane < kLanes; lane += lanes) {
      const VI self = count_from(first + lane);
      f(first + lane, self, rows.items.data() + rows.first[b] * kLanes + lane, rows.first[b + 1] - rows.first[b]);
    }
  }
}

/// Calls f(first agent) for every vector of a chunk's blocks that are busy, or of those that are not.
template <class F>
HWY_INLINE void for_each_vector_of(const Work& work, std::size_t chunk, bool busy, F&& f) {
  const Chunk& c = work.chunks[chunk];
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    if ((c.busy[b] != 0) != busy) continue;
    const std::size_t first = chunk * kChunk + b * kLanes;
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kD)) f(first + lane);
  }
}

/// Adds those of a block's rows that come within `stride` of the grown discs to the rows of `near`: each agent's own
/// one below the other, so that there are as many rows as the one with the most has.
HWY_INLINE std::uint32_t keep_near(const Work& work, const Constants& k, std::size_t first, const std::int32_t* rows,
                                   std::uint32_t count, float stride, IndexArray& near) {
  const std::size_t begin = near.size();
  std::array<std::uint32_t, kLanes> kept{};
  std::uint32_t most = 0;
  for (std::uint32_t r = 0; r < count; ++r) {
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kD)) {
      const VI index = count_from(first + lane);
      const VI other = hn::Load(kDI, rows + r * kLanes + lane);
      const Pair d = load(work.at, first + lane) - gather(work.at, other);
      const V reach = hn::Add(reach_of(work, self_at(work, index, first + lane), other, k.growth), set(stride));
      const M mask = hn::AndNot(hn::RebindMask(kD, hn::Eq(index, other)), hn::Lt(dot(d, d), hn::Mul(reach, reach)));
      std::array<std::uint8_t, 8> bytes{};
      hn::StoreMaskBits(kD, mask, bytes.data());
      for (std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8; bits != 0; bits &= bits - 1) {
        const std::size_t l = lane + static_cast<std::size_t>(std::countr_zero(bits));
        if (kept[l] == most) {
          const std::size_t row = begin + most * kLanes;
          near.resize(row + kLanes);
          for (std::size_t own = 0; own < kLanes; ++own) near[row + own] = static_cast<std::int32_t>(first + own);
          ++most;
        }
        near[begin + kept[l]++ * kLanes + l] = rows[r * kLanes + l];
      }
    }
  }
  return most;
}

void narrow(Work& work, const Constants& k, std::size_t chunk) {
  Chunk& c = work.chunks[chunk];
  c.near.items.clear();
  c.near.first[0] = 0;
  c.busy_count = 0;
  const float stride = 2 * k.stride, far = 2 * (k.moved + k.stride);
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    const std::int32_t* rows = c.contacts.items.data() + c.contacts.first[b] * kLanes;
    const std::uint32_t count = c.contacts.first[b + 1] - c.contacts.first[b];
    const std::uint32_t kept =
        c.gap[b] <= far ? keep_near(work, k, chunk * kChunk + b * kLanes, rows, count, stride, c.near.items) : 0;
    c.near.first[b + 1] = c.near.first[b] + kept;
    c.busy[b] = kept > 0 || c.gap[b] < 0;
    c.busy_count += c.busy[b];
  }
}

void glide(Work& work, const Constants& k, std::size_t chunk) {
  for_each_vector_of(work, chunk, false, [&](std::size_t i) {
    const Pair base = load(work.at, i), wish = load(work.wish, i);
    const V longest = hn::Load(kD, work.maximum_speed.data() + i);
    Pair v = load(work.v, i), moved = zero();
    for (int part = 0; part < k.parts; ++part) {
      v = shortened(blended(k, v, wish), longest);
      moved = moved + scaled(set(k.part), v);
    }
    const Pair to = base + moved;
    store(v, work.v, i);
    store(to, work.at, i), store(to, work.next, i), store(to, work.predicted, i), store(to, work.corrected, i);
  });
}

void stabilise(Work& work, const Constants& k, std::size_t chunk) {
  for_each_vector<Which::busy>(work, work.chunks[chunk].near, chunk,
                               [&](std::size_t i, VI index, const std::int32_t* items, std::uint32_t rows) {
                                 const Pair xi = load(work.at, i);
                                 const Self self = self_at(work, index, i);
                                 Pair sum = zero();
                                 V touches = hn::Zero(kD);
                                 for (std::uint32_t r = 0; r < rows; ++r) {
                                   const VI other = hn::Load(kDI, items + r * kLanes);
                                   const Contact c = contact(work, self, other, xi, work.at, 1);
                                   if (hn::AllFalse(kD, c.touching)) continue;
                                   const V push = hn::Mul(share_of(work, self, other), c.depth);
                                   sum = sum + kept(c.touching, scaled(push, c.n));
                                   touches = hn::Add(touches, hn::IfThenElseZero(c.touching, set(1)));
                                 }
                                 const V factor = relaxed(k, touches);
                                 store(xi + scaled(factor, sum), work.corrected, i);
                               });
}

void settle(Work& work, const Constants&, std::size_t chunk) {
  V most = hn::Zero(kD);
  for_each_vector_of(work, chunk, true, [&](std::size_t i) {
    const Pair to = load(work.corrected, i), way = to - load(work.at, i);
    most = hn::Max(most, dot(way, way));
    store(to, work.at, i);
  });
  work.chunks[chunk].thrown = hn::GetLane(hn::Sqrt(hn::MaxOfLanes(kD, most)));
}

void predict(Work& work, const Constants& k, std::size_t chunk) {
  for_each_vector_of(work, chunk, true, [&](std::size_t i) {
    const Pair at = load(work.at, i);
    store(at, work.base, i), store(zero(), work.moved, i);
    store(at + scaled(set(k.part), blended(k, load(work.v, i), load(work.wish, i))), work.predicted, i);
  });
}

/// What friction takes of a contact's correction: the tangential part of how the two have moved against each other
/// [Macklin14, friction].
HWY_INLINE Pair rubbed(const Constants& k, const Contact& c, Pair u) {
  const Pair t = u - scaled(dot(u, c.n), c.n);
  const V square = hn::Max(dot(t, t), set(1e-24f)), still = hn::Mul(set(k.static_friction), c.depth);
  const V kinetic = hn::Min(hn::Mul(hn::Mul(set(k.kinetic_friction), c.depth), inverse_root(square)), set(1));
  return scaled(hn::IfThenElse(hn::Lt(square, hn::Mul(still, still)), set(1), kinetic), t);
}

/// What one contact asks of an agent; nothing where the mask is false.
HWY_INLINE Pair push_of(const Work& work, const Constants& k, const Self& self, VI other, const Contact& c, Pair at,
                        Pair other_at) {
  Pair push = scaled(c.depth, c.n);
  if (k.static_friction > 0 || k.kinetic_friction > 0) push = push - rubbed(k, c, c.d - (at - other_at));
  return kept(c.touching, scaled(share_of(work, self, other), push));
}

/// Sums of pushes and numbers of contacts of a chunk's agents.
struct Sums {
  alignas(64) std::array<float, kChunk> x{}, y{}, touches{};
};

/// Contacts row by row: best where most of a row touch.
HWY_INLINE void add_by_rows(const Work& work, const Constants& k, std::size_t chunk, Sums& sums) {
  for_each_vector<Which::busy>(work, work.chunks[chunk].near, chunk,
                               [&](std::size_t i, VI index, const std::int32_t* items, std::uint32_t rows) {
                                 const Pair xi = load(work.predicted, i), at = load(work.at, i);
                                 const Self self = self_at(work, index, i);
                                 Pair sum = zero();
                                 V touches = hn::Zero(kD);
                                 for (std::uint32_t r = 0; r < rows; ++r) {
                                   const VI other = hn::Load(kDI, items + r * kLanes);
                                   const Contact c = contact(work, self, other, xi, work.predicted, k.growth);
                                   if (hn::AllFalse(kD, c.touching)) continue;
                                   sum = sum + push_of(work, k, self, other, c, at, gather(work.at, other));
                                   touches = hn::Add(touches, hn::IfThenElseZero(c.touching, set(1)));
                                 }
                                 const std::size_t local = i - chunk * kChunk;
                                 hn::Store(sum.x, kD, sums.x.data() + local),
                                     hn::Store(sum.y, kD, sums.y.data() + local);
                                 hn::Store(touches, kD, sums.touches.data() + local);
                               });
}

/// Pairs that touch, of agents and others, in order of blocks and rows.
struct Queue {
  static constexpr std::size_t kRoom = 1024;
  alignas(64) std::array<std::int32_t, kRoom + kLanes> agent, other;
  std::size_t count = 0;
};

/// Adds what the queue's contacts ask for and empties it: every lane has work to do.
HWY_INLINE void add_queue(const Work& work, const Constants& k, std::size_t chunk, Queue& queue, Sums& sums) {
  const std::size_t begin = chunk * kChunk, lanes = hn::Lanes(kD);
  // The last vector is filled up with somebody who touches himself, which is nothing.
  for (std::size_t e = queue.count; e < queue.count + lanes; ++e)
    queue.agent[e] = queue.other[e] = static_cast<std::int32_t>(begin);
  alignas(64) std::array<float, kLanes> x, y;
  for (std::size_t e = 0; e < queue.count; e += lanes) {
    const VI index = hn::Load(kDI, queue.agent.data() + e), other = hn::Load(kDI, queue.other.data() + e);
    const Self self = selves(work, index);
    const Contact c = contact(work, self, other, gather(work.predicted, index), work.predicted, k.growth);
    const Pair push = push_of(work, k, self, other, c, gather(work.at, index), gather(work.at, other));
    hn::Store(push.x, kD, x.data()), hn::Store(push.y, kD, y.data());
    for (std::size_t l = 0; l < std::min(lanes, queue.count - e); ++l) {
      const std::size_t local = static_cast<std::size_t>(queue.agent[e + l]) - begin;
      sums.x[local] += x[l], sums.y[local] += y[l], sums.touches[local] += 1;
    }
  }
  queue.count = 0;
}

/// The same sums in the same order, but first it is only asked who touches: best where few do.
HWY_INLINE void add_by_pairs(const Work& work, const Constants& k, std::size_t chunk, Sums& sums) {
  Queue queue;
  for_each_vector<Which::busy>(work, work.chunks[chunk].near, chunk,
                               [&](std::size_t i, VI index, const std::int32_t* items, std::uint32_t rows) {
                                 const Pair xi = load(work.predicted, i);
                                 const Self self = self_at(work, index, i);
                                 for (std::uint32_t r = 0; r < rows; ++r) {
                                   const VI other = hn::Load(kDI, items + r * kLanes);
                                   const M touching =
                                       touch(work, self, other, xi - gather(work.predicted, other), k.growth);
                                   if (hn::AllFalse(kD, touching)) continue;
                                   const auto mask = hn::RebindMask(kDI, touching);
                                   hn::CompressStore(index, mask, kDI, queue.agent.data() + queue.count);
                                   queue.count += hn::CompressStore(other, mask, kDI, queue.other.data() + queue.count);
                                   if (queue.count > Queue::kRoom - kLanes) add_queue(work, k, chunk, queue, sums);
                                 }
                               });
  add_queue(work, k, chunk, queue, sums);
}

void project(Work& work, const Constants& k, std::size_t chunk) {
  Chunk& c = work.chunks[chunk];
  Sums sums;
  if (c.crowded)
    add_by_rows(work, k, chunk, sums);
  else
    add_by_pairs(work, k, chunk, sums);
  V all = hn::Zero(kD);
  for_each_vector_of(work, chunk, true, [&](std::size_t i) {
    const std::size_t local = i - chunk * kChunk;
    const V touches = hn::Load(kD, sums.touches.data() + local);
    Pair place = load(work.predicted, i);
    if (!hn::AllTrue(kD, hn::Eq(touches, hn::Zero(kD)))) {
      all = hn::Add(all, touches);
      const Pair sum = {hn::Load(kD, sums.x.data() + local), hn::Load(kD, sums.y.data() + local)};
      place = place + scaled(relaxed(k, touches), sum);
    }
    store(place, work.corrected, i);
  });
  // Both ways give the same bits, so that it does not matter when they change.
  const float rows = static_cast<float>(c.near.first[work.blocks_of(chunk)]);
  c.crowded = hn::GetLane(hn::SumOfLanes(kD, all)) > kCrowded * rows * static_cast<float>(kLanes);
}

/// What is left of the velocity that a contact gives to somebody who had another: of what pushes, beyond bringing to
/// rest, the share `lost` goes.
HWY_INLINE Pair damped(V lost, Pair before, Pair after) {
  const Pair change = after - before;
  const V square = hn::Max(dot(change, change), set(1e-12f));
  const V pushed = hn::Min(hn::Max(dot(after, change), hn::Zero(kD)), square);
  return after - scaled(hn::Div(hn::Mul(lost, pushed), square), change);
}

void finish(Work& work, const Constants& k, std::size_t chunk) {
  const V part = set(k.part), lost = set(1 - rebound(k.part));
  for_each_vector_of(work, chunk, true, [&](std::size_t i) {
    const Pair wish = load(work.wish, i), wanted = blended(k, load(work.v, i), wish);
    // The blended velocity plus what was corrected: the difference of positions alone would lose it to rounding far
    // from the origin.
    const Pair begun = load(work.at, i) + scaled(part, wanted);
    const Pair thrown = shortened(wanted + scaled(set(k.inverse_part), load(work.corrected, i) - begun),
                                  hn::Load(kD, work.maximum_speed.data() + i));
    const Pair moved = load(work.moved, i) + scaled(part, thrown), v = damped(lost, wanted, thrown);
    const Pair to = load(work.base, i) + moved;
    store(v, work.v, i), store(moved, work.moved, i), store(to, work.next, i);
    store(to + scaled(part, blended(k, v, wish)), work.corrected, i);
  });
}

void cohere(Work& work, const Constants& k, std::size_t chunk) {
  for_each_vector<Which::all>(
      work, work.chunks[chunk].far, chunk, [&](std::size_t i, VI index, const std::int32_t* items, std::uint32_t rows) {
        const Pair xi = load(work.at, i), v = load(work.v, i);
        const V range = hn::Mul(set(k.cohesion_range), self_at(work, index, i).radius);
        const V range2 = hn::Mul(range, range);
        Pair sum = zero();
        V weights = hn::Zero(kD);
        for (std::uint32_t r = 0; r < rows; ++r) {
          const VI other = hn::Load(kDI, items + r * kLanes);
          const Pair d = gather(work.at, other) - xi;
          const V rest = hn::Max(hn::Sub(range2, dot(d, d)), hn::Zero(kD));
          const V weight =
              hn::IfThenZeroElse(hn::RebindMask(kD, hn::Eq(index, other)), hn::Mul(hn::Mul(rest, rest), rest));
          sum = sum + scaled(weight, gather(work.v, other) - v);
          weights = hn::Add(weights, weight);
        }
        store(v + scaled(hn::Div(set(k.cohesion), hn::Max(weights, set(1e-12f))), sum), work.next, i);
      });
}

void intend(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk, end = begin + work.blocks_of(chunk) * kLanes;
  for (std::size_t i = begin; i < end; i += hn::Lanes(kD))
    store(blended(k, load(work.v, i), load(work.wish, i)), work.corrected, i);
}

void foresee(Work& work, const Constants& k, std::size_t chunk) {
  const V dt = set(k.dt), inverse_dt = set(1 / k.dt);
  for_each_vector<Which::all>(
      work, work.chunks[chunk].far, chunk, [&](std::size_t i, VI index, const std::int32_t* items, std::uint32_t rows) {
        const Pair xi = load(work.at, i), intended = load(work.corrected, i);
        const Self self = self_at(work, index, i);
        Pair sum = zero();
        V pairs = hn::Zero(kD);
        for (std::uint32_t r = 0; r < rows; ++r) {
          const VI other = hn::Load(kDI, items + r * kLanes);
          const Pair d = xi - gather(work.at, other);
          Pair u = intended - gather(work.corrected, other);
          const V reach = reach_of(work, self, other, k.growth);
          const V c = hn::Sub(dot(d, d), hn::Mul(reach, reach));
          // Contacts are no collisions to come, but two who press against each other slide past by the same push: else
          // friction would hold them for ever. They stand, so that only their wishes say where they would go; and they
          // stand just where `reach` ends, so that rounding must not say whether they touch.
          M apart = hn::Or(hn::Gt(c, hn::Mul(set(kTouching), hn::Mul(reach, reach))),
                           hn::RebindMask(kD, hn::Eq(index, other)));
          if (!hn::AllTrue(kD, apart)) {
            const Pair mine = load(work.wish, i), theirs = gather(work.wish, other);
            apart = hn::Or(apart, hn::And(hn::Gt(c, hn::Zero(kD)), hn::Ge(dot(mine, theirs), hn::Zero(kD))));
            u = chosen(apart, u, mine - theirs);
          }
          // tau = (b - sqrt(b b - a c)) / a [thesis eq. 4.4 to 4.7, with relative displacements].
          const V a = dot(u, u), b = hn::Neg(dot(d, u));
          const V under = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
          M valid = hn::And(hn::And(hn::Gt(b, hn::Zero(kD)), hn::Gt(under, hn::Zero(kD))), hn::Gt(a, set(1e-6f)));
          if (hn::AllFalse(kD, valid)) continue;
          const V tau = hn::Max(hn::Div(hn::Sub(b, hn::Sqrt(hn::Max(under, hn::Zero(kD)))), hn::Max(a, set(1e-6f))),
                                hn::Zero(kD));
          valid = hn::And(valid, hn::Lt(tau, set(k.far_horizon)));
          if (hn::AllFalse(kD, valid)) continue;
          const V delay = hn::Floor(hn::Mul(hn::IfThenElseZero(valid, tau), inverse_dt));
          const V stiffness = hn::GatherIndex(kD, k.stiffness_of_delay, hn::ConvertTo(kDI, delay));
          const Pair then = d + scaled(hn::Mul(hn::Add(delay, set(1)), dt), u);
          const V square = hn::Max(dot(then, then), set(1e-12f)), inverse = inverse_root(square);
          const Pair n = scaled(inverse, then);
          // What slides past; of a head-on pair a nudge, so that each passes on its right [eq. 4.11 to 4.13].
          const Pair t = u - scaled(dot(u, n), n);
          const M head_on = hn::Lt(dot(t, t), hn::Mul(set(1e-4f), a));
          const V nudge = hn::Mul(hn::IfThenElse(apart, set(0.01f), set(0.1f)), hn::Sqrt(a));
          const Pair past = {hn::Neg(hn::Mul(n.y, nudge)), hn::Mul(n.x, nudge)};
          Pair push;
          if (k.far == 1) {  // the future contact itself, as a displacement of this step [4.2.4]
            const V depth = hn::IfThenElseZero(apart, hn::Max(hn::Sub(reach, hn::Mul(square, inverse)), hn::Zero(kD)));
            push = scaled(depth, n) + kept(hn::Or(head_on, hn::Not(apart)), scaled(dt, chosen(head_on, past, t)));
          } else {  // across the way that the two are on: along it they would only meet sooner and faster
            const Pair across = t - scaled(hn::Div(dot(t, u), hn::Max(a, set(1e-6f))), u);
            push = scaled(dt, chosen(head_on, past, chosen(apart, across, t)));
          }
          const V weight = hn::IfThenElseZero(valid, hn::Mul(share_of(work, self, other), stiffness));
          sum = sum + scaled(weight, push);
          pairs = hn::Add(pairs, hn::IfThenElseZero(valid, set(1)));
        }
        const V factor = hn::Div(set(kFarRelaxation / k.dt), hn::Max(pairs, set(1)));
        store(load(work.v, i) + shortened(scaled(factor, sum), set(k.velocity_change)), work.v, i);
      });
}

}  // namespace inhabit::crowd::pbd_model::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::crowd::pbd_model {

HWY_EXPORT(cohere);
HWY_EXPORT(intend);
HWY_EXPORT(foresee);
HWY_EXPORT(narrow);
HWY_EXPORT(glide);
HWY_EXPORT(stabilise);
HWY_EXPORT(settle);
HWY_EXPORT(predict);
HWY_EXPORT(project);
HWY_EXPORT(finish);

void cohere(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(cohere)(work, k, chunk); }
void intend(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(intend)(work, k, chunk); }
void foresee(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(foresee)(work, k, chunk); }
void narrow(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(narrow)(work, k, chunk); }
void glide(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(glide)(work, k, chunk); }
void stabilise(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(stabilise)(work, k, chunk); }
void settle(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(settle)(work, k, chunk); }
void predict(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(predict)(work, k, chunk); }
void project(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(project)(work, k, chunk); }
void finish(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(finish)(work, k, chunk); }

}  // namespace inhabit::crowd::pbd_model
#endif  // HWY_ONCE
