#include "crowd/measures/density_field.h"

#include <algorithm>
#include <cmath>

#include "geometry/raster.h"

namespace inhabit::crowd {
namespace {

constexpr std::size_t kMostCells = 250'000;

/// Sums over some of the frames.
struct Sums {
  std::vector<double> density, speed;
  std::vector<double> time;  ///< frames in which somebody of known speed had the point
};

Bounds extent(const Recording& recording, const VoronoiGround& ground) {
  Bounds b;
  for (const Area& area : ground.walkable())
    for (const Vec2 p : area.outline) b.add(p);
  if (ground.walkable().empty())
    for (const scene::Fix& fix : recording.trajectories.fixes) b.add(fix.at());
  return b;
}

void add(Sums& sums, const Raster& raster, const Area& cell, double speed) {
  if (cell.outline.empty()) return;
  const Bounds b = bounds(cell.outline);
  const double density = 1 / cell.size();
  const auto range = [&](double low, double high, double origin, int count) {
    return std::pair(std::clamp(static_cast<int>(std::floor((low - origin) / raster.cell)), 0, count - 1),
                     std::clamp(static_cast<int>(std::floor((high - origin) / raster.cell)), 0, count - 1));
  };
  const auto [c0, c1] = range(b.min.x, b.max.x, raster.origin.x, raster.columns);
  const auto [r0, r1] = range(b.min.y, b.max.y, raster.origin.y, raster.rows);
  for (int r = r0; r <= r1; ++r) {
    for (int c = c0; c <= c1; ++c) {
      const Vec2 p = raster.center(c, r);
      if (!contains(cell.outline, p)) continue;
      if (std::ranges::any_of(cell.holes, [&](const Ring& hole) { return contains(hole, p); })) continue;
      sums.density[raster.at(c, r)] += density;
      if (known(speed)) sums.speed[raster.at(c, r)] += speed, sums.time[raster.at(c, r)] += 1;
    }
  }
}

}  // namespace

float DensityField::most() const {
  float most = 0;
  for (const float d : density) most = std::max(most, d > 0 ? d : 0);
  return most;
}

DensityField density_field(const Recording& recording, const VoronoiGround& ground, std::span<const double> speed,
                           const FieldOptions& options) {
  DensityField field;
  if (recording.fix_count() == 0) return field;
  const Raster raster = make_raster(extent(recording, ground), options.cell, kMostCells);
  field.origin = raster.origin, field.cell = raster.cell, field.columns = raster.columns, field.rows = raster.rows;
  field.frames = std::min(recording.frame_count(), std::max<std::size_t>(options.most_frames, 1));
  // As many sums as blocks, added in order, so that threads change nothing.
  constexpr std::size_t kBlocks = 8;
  std::vector<Sums> blocks(kBlocks);
  parallel_for(kBlocks, options.threads, [&](std::size_t block) {
    Sums& sums = blocks[block];
    for (auto* array : {&sums.density, &sums.speed, &sums.time}) array->assign(raster.values.size(), 0);
    for (std::size_t n = block; n < field.frames; n += kBlocks) {
      const std::size_t k = n * recording.frame_count() / field.frames;
      const std::vector<Area> cells = ground.cells(recording.places(k));
      for (std::size_t i = 0; i < cells.size(); ++i) add(sums, raster, cells[i], speed[recording.first(k) + i]);
    }
  });
  for (int r = 0; r < field.rows; ++r) {
    for (int c = 0; c < field.columns; ++c) {
      double density = 0, sum = 0, time = 0;
      for (const Sums& sums : blocks) {
        density += sums.density[raster.at(c, r)];
        sum += sums.speed[raster.at(c, r)], time += sums.time[raster.at(c, r)];
      }
      const bool ground_here = ground.on_ground(raster.center(c, r));
      field.density.push_back(static_cast<float>(ground_here ? density / static_cast<double>(field.frames) : kUnknown));
      field.speed.push_back(static_cast<float>(time > 0 ? sum / time : kUnknown));
    }
  }
  return field;
}

}  // namespace inhabit::crowd
