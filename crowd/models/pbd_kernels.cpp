#include "crowd/models/pbd_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "crowd/models/pbd_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

/// (x, y) shortened to a length of at most `longest`.
HWY_INLINE void shorten(V& x, V& y, V longest) {
  const V length = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
  const V factor = hn::IfThenElse(hn::Gt(length, longest), hn::Div(longest, hn::Max(length, set(1e-12f))), set(1));
  x = hn::Mul(x, factor), y = hn::Mul(y, factor);
}

/// A pair's geometry: n points from the neighbour to the agent, depth > 0 where the discs overlap.
struct Contact {
  M touching;
  V nx, ny, depth, share;
};

/// Contact of agents `self` at (xi, yi) with `other`. Coincident agents are pushed apart along x, the lower index to
/// the left. [thesis eq. 4.2]
HWY_INLINE Contact contact(const Work& work, const Constants& k, VI self, VI other, V xi, V yi, V ri, V mi,
                           const float* x, const float* y) {
  const V dx = hn::Sub(xi, hn::GatherIndex(kD, x, other)), dy = hn::Sub(yi, hn::GatherIndex(kD, y, other));
  const V d2 = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
  Contact c;
  V reach, mj = mi;
  if (work.alike()) {
    reach = set(2 * work.common_radius * k.growth);
    c.share = set(0.5f);
  } else {
    reach = hn::Mul(hn::Add(ri, hn::GatherIndex(kD, work.radius.data(), other)), set(k.growth));
    mj = hn::GatherIndex(kD, work.mass.data(), other);
  }
  c.touching = hn::AndNot(hn::RebindMask(kD, hn::Eq(self, other)), hn::Lt(d2, hn::Mul(reach, reach)));
  if (hn::AllFalse(kD, c.touching)) return c;
  if (!work.alike()) c.share = hn::Div(mj, hn::Add(mi, mj));
  const M coincident = hn::Eq(d2, hn::Zero(kD));
  const V distance = hn::Sqrt(d2);
  const V inverse = hn::Div(set(1), hn::IfThenElse(coincident, set(1), distance));
  const V side = hn::IfThenElse(hn::RebindMask(kD, hn::Lt(self, other)), set(-1), set(1));
  c.nx = hn::IfThenElse(coincident, side, hn::Mul(dx, inverse));
  c.ny = hn::Mul(dy, inverse);
  c.depth = hn::Sub(reach, distance);
  return c;
}

/// Calls f(lane offset, index of the first agent, indices of the agents) for every vector of a chunk, f's rows being
/// [first, last).
template <class F>
HWY_INLINE void for_each_vector(const Work& work, const NeighbourRows& rows, std::size_t chunk, F&& f) {
  const std::size_t lanes = hn::Lanes(kD);
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    const std::size_t first = chunk * kChunk + b * kLanes;
    for (std::size_t lane = 0; lane < kLanes; lane += lanes) {
      const VI self = hn::Add(hn::Set(kDI, static_cast<std::int32_t>(first + lane)), hn::Iota(kDI, 0));
      f(first + lane, self, rows.items.data() + rows.first[b] * kLanes + lane, rows.first[b + 1] - rows.first[b]);
    }
  }
}

void stabilise(const Work& work, const Constants& k, std::size_t chunk, float* out_x, float* out_y) {
  for_each_vector(work, work.chunks[chunk].contacts, chunk,
                  [&](std::size_t i, VI self, const std::int32_t* items, std::uint32_t rows) {
                    const V xi = hn::Load(kD, work.x.data() + i), yi = hn::Load(kD, work.y.data() + i);
                    const V ri = work.alike() ? xi : hn::Load(kD, work.radius.data() + i);
                    const V mi = work.alike() ? xi : hn::Load(kD, work.mass.data() + i);
                    V sx = hn::Zero(kD), sy = sx, touches = sx;
                    Constants exact = k;
                    exact.growth = 1;
                    for (std::uint32_t r = 0; r < rows; ++r) {
                      const VI other = hn::Load(kDI, items + r * kLanes);
                      const Contact c = contact(work, exact, self, other, xi, yi, ri, mi, work.x.data(), work.y.data());
                      if (hn::AllFalse(kD, c.touching)) continue;
                      const V push = hn::IfThenElseZero(c.touching, hn::Mul(c.share, c.depth));
                      sx = hn::Add(sx, hn::Mul(push, c.nx)), sy = hn::Add(sy, hn::Mul(push, c.ny));
                      touches = hn::Add(touches, hn::IfThenElseZero(c.touching, set(1)));
                    }
                    const V factor = hn::Div(set(k.over_relaxation), hn::Max(touches, set(1)));
                    hn::Store(hn::Add(xi, hn::Mul(sx, factor)), kD, out_x + i);
                    hn::Store(hn::Add(yi, hn::Mul(sy, factor)), kD, out_y + i);
                  });
}

void predict(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk, end = begin + work.blocks_of(chunk) * kLanes;
  const V keep = set(1 - k.blend), blend = set(k.blend), part = set(k.part);
  for (std::size_t i = begin; i < end; i += hn::Lanes(kD)) {
    const V bx =
        hn::Add(hn::Mul(keep, hn::Load(kD, work.vx.data() + i)), hn::Mul(blend, hn::Load(kD, work.wish_x.data() + i)));
    const V by =
        hn::Add(hn::Mul(keep, hn::Load(kD, work.vy.data() + i)), hn::Mul(blend, hn::Load(kD, work.wish_y.data() + i)));
    const V x = hn::Load(kD, work.x.data() + i), y = hn::Load(kD, work.y.data() + i);
    hn::Store(x, kD, work.base_x.data() + i), hn::Store(y, kD, work.base_y.data() + i);
    hn::Store(hn::Zero(kD), kD, work.moved_x.data() + i), hn::Store(hn::Zero(kD), kD, work.moved_y.data() + i);
    hn::Store(hn::Add(x, hn::Mul(part, bx)), kD, work.predicted_x.data() + i);
    hn::Store(hn::Add(y, hn::Mul(part, by)), kD, work.predicted_y.data() + i);
  }
}

void project(const Work& work, const Constants& k, std::size_t chunk, float* out_x, float* out_y) {
  const bool friction = k.static_friction > 0 || k.kinetic_friction > 0;
  for_each_vector(
      work, work.chunks[chunk].contacts, chunk,
      [&](std::size_t i, VI self, const std::int32_t* items, std::uint32_t rows) {
        const V xi = hn::Load(kD, work.predicted_x.data() + i), yi = hn::Load(kD, work.predicted_y.data() + i);
        const V ri = work.alike() ? xi : hn::Load(kD, work.radius.data() + i);
        const V mi = work.alike() ? xi : hn::Load(kD, work.mass.data() + i);
        const V moved_x = hn::Sub(xi, hn::Load(kD, work.x.data() + i));
        const V moved_y = hn::Sub(yi, hn::Load(kD, work.y.data() + i));
        V sx = hn::Zero(kD), sy = sx, touches = sx;
        for (std::uint32_t r = 0; r < rows; ++r) {
          const VI other = hn::Load(kDI, items + r * kLanes);
          const Contact c =
              contact(work, k, self, other, xi, yi, ri, mi, work.predicted_x.data(), work.predicted_y.data());
          if (hn::AllFalse(kD, c.touching)) continue;
          V px = hn::Mul(c.depth, c.nx), py = hn::Mul(c.depth, c.ny);
          if (friction) {
            // The tangential part of how the two have moved against each other [Macklin14 eq. 23, 24].
            const V ux = hn::Sub(moved_x, hn::Sub(hn::GatherIndex(kD, work.predicted_x.data(), other),
                                                  hn::GatherIndex(kD, work.x.data(), other)));
            const V uy = hn::Sub(moved_y, hn::Sub(hn::GatherIndex(kD, work.predicted_y.data(), other),
                                                  hn::GatherIndex(kD, work.y.data(), other)));
            const V un = hn::Add(hn::Mul(ux, c.nx), hn::Mul(uy, c.ny));
            const V tx = hn::Sub(ux, hn::Mul(un, c.nx)), ty = hn::Sub(uy, hn::Mul(un, c.ny));
            const V slid = hn::Sqrt(hn::Add(hn::Mul(tx, tx), hn::Mul(ty, ty)));
            const V kinetic =
                hn::Min(hn::Div(hn::Mul(set(k.kinetic_friction), c.depth), hn::Max(slid, set(1e-12f))), set(1));
            const V held = hn::IfThenElse(hn::Lt(slid, hn::Mul(set(k.static_friction), c.depth)), set(1), kinetic);
            px = hn::Sub(px, hn::Mul(held, tx)), py = hn::Sub(py, hn::Mul(held, ty));
          }
          sx = hn::Add(sx, hn::IfThenElseZero(c.touching, hn::Mul(c.share, px)));
          sy = hn::Add(sy, hn::IfThenElseZero(c.touching, hn::Mul(c.share, py)));
          touches = hn::Add(touches, hn::IfThenElseZero(c.touching, set(1)));
        }
        const V factor = hn::Div(set(k.over_relaxation), hn::Max(touches, set(1)));
        hn::Store(hn::Add(xi, hn::Mul(sx, factor)), kD, out_x + i);
        hn::Store(hn::Add(yi, hn::Mul(sy, factor)), kD, out_y + i);
      });
}

void finish(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk, end = begin + work.blocks_of(chunk) * kLanes;
  const V keep = set(1 - k.blend), blend = set(k.blend), part = set(k.part), inverse = set(k.inverse_part);
  for (std::size_t i = begin; i < end; i += hn::Lanes(kD)) {
    const V x = hn::Load(kD, work.x.data() + i), y = hn::Load(kD, work.y.data() + i);
    const V wish_x = hn::Load(kD, work.wish_x.data() + i), wish_y = hn::Load(kD, work.wish_y.data() + i);
    // The blended velocity plus what was corrected: the difference of positions alone would lose it to rounding far
    // from the origin.
    V vx = hn::Add(hn::Mul(keep, hn::Load(kD, work.vx.data() + i)), hn::Mul(blend, wish_x));
    V vy = hn::Add(hn::Mul(keep, hn::Load(kD, work.vy.data() + i)), hn::Mul(blend, wish_y));
    const V begun_x = hn::Add(x, hn::Mul(part, vx)), begun_y = hn::Add(y, hn::Mul(part, vy));
    vx = hn::Add(vx, hn::Mul(hn::Sub(hn::Load(kD, work.corrected_x.data() + i), begun_x), inverse));
    vy = hn::Add(vy, hn::Mul(hn::Sub(hn::Load(kD, work.corrected_y.data() + i), begun_y), inverse));
    shorten(vx, vy, hn::Load(kD, work.maximum_speed.data() + i));
    const V moved_x = hn::Add(hn::Load(kD, work.moved_x.data() + i), hn::Mul(part, vx));
    const V moved_y = hn::Add(hn::Load(kD, work.moved_y.data() + i), hn::Mul(part, vy));
    hn::Store(moved_x, kD, work.moved_x.data() + i), hn::Store(moved_y, kD, work.moved_y.data() + i);
    const V new_x = hn::Add(hn::Load(kD, work.base_x.data() + i), moved_x);
    const V new_y = hn::Add(hn::Load(kD, work.base_y.data() + i), moved_y);
    hn::Store(vx, kD, work.vx.data() + i), hn::Store(vy, kD, work.vy.data() + i);
    hn::Store(new_x, kD, work.next_x.data() + i), hn::Store(new_y, kD, work.next_y.data() + i);
    const V bx = hn::Add(hn::Mul(keep, vx), hn::Mul(blend, wish_x));
    const V by = hn::Add(hn::Mul(keep, vy), hn::Mul(blend, wish_y));
    hn::Store(hn::Add(new_x, hn::Mul(part, bx)), kD, work.predicted_x.data() + i);
    hn::Store(hn::Add(new_y, hn::Mul(part, by)), kD, work.predicted_y.data() + i);
  }
}

/// (r_i + r_j), not grown.
HWY_INLINE V both_radii(const Work& work, V ri, VI other) {
  if (work.alike()) return set(2 * work.common_radius);
  return hn::Add(ri, hn::GatherIndex(kD, work.radius.data(), other));
}

void heed(Work& work, const Constants& k, std::size_t chunk) {
  for_each_vector(work, work.chunks[chunk].far, chunk,
                  [&](std::size_t i, VI self, const std::int32_t* items, std::uint32_t rows) {
                    const V xi = hn::Load(kD, work.x.data() + i), yi = hn::Load(kD, work.y.data() + i);
                    const V wx = hn::Load(kD, work.wish_x.data() + i), wy = hn::Load(kD, work.wish_y.data() + i);
                    const V ri = work.alike() ? xi : hn::Load(kD, work.radius.data() + i);
                    const V speed = hn::Sqrt(hn::Add(hn::Mul(wx, wx), hn::Mul(wy, wy)));
                    const V inverse = hn::Div(set(1), hn::Max(speed, set(1e-12f)));
                    const V ex = hn::Mul(wx, inverse), ey = hn::Mul(wy, inverse);
                    V allowed = speed;
                    for (std::uint32_t r = 0; r < rows; ++r) {
                      const VI other = hn::Load(kDI, items + r * kLanes);
                      const V dx = hn::Sub(hn::GatherIndex(kD, work.x.data(), other), xi);
                      const V dy = hn::Sub(hn::GatherIndex(kD, work.y.data(), other), yi);
                      const V along = hn::Add(hn::Mul(dx, ex), hn::Mul(dy, ey));
                      const V across = hn::Sub(hn::Mul(dy, ex), hn::Mul(dx, ey));
                      const V reach = both_radii(work, ri, other);
                      const V under = hn::Sub(hn::Mul(reach, reach), hn::Mul(across, across));
                      const M ahead = hn::AndNot(hn::RebindMask(kD, hn::Eq(self, other)),
                                                 hn::And(hn::Gt(along, hn::Zero(kD)), hn::Gt(under, hn::Zero(kD))));
                      const V gap = hn::Max(hn::Sub(along, hn::Sqrt(hn::Max(under, hn::Zero(kD)))), hn::Zero(kD));
                      allowed = hn::IfThenElse(ahead, hn::Min(allowed, hn::Div(gap, set(k.headway))), allowed);
                    }
                    hn::Store(hn::Mul(ex, allowed), kD, work.wish_x.data() + i);
                    hn::Store(hn::Mul(ey, allowed), kD, work.wish_y.data() + i);
                  });
}

void cohere(const Work& work, const Constants& k, std::size_t chunk, float* out_vx, float* out_vy) {
  for_each_vector(
      work, work.chunks[chunk].far, chunk, [&](std::size_t i, VI self, const std::int32_t* items, std::uint32_t rows) {
        const V xi = hn::Load(kD, work.x.data() + i), yi = hn::Load(kD, work.y.data() + i);
        const V vx = hn::Load(kD, work.vx.data() + i), vy = hn::Load(kD, work.vy.data() + i);
        const V radius = work.alike() ? set(work.common_radius) : hn::Load(kD, work.radius.data() + i);
        const V range = hn::Mul(set(k.cohesion_range), radius);
        const V range2 = hn::Mul(range, range);
        V sx = hn::Zero(kD), sy = sx, weights = sx;
        for (std::uint32_t r = 0; r < rows; ++r) {
          const VI other = hn::Load(kDI, items + r * kLanes);
          const V dx = hn::Sub(hn::GatherIndex(kD, work.x.data(), other), xi);
          const V dy = hn::Sub(hn::GatherIndex(kD, work.y.data(), other), yi);
          const V rest = hn::Max(hn::Sub(range2, hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy))), hn::Zero(kD));
          const V weight =
              hn::IfThenZeroElse(hn::RebindMask(kD, hn::Eq(self, other)), hn::Mul(hn::Mul(rest, rest), rest));
          sx = hn::Add(sx, hn::Mul(weight, hn::Sub(hn::GatherIndex(kD, work.vx.data(), other), vx)));
          sy = hn::Add(sy, hn::Mul(weight, hn::Sub(hn::GatherIndex(kD, work.vy.data(), other), vy)));
          weights = hn::Add(weights, weight);
        }
        const V factor = hn::Div(set(k.cohesion), hn::Max(weights, set(1e-12f)));
        hn::Store(hn::Add(vx, hn::Mul(sx, factor)), kD, out_vx + i);
        hn::Store(hn::Add(vy, hn::Mul(sy, factor)), kD, out_vy + i);
      });
}

void foresee(const Work& work, const Constants& k, std::size_t chunk, float* out_vx, float* out_vy) {
  const V keep = set(1 - k.blend), blend = set(k.blend), dt = set(k.dt);
  const auto preferred = [&](V v, V wish) { return hn::Add(hn::Mul(keep, v), hn::Mul(blend, wish)); };
  for_each_vector(
      work, work.chunks[chunk].far, chunk, [&](std::size_t i, VI, const std::int32_t* items, std::uint32_t rows) {
        const V xi = hn::Load(kD, work.x.data() + i), yi = hn::Load(kD, work.y.data() + i);
        const V vxi = hn::Load(kD, work.vx.data() + i), vyi = hn::Load(kD, work.vy.data() + i);
        const V bxi = preferred(vxi, hn::Load(kD, work.wish_x.data() + i));
        const V byi = preferred(vyi, hn::Load(kD, work.wish_y.data() + i));
        const V ri = work.alike() ? xi : hn::Load(kD, work.radius.data() + i);
        const V mi = work.alike() ? xi : hn::Load(kD, work.mass.data() + i);
        V sx = hn::Zero(kD), sy = sx, pairs = sx;
        for (std::uint32_t r = 0; r < rows; ++r) {
          const VI other = hn::Load(kDI, items + r * kLanes);
          const V dx = hn::Sub(xi, hn::GatherIndex(kD, work.x.data(), other));
          const V dy = hn::Sub(yi, hn::GatherIndex(kD, work.y.data(), other));
          const V ux = hn::Sub(bxi, preferred(hn::GatherIndex(kD, work.vx.data(), other),
                                              hn::GatherIndex(kD, work.wish_x.data(), other)));
          const V uy = hn::Sub(byi, preferred(hn::GatherIndex(kD, work.vy.data(), other),
                                              hn::GatherIndex(kD, work.wish_y.data(), other)));
          V reach = set(2 * work.common_radius * k.growth), share = set(0.5f);
          if (!work.alike())
            reach = hn::Mul(hn::Add(ri, hn::GatherIndex(kD, work.radius.data(), other)), set(k.growth));
          // tau = (b - sqrt(b b - a c)) / a [thesis eq. 4.4 to 4.7, with relative displacements].
          const V a = hn::Add(hn::Mul(ux, ux), hn::Mul(uy, uy));
          const V b = hn::Neg(hn::Add(hn::Mul(dx, ux), hn::Mul(dy, uy)));
          const V c = hn::Sub(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(reach, reach));
          const V under = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
          M valid = hn::And(hn::And(hn::Gt(c, hn::Zero(kD)), hn::Gt(b, hn::Zero(kD))), hn::Gt(under, hn::Zero(kD)));
          valid = hn::And(valid, hn::Gt(a, set(1e-6f)));
          if (hn::AllFalse(kD, valid)) continue;
          const V tau = hn::Div(hn::Sub(b, hn::Sqrt(hn::Max(under, hn::Zero(kD)))), hn::Max(a, set(1e-6f)));
          valid = hn::And(valid, hn::Lt(tau, set(k.far_horizon)));
          if (hn::AllFalse(kD, valid)) continue;
          const V delay = hn::Floor(hn::Div(hn::IfThenElseZero(valid, tau), dt));
          const V stiffness = hn::GatherIndex(kD, k.stiffness_of_delay, hn::ConvertTo(kDI, delay));
          const V then = hn::Mul(hn::Add(delay, set(1)), dt);
          const V fx = hn::Add(dx, hn::Mul(then, ux)), fy = hn::Add(dy, hn::Mul(then, uy));
          const V distance = hn::Sqrt(hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)));
          const V inverse = hn::Div(set(1), hn::Max(distance, set(1e-6f)));
          const V nx = hn::Mul(fx, inverse), ny = hn::Mul(fy, inverse);
          if (!work.alike()) {
            const V mj = hn::GatherIndex(kD, work.mass.data(), other);
            share = hn::Div(mj, hn::Add(mi, mj));
          }
          // What slides past; of a head-on pair a nudge, so that each passes on its right [eq. 4.11 to 4.13].
          const V un = hn::Add(hn::Mul(ux, nx), hn::Mul(uy, ny));
          V tx = hn::Sub(ux, hn::Mul(un, nx)), ty = hn::Sub(uy, hn::Mul(un, ny));
          const M head_on = hn::Lt(hn::Add(hn::Mul(tx, tx), hn::Mul(ty, ty)), hn::Mul(set(1e-4f), a));
          const V nudge = hn::Mul(set(0.01f), hn::Sqrt(a));
          tx = hn::Mul(dt, hn::IfThenElse(head_on, hn::Neg(hn::Mul(ny, nudge)), tx));
          ty = hn::Mul(dt, hn::IfThenElse(head_on, hn::Mul(nx, nudge), ty));
          V px = tx, py = ty;
          if (k.far == 1) {  // the future contact itself, as a displacement of this step [4.2.4]
            const V depth = hn::Max(hn::Sub(reach, distance), hn::Zero(kD));
            px = hn::Add(hn::Mul(depth, nx), hn::IfThenElseZero(head_on, tx));
            py = hn::Add(hn::Mul(depth, ny), hn::IfThenElseZero(head_on, ty));
          }
          const V weight = hn::IfThenElseZero(valid, hn::Mul(share, stiffness));
          sx = hn::Add(sx, hn::Mul(weight, px)), sy = hn::Add(sy, hn::Mul(weight, py));
          pairs = hn::Add(pairs, hn::IfThenElseZero(valid, set(1)));
        }
        const V factor = hn::Div(set(k.over_relaxation / k.dt), hn::Max(pairs, set(1)));
        sx = hn::Mul(sx, factor), sy = hn::Mul(sy, factor);
        shorten(sx, sy, set(k.velocity_change));
        hn::Store(hn::Add(vxi, sx), kD, out_vx + i);
        hn::Store(hn::Add(vyi, sy), kD, out_vy + i);
      });
}

}  // namespace inhabit::crowd::pbd_model::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::crowd::pbd_model {

HWY_EXPORT(stabilise);
HWY_EXPORT(predict);
HWY_EXPORT(project);
HWY_EXPORT(finish);
HWY_EXPORT(foresee);
HWY_EXPORT(heed);
HWY_EXPORT(cohere);

void stabilise(const Work& work, const Constants& k, std::size_t chunk, float* x, float* y) {
  HWY_DYNAMIC_DISPATCH(stabilise)(work, k, chunk, x, y);
}
void predict(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(predict)(work, k, chunk); }
void project(const Work& work, const Constants& k, std::size_t chunk, float* x, float* y) {
  HWY_DYNAMIC_DISPATCH(project)(work, k, chunk, x, y);
}
void finish(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(finish)(work, k, chunk); }
void heed(Work& work, const Constants& k, std::size_t chunk) { HWY_DYNAMIC_DISPATCH(heed)(work, k, chunk); }
void cohere(const Work& work, const Constants& k, std::size_t chunk, float* vx, float* vy) {
  HWY_DYNAMIC_DISPATCH(cohere)(work, k, chunk, vx, vy);
}
void foresee(const Work& work, const Constants& k, std::size_t chunk, float* vx, float* vy) {
  HWY_DYNAMIC_DISPATCH(foresee)(work, k, chunk, vx, vy);
}

}  // namespace inhabit::crowd::pbd_model
#endif  // HWY_ONCE
