#include <algorithm>
#include <map>

#include "core/rng.h"
#include "layout/published_metrics.h"
#include "layout/solids.h"

/// The published measures that are computed from boxes alone.
namespace inhabit::layout {
namespace {

/// A point of the box's surface in plan, uniform over the area of its six faces.
Vec2 surface_point(const Solid& solid, core::Rng& rng) {
  const double d = solid.box.half_depth, w = solid.box.half_width, h = solid.top - solid.base;
  const double flat = 4 * d * w, front = 2 * w * h, side = 2 * d * h;
  double pick = rng.uniform() * 2 * (flat + front + side);
  double u = rng.uniform(-d, d), v = rng.uniform(-w, w);
  if ((pick -= 2 * flat) >= 0) {
    if (pick < 2 * front) {
      u = pick < front ? d : -d;
    } else {
      v = pick - 2 * front < side ? w : -w;
    }
  }
  return solid.box.center + u * solid.box.front + v * solid.box.left();
}

constexpr double kVoxel = 0.05;

/// Number of voxel centres of the world's grid in [low, high).
double voxels_between(double low, double high) {
  return std::max(0.0, std::ceil(high / kVoxel - 0.5) - std::ceil(low / kVoxel - 0.5));
}

/// Calls f(centre) for every voxel column whose centre lies in the box.
template <class F>
void for_each_column(const Box& box, F&& f) {
  const Bounds b = bounds(box);
  const auto first = [](double v) { return std::ceil(v / kVoxel - 0.5); };
  for (double row = first(b.min.y); (row + 0.5) * kVoxel <= b.max.y; ++row)
    for (double column = first(b.min.x); (column + 0.5) * kVoxel <= b.max.x; ++column) {
      const Vec2 p{(column + 0.5) * kVoxel, (row + 0.5) * kVoxel};
      if (box.contains(p)) f(p);
    }
}

/// Axis-parallel bounds in space.
struct Aabb {
  Bounds plan;
  double base = 0, top = 0;
  double volume() const { return plan.size().x * plan.size().y * (top - base); }
  Vec3 half() const { return {plan.size().x / 2, plan.size().y / 2, (top - base) / 2}; }
};

double shared_volume(const Aabb& a, const Aabb& b) {
  constexpr double kTouching = 1e-9;  // less is rounding
  const double x = std::min(a.plan.max.x, b.plan.max.x) - std::max(a.plan.min.x, b.plan.min.x);
  const double y = std::min(a.plan.max.y, b.plan.max.y) - std::max(a.plan.min.y, b.plan.min.y);
  const double z = std::min(a.top, b.top) - std::max(a.base, b.base);
  return x > kTouching && y > kTouching && z > kTouching ? x * y * z : 0;
}

bool symmetric(const Aabb& a, const Aabb& b) {
  const Vec3 p = a.half(), q = b.half();
  const Vec2 d = a.plan.center() - b.plan.center();
  return std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)}) < 0.1 &&
         (std::abs(d.x) < 0.1 || std::abs(d.y) < 0.1);
}

}  // namespace

std::vector<std::string> sceneeval_out_of_bound(const Scene& scene, std::uint64_t seed) {
  const Solids solids(scene);
  std::vector<std::string> out;
  for (const Solid& solid : solids.list) {
    if (outside_depth(solids.floor, solid.box) == 0) continue;  // every sample would hit the floor
    const Vec3 size = solids.object(solid).size;
    const int samples = static_cast<int>(std::clamp(5000 * size.x * size.y * size.z, 1000.0, 1e7));
    core::Rng rng(seed, solid.object);
    int hits = 0;
    for (int k = 0; k < samples; ++k) hits += contains(solids.floor, surface_point(solid, rng));
    if (static_cast<double>(hits) / samples < 0.99) out.push_back(solids.id(solid));
  }
  return out;
}

std::size_t sceneeval_colliding(const Scene& scene) {
  constexpr double kNudge = 0.005;
  const Solids solids(scene);
  std::vector<bool> colliding(solids.list.size(), false);
  solids.grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Solid &a = solids.list[i], &b = solids.list[j];
    if (a.shares_height(b.base, b.top, kNudge) && separation(a.box, b.box).depth > kNudge)
      colliding[i] = colliding[j] = true;
  });
  return static_cast<std::size_t>(std::ranges::count(colliding, true));
}

double sceneeval_relation(Relation relation, double distance) {
  struct Range {
    double low, high, sigma;
  };
  constexpr double kNoEnd = 1e300;
  const auto range = [&]() -> Range {
    switch (relation) {
      case Relation::next_to:
        return {0, 0.5, 0.25};
      case Relation::near:
        return {0.5, 1.5, 0.25};
      case Relation::across_from:
        return {1.5, 4, 0.25};
      case Relation::far:
        return {4, kNoEnd, 0.25};
      case Relation::against_wall:
        return {0, 0.3, 0.1};
      case Relation::on_wall:
        return {0, 0.01, 0.01};
      case Relation::on_ceiling:
        return {0, 0.01, 0.03};
    }
    return {0, 0, 1};
  }();
  const double gap = std::max({range.low - distance, distance - range.high, 0.0});
  return std::exp(-gap * gap / (2 * range.sigma * range.sigma));
}

std::size_t layoutgpt_out_of_bound(const Scene& scene) {
  constexpr double kSlack = 0.1;
  const Solids solids(scene);
  const Bounds& room = solids.floor.outline_bounds;
  return static_cast<std::size_t>(std::ranges::count_if(solids.list, [&](const Solid& solid) {
    const Bounds b = bounds(solid.box);
    return b.min.x < room.min.x - kSlack || b.min.y < room.min.y - kSlack || b.max.x > room.max.x + kSlack ||
           b.max.y > room.max.y + kSlack;
  }));
}

ReSpace respace(const Scene& scene) {
  constexpr double kLeast = 1e-7;  // cubic metres of the box outside, below which its voxels are not counted
  const Solids solids(scene);
  const double ceiling = scene.space.height, volume = kVoxel * kVoxel * kVoxel;
  ReSpace result;
  for (const Solid& solid : solids.list) {
    const bool sticks_out = std::max(solid.top - ceiling, -solid.base) * solid.box.area() > kLeast;
    if (!sticks_out && outside_depth(solids.floor, solid.box) == 0) continue;
    const double all = voxels_between(solid.base, solid.top);
    const double inside = voxels_between(std::max(solid.base, 0.0), std::min(solid.top, ceiling));
    double outside = 0;
    for_each_column(solid.box, [&](Vec2 p) { outside += contains(solids.floor, p) ? all - inside : all; });
    result.oob += outside * volume;
  }
  solids.grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Solid &a = solids.list[i], &b = solids.list[j];
    const double levels = voxels_between(std::max(a.base, b.base), std::min(a.top, b.top));
    if (levels == 0 || separation(a.box, b.box).depth <= 0) return;
    const bool a_smaller = a.box.area() < b.box.area();
    const Box &small = a_smaller ? a.box : b.box, &large = a_smaller ? b.box : a.box;
    for_each_column(small, [&](Vec2 p) { result.mbl += large.contains(p) ? levels * volume : 0; });
  });
  result.pbl = result.oob + result.mbl;
  return result;
}

DiffuScene diffuscene(const Scene& scene) {
  const Solids solids(scene);
  std::vector<Aabb> boxes;
  for (const Solid& solid : solids.list) boxes.push_back({bounds(solid.box), solid.base, solid.top});
  const auto n = static_cast<double>(boxes.size());
  DiffuScene result;
  double iou = 0, intersecting = 0;
  solids.grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const double shared = shared_volume(boxes[i], boxes[j]);
    if (shared == 0) return;
    iou += shared / (boxes[i].volume() + boxes[j].volume() - shared);
    ++intersecting;
  });
  const double pairs = n * (n - 1) / 2;
  if (pairs > 0) result.mean_iou = iou / pairs, result.intersecting = intersecting / pairs;
  if (boxes.size() > 5000) return result;
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Object &a = solids.object(solids.list[i]), &b = solids.object(solids.list[j]);
      count += a.kind == b.kind && a.model == b.model && symmetric(boxes[i], boxes[j]);
    }
  result.symmetric = count;
  return result;
}

double infinigen_focus(const Box& a, const Box& b) { return 0.5 - dot(a.front, unit(b.center - a.center)) / 2; }

double infinigen_angle_alignment(const Box& a, const Box& b) {
  const auto corners = b.corners();
  const std::size_t side = nearest_on_ring(corners, a.center).side;
  const Vec2 normal = perp(unit(corners[(side + 1) % 4] - corners[side]));
  return 0.5 - std::abs(dot(a.front, normal)) / 2;
}

double infinigen_accessibility(const Box& a, std::span<const Box> others) {
  double sum = 0;
  for (const Box& b : others) {
    if (b.contains(a.center)) continue;
    const auto corners = b.corners();
    const Vec2 d = nearest_on_ring(corners, a.center).point - a.center;
    sum += std::max(0.0, dot(a.front, d)) / dot(d, d) * 2 * b.radius();
  }
  return sum;
}

double infinigen_freespace_2d(const Scene& scene) {
  const Solids solids(scene);
  const double room = area(solids.floor);
  double covered = 0;
  for (const Solid& solid : solids.list) covered += solid.box.area();
  return 100 * (room - covered) / room;
}

}  // namespace inhabit::layout
