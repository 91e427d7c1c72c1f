#include <algorithm>

#include "geometry/raster.h"
#include "layout/check_parts.h"

/// Where a person can go: the configuration space of a disc, sampled at the centres of a raster's cells.
namespace inhabit::layout {
namespace {

constexpr double kCell = 0.02;
constexpr std::size_t kMostCells = 16'000'000;
constexpr double kTouching = 1e-9;  // a disc that just touches fits

constexpr std::uint8_t kBlocked = 0, kFree = 1;

/// Free are the cells from whose centres the disc touches nothing: their distance to every obstacle is measured
/// exactly, so that only the passages between the centres depend on the raster.
Raster free_cells(const Solids& solids) {
  Raster raster = make_raster(solids.floor.outline_bounds, kCell, kMostCells);
  fill(raster, solids.floor.outline, kFree);
  const auto block = [&](int column, int row) { raster.values[raster.at(column, row)] = kBlocked; };
  const double radius = kPersonRadius - kTouching;
  const auto block_sides = [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
      for_each_near(raster, ring[k], ring[(k + 1) % ring.size()], radius, block);
  };
  block_sides(solids.floor.outline);
  for (const Ring& hole : solids.floor.holes) {
    fill(raster, hole, kBlocked);
    block_sides(hole);
  }
  for (const Solid& solid : solids.list)
    if (blocks_person(solid)) for_each_near(raster, solid.box, radius, block);
  return raster;
}

/// The parts of the free cells that people get into: those with a cell just inside a door between its jambs; without
/// doors the largest.
std::vector<bool> entered(const Solids& solids, const Raster& raster, const Components& parts) {
  std::vector<bool> in(parts.size.size(), false);
  const Space& space = solids.scene.space;
  if (space.doors.empty()) {
    const auto largest = std::ranges::max_element(parts.size);
    if (largest != parts.size.end()) in[static_cast<std::size_t>(largest - parts.size.begin())] = true;
    return in;
  }
  for (const Door& door : space.doors) {
    const auto at = frame(space, door);
    if (!at) continue;
    const double slack = std::max(door.width / 2 - kPersonRadius, 0.0) + raster.cell;
    const Vec2 middle = at->jamb + door.width / 2 * at->along;
    // Two cells deep, so that some centre falls into the strip however the wall is turned.
    const Box strip{middle + (kPersonRadius + raster.cell) * at->inward, at->inward, raster.cell + kTouching, slack};
    for_each_near(raster, strip, kTouching, [&](int column, int row) {
      const std::int32_t label = parts.label[raster.at(column, row)];
      if (label >= 0) in[static_cast<std::size_t>(label)] = true;
    });
  }
  return in;
}

/// True when somebody can stand next to the solid.
bool can_be_reached(const Solid& solid, const Raster& raster, const Components& parts, const std::vector<bool>& in) {
  bool reached = false;
  const double within = kPersonRadius + std::max(0.05, 1.5 * raster.cell);
  for_each_near(raster, solid.box, within, [&](int column, int row) {
    const std::int32_t label = parts.label[raster.at(column, row)];
    reached = reached || (label >= 0 && in[static_cast<std::size_t>(label)]);
  });
  return reached;
}

}  // namespace

ReachFindings find_reach(const Solids& solids) {
  const Raster raster = free_cells(solids);
  const Components parts = components(raster, kFree);
  const std::vector<bool> in = entered(solids, raster, parts);
  std::size_t free = 0, reachable = 0;
  for (std::size_t k = 0; k < parts.size.size(); ++k) {
    free += parts.size[k];
    if (in[k]) reachable += parts.size[k];
  }
  ReachFindings found;
  found.cell = raster.cell;
  found.reachable.share = free == 0 ? 0 : static_cast<double>(reachable) / static_cast<double>(free);
  found.walkable_share = static_cast<double>(free) * raster.cell * raster.cell / area(solids.floor);
  for (const Solid& solid : solids.list) {
    const Object& object = solids.object(solid);
    const bool on_floor = object.mount == Mount::floor && object.on.none() && solid.base < kStepHeight;
    if (on_floor && !can_be_reached(solid, raster, parts, in)) found.reachable.unreachable.push_back(object.id);
  }
  return found;
}

}  // namespace inhabit::layout
