#include "crowd/models/pbd_heed.h"

#include <cmath>

#include "core/angle.h"
#include "core/rng.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "crowd/models/pbd_heed.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "crowd/models/pbd_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace inhabit::crowd::pbd_model::HWY_NAMESPACE {
/// A vector of agents and their neighbours, row by row.
struct Walkers {
  std::size_t first;
  VI self;
  const std::int32_t* items;
  std::uint32_t rows;
};

/// p(e) and q(e).
struct Paces {
  V allowed, clear;
};
HWY_INLINE Paces paces_along(const HeedWork& work, const HeedConstants& k, const Walkers& w, V ex, V ey) {
  const V xi = hn::Load(kD, work.x.data() + w.first), yi = hn::Load(kD, work.y.data() + w.first);
  const V ri = hn::Load(kD, work.radius.data() + w.first);
  const V wx = hn::Load(kD, work.ex.data() + w.first), wy = hn::Load(kD, work.ey.data() + w.first);
  V allowed = hn::Load(kD, work.speed.data() + w.first), clear = allowed;
  const V press = hn::Mul(set(kPress), allowed);
  for (std::uint32_t r = 0; r < w.rows; ++r) {
    const VI other = hn::Load(kDI, w.items + r * kLanes);
    const V dx = hn::Sub(hn::GatherIndex(kD, work.x.data(), other), xi);
    const V dy = hn::Sub(hn::GatherIndex(kD, work.y.data(), other), yi);
    const V along = hn::Add(hn::Mul(dx, ex), hn::Mul(dy, ey));
    const V across = hn::Mul(hn::Sub(hn::Mul(dy, ex), hn::Mul(dx, ey)), set(k.slimness));
    const V reach = hn::Add(hn::Add(ri, hn::GatherIndex(kD, work.radius.data(), other)), set(k.length));
    const V under = hn::Sub(hn::Mul(reach, reach), hn::Mul(across, across));
    const auto met = hn::AndNot(hn::RebindMask(kD, hn::Eq(w.self, other)),
                                hn::And(hn::Gt(along, hn::Zero(kD)), hn::Gt(under, hn::Zero(kD))));
    if (hn::AllFalse(kD, met)) continue;
    const V ox = hn::GatherIndex(kD, work.ex.data(), other), oy = hn::GatherIndex(kD, work.ey.data(), other);
    const V theirs = hn::Add(hn::Mul(dx, ox), hn::Mul(dy, oy));
    const auto ahead = hn::And(met, hn::Gt(hn::Add(along, theirs), hn::Zero(kD)));
    const auto oncoming = hn::And(met, hn::Lt(hn::Add(hn::Mul(wx, ox), hn::Mul(wy, oy)), hn::Zero(kD)));
    const V gap = hn::Max(hn::Sub(along, hn::Sqrt(hn::Max(under, hn::Zero(kD)))), hn::Zero(kD));
    const V closing = hn::Div(gap, set(k.headway));
    const V leader = hn::Mul(set(k.anticipation), hn::GatherIndex(kD, work.pace.data(), other));
    allowed = hn::IfThenElse(ahead, hn::Min(allowed, hn::Add(closing, leader)), allowed);
    clear = hn::IfThenElse(oncoming, hn::Min(clear, hn::Max(closing, press)), clear);
  }
  return {allowed, hn::Min(allowed, clear)};
}

void heed(HeedWork& work, const HeedConstants& k, const NeighbourRows& rows, std::size_t chunk) {
  const std::size_t lanes = hn::Lanes(kD), blocks = (work.count + kLanes - 1) / kLanes;
  const std::size_t begin = chunk * kBlocksPerChunk, end = std::min(begin + kBlocksPerChunk, blocks);
  for (std::size_t b = begin; b < end; ++b)
    for (std::size_t lane = 0; lane < kLanes; lane += lanes) {
      const std::size_t i = b * kLanes + lane, at = b - begin;
      const VI self = hn::Add(hn::Set(kDI, static_cast<std::int32_t>(i)), hn::Iota(kDI, 0));
      const Walkers w{i, self, rows.items.data() + rows.first[at] * kLanes + lane, rows.first[at + 1] - rows.first[at]};
      const V ex = hn::Load(kD, work.ex.data() + i), ey = hn::Load(kD, work.ey.data() + i);
      const Paces straight = paces_along(work, k, w, ex, ey);
      const V press = hn::Mul(set(kPress), hn::Load(kD, work.speed.data() + i));
      V pace = straight.allowed, best = straight.clear, best_x = ex, best_y = ey;
      for (std::size_t t = 0; t < k.turns; ++t) {
        const V c = set(k.turn_cos[t]), s = set(k.turn_sin[t]);
        const V tx = hn::Sub(hn::Mul(c, ex), hn::Mul(s, ey)), ty = hn::Add(hn::Mul(s, ex), hn::Mul(c, ey));
        const Paces turned = paces_along(work, k, w, tx, ty);
        const V room = hn::Load(kD, (k.turn_sin[t] > 0 ? work.left : work.right).data() + i);
        const V barred = hn::Max(hn::Div(room, set(k.headway * std::abs(k.turn_sin[t]))), press);
        const V near = hn::IfThenElse(hn::Lt(room, set(kRoom)), hn::Min(turned.clear, barred), turned.clear);
        const V gain = hn::Mul(c, near);
        const auto better = hn::Gt(gain, best);
        best = hn::IfThenElse(better, gain, best), pace = hn::IfThenElse(better, turned.allowed, pace);
        best_x = hn::IfThenElse(better, tx, best_x), best_y = hn::IfThenElse(better, ty, best_y);
      }
      hn::Store(hn::Mul(pace, best_x), kD, work.wish_x.data() + i);
      hn::Store(hn::Mul(pace, best_y), kD, work.wish_y.data() + i);
    }
}

}  // namespace inhabit::crowd::pbd_model::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::crowd::pbd_model {

HWY_EXPORT(heed);
void heed(HeedWork& work, const HeedConstants& k, const NeighbourRows& rows, std::size_t chunk) {
  HWY_DYNAMIC_DISPATCH(heed)(work, k, rows, chunk);
}

HeedConstants heed_constants(const scene::PbdModel& p) {
  HeedConstants k;
  k.headway = static_cast<float>(p.headway), k.length = static_cast<float>(p.headway_length);
  k.slimness = static_cast<float>(1 / p.headway_breadth), k.anticipation = static_cast<float>(p.anticipation);
  if (p.sidestep <= 0) return k;
  for (const double share : {-1.0 / 3, 1.0 / 3, -2.0 / 3, 2.0 / 3, -1.0, 1.0}) {
    const double turn = share * radians(p.sidestep);
    k.turn_cos[k.turns] = static_cast<float>(std::cos(turn)), k.turn_sin[k.turns] = static_cast<float>(std::sin(turn));
    ++k.turns;
  }
  return k;
}

void take(HeedWork& work, const Agents& agents) {
  work.count = agents.size();
  const std::size_t room = (work.count + kLanes - 1) / kLanes * kLanes + kLanes;
  for (FloatArray* array : {&work.x, &work.y, &work.vx, &work.vy, &work.pace, &work.radius, &work.ex, &work.ey,
                            &work.speed, &work.wish_x, &work.wish_y})
    array->resize(room, 0.0f);
  work.left.assign(room, kRoom), work.right.assign(room, kRoom);
  for (std::size_t i = 0; i < work.count; ++i) {
    work.x[i] = agents.x[i], work.y[i] = agents.y[i], work.vx[i] = agents.vx[i], work.vy[i] = agents.vy[i];
    work.radius[i] = agents.radius[i];
    work.pace[i] = std::sqrt(agents.vx[i] * agents.vx[i] + agents.vy[i] * agents.vy[i]);
    const float x = agents.wish_x[i], y = agents.wish_y[i], speed = std::sqrt(x * x + y * y);
    const float inverse = 1 / std::max(speed, 1e-12f);
    work.speed[i] = speed, work.ex[i] = x * inverse, work.ey[i] = y * inverse;
  }
}

void find_room(HeedWork& work, const Walls& walls, const std::vector<NearWall>& near) {
  for (const NearWall& wall : near) {
    const std::size_t i = wall.agent;
    const WallPoint p = nearest_point(walls.segments()[wall.segment], work.x[i], work.y[i]);
    const float dx = p.x - work.x[i], dy = p.y - work.y[i], distance = std::sqrt(dx * dx + dy * dy);
    const float beside = work.ex[i] * dy - work.ey[i] * dx;  // to the left
    if (!(std::abs(beside) > 0.5f * distance)) continue;
    float& room = beside > 0 ? work.left[i] : work.right[i];
    room = std::min(room, std::max(distance - work.radius[i], 0.0f));
  }
}

void hesitate(HeedWork& work, const Agents& agents, double share, double time, std::size_t chunk) {
  constexpr double kMoment = 0.5, kGolden = 0.6180339887498949;  // seconds; turns that spread the moments
  const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, work.count);
  for (std::size_t i = begin; i < end; ++i) {
    const float x = work.wish_x[i], y = work.wish_y[i];
    if (!(x * work.vx[i] + y * work.vy[i] < 0.3f * (x * x + y * y))) continue;
    const double moment = time / kMoment + kGolden * agents.id[i];
    core::Rng rng(agents.id[i], static_cast<std::uint64_t>(moment));
    if (rng.uniform() < share) work.wish_x[i] = work.wish_y[i] = 0;
  }
}

}  // namespace inhabit::crowd::pbd_model
#endif  // HWY_ONCE
