// No #pragma once: Highway reads this once for every instruction set, within the file that its inner loops stand in.
#if defined(INHABIT_PBD_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef INHABIT_PBD_VECTORS_INL_H
#undef INHABIT_PBD_VECTORS_INL_H
#else
#define INHABIT_PBD_VECTORS_INL_H
#endif

#include <hwy/highway.h>

#include "crowd/models/pbd_work.h"

HWY_BEFORE_NAMESPACE();
namespace inhabit::crowd::pbd_model::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = HWY_CAPPED(float, kLanes);
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;

constexpr D kD;
constexpr DI kDI;

HWY_INLINE V set(float value) { return hn::Set(kD, value); }
/// first, first + 1, …
HWY_INLINE VI count_from(std::size_t first) {
  return hn::Add(hn::Set(kDI, static_cast<std::int32_t>(first)), hn::Iota(kDI, 0));
}

struct Pair {
  V x, y;
};
HWY_INLINE Pair operator+(Pair a, Pair b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)}; }
HWY_INLINE Pair operator-(Pair a, Pair b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)}; }
HWY_INLINE Pair scaled(V s, Pair a) { return {hn::Mul(s, a.x), hn::Mul(s, a.y)}; }
HWY_INLINE V dot(Pair a, Pair b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)); }
HWY_INLINE Pair zero() { return {hn::Zero(kD), hn::Zero(kD)}; }
HWY_INLINE Pair kept(M mask, Pair a) { return {hn::IfThenElseZero(mask, a.x), hn::IfThenElseZero(mask, a.y)}; }
HWY_INLINE Pair chosen(M mask, Pair a, Pair b) {
  return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y)};
}

/// The pairs of the agents i, i + 1, …
HWY_INLINE Pair load(const FloatArray& pairs, std::size_t i) {
  const V low = hn::LoadU(kD, pairs.data() + 2 * i), high = hn::LoadU(kD, pairs.data() + 2 * i + hn::Lanes(kD));
#if HWY_TARGET == HWY_SCALAR
  return {low, high};
#else
  return {hn::ConcatEven(kD, high, low), hn::ConcatOdd(kD, high, low)};
#endif
}
HWY_INLINE void store(Pair a, FloatArray& pairs, std::size_t i) {
  hn::StoreInterleaved2(a.x, a.y, kD, pairs.data() + 2 * i);
}
/// The pairs of those agents.
HWY_INLINE Pair gather(const FloatArray& pairs, VI index) {
#if HWY_TARGET <= HWY_AVX2
  // Half as many looks at memory as for x and y on their own.
  const hn::Repartition<double, D> doubles;
  const hn::RebindToSigned<decltype(doubles)> longs;
  const auto* both = reinterpret_cast<const double*>(pairs.data());
  const auto first = hn::PromoteTo(longs, hn::LowerHalf(index));
  const auto second = hn::PromoteTo(longs, hn::UpperHalf(hn::Half<DI>(), index));
  const V low = hn::BitCast(kD, hn::GatherIndex(doubles, both, first));
  const V high = hn::BitCast(kD, hn::GatherIndex(doubles, both, second));
  return {hn::ConcatEven(kD, high, low), hn::ConcatOdd(kD, high, low)};
#else
  const VI twice = hn::ShiftLeft<1>(index);
  return {hn::GatherIndex(kD, pairs.data(), twice), hn::GatherIndex(kD, pairs.data() + 1, twice)};
#endif
}

/// 1 / sqrt(a) to 5e-6 of it, for a > 0: two of Newton's steps from a first guess in the bits. Roots and quotients of
/// the processor take three times as long, and its own quick guess differs from one to the next.
HWY_INLINE V inverse_root(V a) {
  const VI guess = hn::Sub(hn::Set(kDI, 0x5f375a86), hn::ShiftRight<1>(hn::BitCast(kDI, a)));
  const V half = hn::Mul(set(0.5f), a);
  V y = hn::BitCast(kD, guess);
  y = hn::Mul(y, hn::Sub(set(1.5f), hn::Mul(half, hn::Mul(y, y))));
  return hn::Mul(y, hn::Sub(set(1.5f), hn::Mul(half, hn::Mul(y, y))));
}

/// Shortened to a length of at most `longest`.
HWY_INLINE Pair shortened(Pair a, V longest) {
  const V square = dot(a, a);
  const M over = hn::Gt(square, hn::Mul(longest, longest));
  if (hn::AllFalse(kD, over)) return a;
  return scaled(hn::IfThenElse(over, hn::Div(longest, hn::Sqrt(square)), set(1)), a);
}

HWY_INLINE Pair blended(const Constants& k, Pair v, Pair wish) {
  return scaled(set(1 - k.blend), v) + scaled(set(k.blend), wish);
}

/// What an agent is beside its place.
struct Self {
  VI index;
  V radius, mass;  ///< only when not everybody is alike
};
HWY_INLINE Self self_at(const Work& work, VI index, std::size_t i) {
  if (work.alike()) return {index, set(work.common_radius), set(1)};
  return {index, hn::Load(kD, work.radius.data() + i), hn::Load(kD, work.mass.data() + i)};
}
HWY_INLINE Self selves(const Work& work, VI index) {
  if (work.alike()) return {index, set(work.common_radius), set(1)};
  return {index, hn::GatherIndex(kD, work.radius.data(), index), hn::GatherIndex(kD, work.mass.data(), index)};
}
/// (r_i + r_j) * growth.
HWY_INLINE V reach_of(const Work& work, const Self& self, VI other, float growth) {
  if (work.alike()) return set(2 * work.common_radius * growth);
  return hn::Mul(hn::Add(self.radius, hn::GatherIndex(kD, work.radius.data(), other)), set(growth));
}
/// w_i / (w_i + w_j) with w = 1 / m.
HWY_INLINE V share_of(const Work& work, const Self& self, VI other) {
  if (work.alike()) return set(0.5f);
  const V mass = hn::GatherIndex(kD, work.mass.data(), other);
  return hn::Div(mass, hn::Add(self.mass, mass));
}

}  // namespace inhabit::crowd::pbd_model::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
