#include <algorithm>
#include <array>

#include "core/parallel.h"
#include "layout/check_parts.h"

/// How much of an area that should be free is not: doors, clearances, views.
namespace inhabit::layout {
namespace {

constexpr double kSpacing = 0.02;  // metres between samples, unless that takes more than kMostSamples a side
constexpr double kMostSamples = 100;
constexpr double kLeastShare = 1e-3;  // less is not worth a line

enum class Beyond { blocked, ignored };  // what samples outside the room are

/// The solids that meet `area` and satisfy `counts`.
template <class Counts>
std::vector<const Solid*> meeting(const Solids& solids, const Box& area, Counts&& counts) {
  std::vector<const Solid*> found;
  solids.grid.for_each_near(bounds(area), [&](std::uint32_t i) {
    const Solid& solid = solids.list[i];
    if (counts(solid) && separation(area, solid.box).depth > 0) found.push_back(&solid);
  });
  return found;
}

/// Share of the samples of `area` for which `within` holds that lie in a blocker or, if so wanted, outside the room.
template <class Within>
double blocked_share(const Floor& floor, const Box& area, const std::vector<const Solid*>& blockers, Beyond beyond,
                     Within&& within) {
  const bool crosses_wall = outside_depth(floor, area) > 0;
  if (blockers.empty() && (!crosses_wall || beyond == Beyond::ignored)) return 0;
  const auto samples = [](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / kSpacing), 4.0, kMostSamples));
  };
  const int along = samples(2 * area.half_depth), across = samples(2 * area.half_width);
  std::size_t all = 0, blocked = 0;
  for (int i = 0; i < along; ++i) {
    const Vec2 row = area.center + area.half_depth * (2 * (i + 0.5) / along - 1) * area.front;
    for (int j = 0; j < across; ++j) {
      const Vec2 p = row + area.half_width * (2 * (j + 0.5) / across - 1) * area.left();
      if (!within(p)) continue;
      const bool out = crosses_wall && !contains(floor, p);
      if (out && beyond == Beyond::ignored) continue;
      ++all;
      if (out || std::ranges::any_of(blockers, [&](const Solid* b) { return b->box.contains(p); })) ++blocked;
    }
  }
  return all == 0 ? 0 : static_cast<double>(blocked) / static_cast<double>(all);
}

/// solid(i) for every solid in blocks; what it returns, joined in order.
template <class T, class F>
std::vector<T> for_all(const Solids& solids, int threads, F&& find) {
  constexpr std::size_t kBlock = 64;
  const std::size_t n = solids.list.size();
  std::vector<std::vector<T>> parts((n + kBlock - 1) / kBlock);
  core::parallel_for(parts.size(), threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) find(solids.list[i], parts[block]);
  });
  std::vector<T> all;
  for (auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

double door_share(const Solids& solids, const Door& door, const DoorFrame& at) {
  const bool swings = door.swing == Door::Swing::in;
  const double width = door.width, depth = swings ? std::max(width, kPersonDepth) : kPersonDepth;
  const Box area{at.jamb + width / 2 * at.along + depth / 2 * at.inward, at.inward, depth / 2, width / 2};
  const auto blockers =
      meeting(solids, area, [&](const Solid& b) { return b.top > kStepHeight && b.base < door.height; });
  const double hinge = door.hinge == Door::Hinge::start ? 0 : width;
  return blocked_share(solids.floor, area, blockers, Beyond::blocked, [&](Vec2 p) {
    const double u = dot(p - at.jamb, at.along) - hinge, v = dot(p - at.jamb, at.inward);
    return v <= kPersonDepth || (swings && u * u + v * v <= width * width);
  });
}

struct Face {
  std::string_view name;
  Box area;
};

/// The rectangles of free space that the solid wants, outside its faces.
std::vector<Face> wanted(const Solid& solid, const Clearance& c) {
  std::vector<Face> faces;
  const auto add = [&](std::string_view name, double depth, Vec2 outward, double half_extent, double half_length) {
    if (depth <= 0) return;
    faces.push_back({name, {solid.box.center + (half_extent + depth / 2) * outward, outward, depth / 2, half_length}});
  };
  const Box& b = solid.box;
  add("front", c.front, b.front, b.half_depth, b.half_width);
  add("back", c.back, -b.front, b.half_depth, b.half_width);
  add("left", c.left, b.left(), b.half_width, b.half_depth);
  add("right", c.right, -b.left(), b.half_width, b.half_depth);
  return faces;
}

double view_share(const Solids& solids, const Solid& solid, const View& view) {
  const Box& b = solid.box;
  const Vec2 eye = b.center + b.half_depth * b.front;
  const double half = std::min(view.angle / 2, kPi), d = view.distance;
  const SinCos opening = sin_cos(half);
  // The smallest box along the front that holds the sector.
  const double low = half > kPi / 2 ? d * opening.cos : 0;
  const double half_width = half > kPi / 2 ? d : d * opening.sin;
  const Box area{eye + (d + low) / 2 * b.front, b.front, (d - low) / 2, half_width};
  const auto blockers = meeting(solids, area, [&](const Solid& other) {
    return other.object != solid.object && other.shares_height(solid.base, solid.top) &&
           !solids.relations.bound(solid.object, other.object);
  });
  return blocked_share(solids.floor, area, blockers, Beyond::ignored, [&](Vec2 p) {
    const double r = length(p - eye);
    return r <= d && dot(p - eye, b.front) >= r * opening.cos;
  });
}

}  // namespace

std::vector<CheckReport::BlockedDoor> find_blocked_doors(const Solids& solids) {
  std::vector<CheckReport::BlockedDoor> found;
  for (const Door& door : solids.scene.space.doors) {
    const auto at = frame(solids.scene.space, door);
    const double share = at ? door_share(solids, door, *at) : 0;
    if (share > kLeastShare) found.push_back({door.id, share});
  }
  std::ranges::stable_sort(found, [](const auto& x, const auto& y) { return x.share > y.share; });
  return found;
}

std::vector<CheckReport::BlockedClearance> find_blocked_clearances(const Solids& solids, int threads) {
  using Found = CheckReport::BlockedClearance;
  auto all = for_all<Found>(solids, threads, [&](const Solid& solid, std::vector<Found>& found) {
    const double low = solid.base + kStepHeight, high = std::max(solid.top, solid.base + kPersonHeight);
    for (const Face& face : wanted(solid, solids.object(solid).clearance)) {
      const auto blockers = meeting(solids, face.area, [&](const Solid& other) {
        return other.object != solid.object && other.shares_height(low, high) &&
               !solids.relations.bound(solid.object, other.object);
      });
      const double share = blocked_share(solids.floor, face.area, blockers, Beyond::blocked, [](Vec2) { return true; });
      if (share > kLeastShare) found.push_back({solids.id(solid), std::string(face.name), share});
    }
  });
  std::ranges::stable_sort(all, [](const auto& x, const auto& y) { return x.blocked_share > y.blocked_share; });
  return all;
}

std::vector<CheckReport::BlockedView> find_blocked_views(const Solids& solids, int threads) {
  using Found = CheckReport::BlockedView;
  auto all = for_all<Found>(solids, threads, [&](const Solid& solid, std::vector<Found>& found) {
    const auto& view = solids.object(solid).view;
    if (!view || view->distance <= 0 || view->angle <= 0) return;
    const double share = view_share(solids, solid, *view);
    if (share > kLeastShare) found.push_back({solids.id(solid), share});
  });
  std::ranges::stable_sort(all, [](const auto& x, const auto& y) { return x.blocked_share > y.blocked_share; });
  return all;
}

}  // namespace inhabit::layout
