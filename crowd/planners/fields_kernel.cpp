#include "crowd/planners/fields_kernel.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "crowd/planners/fields_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace inhabit::crowd::fields_kernel::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;

HWY_ATTR HWY_INLINE V low(VI d) { return hn::ConvertTo(D(), hn::ShiftRight<16>(hn::ShiftLeft<16>(d))); }
HWY_ATTR HWY_INLINE V high(VI d) { return hn::ConvertTo(D(), hn::ShiftRight<16>(d)); }

/// Whole vectors from begin on; returns where the rest begins.
HWY_ATTR std::size_t look_up_lanes(const Lookup& l, std::size_t begin, std::size_t end) {
  const D d;
  const DI di;
  const std::size_t lanes = hn::Lanes(d);
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  const auto* const direction = reinterpret_cast<const std::int32_t*>(l.direction);
  const VI columns = hn::Set(di, l.columns), next = hn::Set(di, 1), none = hn::Set(di, -1);
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes) {
    const VI field = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(l.field + i));
    const auto skip = hn::Eq(field, none);
    if (hn::AllTrue(di, skip)) continue;
    const V u = hn::Min(
        hn::Max(
            hn::Sub(hn::Mul(hn::Sub(hn::LoadU(d, l.x + i), hn::Set(d, l.origin_x)), hn::Set(d, l.inverse_cell)), half),
            zero),
        hn::Set(d, l.last_column));
    const V v = hn::Min(
        hn::Max(
            hn::Sub(hn::Mul(hn::Sub(hn::LoadU(d, l.y + i), hn::Set(d, l.origin_y)), hn::Set(d, l.inverse_cell)), half),
            zero),
        hn::Set(d, l.last_row));
    const VI column = hn::ConvertTo(di, u), row = hn::ConvertTo(di, v);
    const V a = hn::Sub(u, hn::ConvertTo(d, column)), b = hn::Sub(v, hn::ConvertTo(d, row));
    const VI base = hn::IfThenElseZero(hn::Not(skip), hn::Mul(field, hn::Set(di, l.cells)));
    const VI k = hn::Add(hn::Add(base, hn::Mul(row, columns)), column);
    const VI d00 = hn::GatherIndex(di, direction, k);
    const VI d10 = hn::GatherIndex(di, direction, hn::Add(k, next));
    const VI d01 = hn::GatherIndex(di, direction, hn::Add(k, columns));
    const VI d11 = hn::GatherIndex(di, direction, hn::Add(hn::Add(k, columns), next));
    const V a1 = hn::Sub(one, a), b1 = hn::Sub(one, b);
    const V w00 = hn::Mul(a1, b1), w10 = hn::Mul(a, b1), w01 = hn::Mul(a1, b), w11 = hn::Mul(a, b);
    V gx = hn::Add(hn::Add(hn::Add(hn::Mul(w00, low(d00)), hn::Mul(w10, low(d10))), hn::Mul(w01, low(d01))),
                   hn::Mul(w11, low(d11)));
    V gy = hn::Add(hn::Add(hn::Add(hn::Mul(w00, high(d00)), hn::Mul(w10, high(d10))), hn::Mul(w01, high(d01))),
                   hn::Mul(w11, high(d11)));
    V square = hn::Add(hn::Mul(gx, gx), hn::Mul(gy, gy));
    const auto right = hn::RebindMask(di, hn::Ge(a, half)), upper = hn::RebindMask(di, hn::Ge(b, half));
    const VI own = hn::IfThenElse(upper, hn::IfThenElse(right, d11, d01), hn::IfThenElse(right, d10, d00));
    const auto alone = hn::And(hn::Lt(square, hn::Set(d, kCancelled)), hn::RebindMask(d, hn::Ne(own, hn::Zero(di))));
    gx = hn::IfThenElse(alone, low(own), gx), gy = hn::IfThenElse(alone, high(own), gy);
    square = hn::Add(hn::Mul(gx, gx), hn::Mul(gy, gy));
    const V scale = hn::IfThenElseZero(hn::Gt(square, zero), hn::Div(hn::LoadU(d, l.speed + i), hn::Sqrt(square)));
    const auto keep = hn::RebindMask(d, skip);
    hn::StoreU(hn::IfThenElse(keep, hn::LoadU(d, l.wish_x + i), hn::Mul(scale, gx)), d, l.wish_x + i);
    hn::StoreU(hn::IfThenElse(keep, hn::LoadU(d, l.wish_y + i), hn::Mul(scale, gy)), d, l.wish_y + i);
  }
  return i;
}

}  // namespace inhabit::crowd::fields_kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::crowd::fields_kernel {

HWY_EXPORT(look_up_lanes);

void look_up(const Lookup& lookup, std::size_t begin, std::size_t end) {
  look_up_scalar(lookup, HWY_DYNAMIC_DISPATCH(look_up_lanes)(lookup, begin, end), end);
}

void look_up_scalar(const Lookup& l, std::size_t begin, std::size_t end) {
  const auto low = [](std::uint32_t d) { return static_cast<float>(static_cast<std::int16_t>(d & 0xffff)); };
  const auto high = [](std::uint32_t d) { return static_cast<float>(static_cast<std::int32_t>(d) >> 16); };
  for (std::size_t i = begin; i < end; ++i) {
    if (l.field[i] == 0xffffffffu) continue;
    // NaN becomes 0, as it does in the lanes.
    float u = (l.x[i] - l.origin_x) * l.inverse_cell - 0.5f, v = (l.y[i] - l.origin_y) * l.inverse_cell - 0.5f;
    u = u > 0 ? std::min(u, l.last_column) : 0.0f, v = v > 0 ? std::min(v, l.last_row) : 0.0f;
    const auto column = static_cast<std::int32_t>(u), row = static_cast<std::int32_t>(v);
    const float a = u - static_cast<float>(column), b = v - static_cast<float>(row);
    const auto field = static_cast<std::int32_t>(l.field[i]);
    const std::uint32_t* const d = l.direction + (field * l.cells + row * l.columns + column);
    const std::uint32_t d00 = d[0], d10 = d[1], d01 = d[l.columns], d11 = d[l.columns + 1];
    const float w00 = (1 - a) * (1 - b), w10 = a * (1 - b), w01 = (1 - a) * b, w11 = a * b;
    float gx = w00 * low(d00) + w10 * low(d10) + w01 * low(d01) + w11 * low(d11);
    float gy = w00 * high(d00) + w10 * high(d10) + w01 * high(d01) + w11 * high(d11);
    float square = gx * gx + gy * gy;
    if (square < kCancelled) {
      // Cells of the goal itself have no direction: at its border the others lead in.
      const std::uint32_t own = b >= 0.5f ? (a >= 0.5f ? d11 : d01) : (a >= 0.5f ? d10 : d00);
      if (own != 0) gx = low(own), gy = high(own), square = gx * gx + gy * gy;
    }
    const float scale = square > 0 ? l.speed[i] / std::sqrt(square) : 0.0f;
    l.wish_x[i] = scale * gx, l.wish_y[i] = scale * gy;
  }
}

}  // namespace inhabit::crowd::fields_kernel
#endif
