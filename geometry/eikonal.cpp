#include "geometry/eikonal.h"

#include <array>
#include <limits>
#include <queue>

#include "core/core.h"

namespace inhabit::geometry {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// One axis of the upwind scheme: the derivative towards the cell is slope * (T - at) / h.
struct Upwind {
  double at = 0, slope = 0;  ///< slope 0: nothing known on this axis
  double sign = 0;           ///< where the lower neighbour is
};

/// The lower neighbour along one axis. `known(k)`: T of cell k may be used.
template <class Known>
Upwind upwind(std::span<const float> t, std::size_t k, std::int32_t place, std::int32_t count, std::size_t stride,
              Known&& known) {
  float best = kFar;
  std::int32_t side = 0;
  if (place > 0 && known(k - stride)) best = t[k - stride], side = -1;
  if (place + 1 < count && known(k + stride) && t[k + stride] < best) best = t[k + stride], side = 1;
  if (side == 0 || best == kFar) return {};
  Upwind u{best, 1, static_cast<double>(side)};
  const std::int32_t second = place + 2 * side;
  if (second >= 0 && second < count) {
    const std::size_t far = side > 0 ? k + 2 * stride : k - 2 * stride;
    if (known(far) && t[far] <= best) u.at = (4.0 * best - t[far]) / 3, u.slope = 1.5;
  }
  return u;
}

/// The larger root of (sx (T - ax))^2 + (sy (T - ay))^2 = f^2, or the one-sided answer when the root does not lie
/// upwind of both.
double solve(Upwind x, Upwind y, double f) {
  if (x.slope == 0) std::swap(x, y);
  if (y.slope != 0) {
    const double wx = x.slope * x.slope, wy = y.slope * y.slope;
    const double a = wx + wy, b = wx * x.at + wy * y.at, d = x.at - y.at;
    const double root = a * f * f - wx * wy * d * d;
    if (root >= 0) {
      const double t = (b + std::sqrt(root)) / a;
      if (t >= x.at && t >= y.at) return t;
    }
    return std::min(x.at + f / x.slope, y.at + f / y.slope);
  }
  return x.at + f / x.slope;
}

}  // namespace

std::vector<float> march(const Lattice& lattice, std::span<const float> cost, std::span<const MarchSeed> seeds) {
  INHABIT_ASSERT(cost.size() == lattice.size());
  std::vector<float> t(lattice.size(), kFar);
  std::vector<std::uint8_t> known(lattice.size(), 0), seeded(lattice.size(), 0);
  struct Entry {
    float t;
    std::uint32_t cell;
    bool operator>(const Entry& b) const { return t != b.t ? t > b.t : cell > b.cell; }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const MarchSeed& seed : seeds) {
    if (cost[seed.cell] == kFar || !(seed.distance < t[seed.cell])) continue;
    t[seed.cell] = seed.distance, seeded[seed.cell] = 1;
    open.push({seed.distance, seed.cell});
  }
  const auto columns = static_cast<std::size_t>(lattice.columns);
  const auto is_known = [&](std::size_t k) { return known[k] != 0; };
  const auto update = [&](std::size_t k, std::int32_t column, std::int32_t row) {
    if (known[k] || cost[k] == kFar) return;
    const Upwind x = upwind(t, k, column, lattice.columns, 1, is_known);
    const Upwind y = upwind(t, k, row, lattice.rows, columns, is_known);
    const auto value = static_cast<float>(solve(x, y, cost[k] * lattice.cell));
    if (value == t[k] || seeded[k]) return;
    t[k] = value;  // also when larger: it knows more neighbours than the value before
    open.push({value, static_cast<std::uint32_t>(k)});
  };
  while (!open.empty()) {
    const auto [value, k] = open.top();
    open.pop();
    if (known[k] || value != t[k]) continue;
    known[k] = 1;
    const std::int32_t column = lattice.column_of(k), row = lattice.row_of(k);
    if (column > 0) update(k - 1, column - 1, row);
    if (column + 1 < lattice.columns) update(k + 1, column + 1, row);
    if (row > 0) update(k - columns, column, row - 1);
    if (row + 1 < lattice.rows) update(k + columns, column, row + 1);
  }
  return t;
}

Vec2 descent(const Lattice& lattice, std::span<const float> distance, std::size_t cell) {
  const float t = distance[cell];
  if (t == kFar) return {};
  const auto lower = [&](std::size_t k) { return distance[k] < t; };
  const Upwind x = upwind(distance, cell, lattice.column_of(cell), lattice.columns, 1, lower);
  const Upwind y =
      upwind(distance, cell, lattice.row_of(cell), lattice.rows, static_cast<std::size_t>(lattice.columns), lower);
  const Vec2 d{x.sign * x.slope * std::max(t - x.at, 0.0), y.sign * y.slope * std::max(t - y.at, 0.0)};
  const double l = length(d);
  return l > 0 ? (1 / l) * d : Vec2{};
}

}  // namespace inhabit::geometry
