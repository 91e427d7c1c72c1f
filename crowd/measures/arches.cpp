#include "crowd/measures/arches.h"

#include <algorithm>
#include <cmath>

namespace inhabit::crowd {
namespace {

/// Somebody who may bear an arch, in the opening's own axes: along it from its middle, and before it.
struct Bearer {
  double along = 0, before = 0, distance = 0, radius = 0;
  std::size_t person = 0;
};

struct Ground {
  std::vector<Bearer> bearers;  ///< by distance from the middle
  double half = 0, widest = 0;
};

Ground ground_of(std::span<const Standing> crowd, const Opening& opening, const ArchOptions& options) {
  Ground ground;
  const Vec2 span = opening.to - opening.from, middle = 0.5 * (opening.from + opening.to);
  ground.half = 0.5 * length(span);
  const Vec2 axis = (1 / length(span)) * span;
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    const Vec2 d = crowd[i].at - middle;
    const Bearer b{dot(d, axis), dot(d, perp(axis)), length(d), crowd[i].radius, i};
    if (b.before < 0 || !(crowd[i].speed <= options.slow)) continue;
    ground.widest = std::max(ground.widest, b.radius);
    ground.bearers.push_back(b);
  }
  std::ranges::sort(ground.bearers, {}, [](const Bearer& b) { return std::pair(b.distance, b.person); });
  return ground;
}

bool touch(const Bearer& a, const Bearer& b, double share) {
  return std::hypot(a.along - b.along, a.before - b.before) <= (a.radius + b.radius) * (1 + share);
}

/// The shortest chain from wall to wall among bearers [low, high), breadth first; empty when there is none.
std::vector<std::size_t> chain(const Ground& ground, std::size_t low, std::size_t high, const ArchOptions& options) {
  const auto& all = ground.bearers;
  const auto at_wall = [&](std::size_t i, int side) {
    return side * all[i].along > ground.half && all[i].before <= all[i].radius * (1 + options.touch);
  };
  constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
  std::vector<std::size_t> from(all.size(), kNobody), queue;
  for (std::size_t i = low; i < high; ++i)
    if (at_wall(i, -1)) from[i] = i, queue.push_back(i);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t i = queue[head];
    if (at_wall(i, 1)) {
      std::vector<std::size_t> links = {i};
      while (from[links.back()] != links.back()) links.push_back(from[links.back()]);
      std::ranges::reverse(links);
      return links;
    }
    for (std::size_t j = low; j < high; ++j)
      if (from[j] == kNobody && touch(all[i], all[j], options.touch)) from[j] = i, queue.push_back(j);
  }
  return {};
}

}  // namespace

std::optional<Arch> innermost_arch(std::span<const Standing> crowd, const Opening& opening,
                                   const ArchOptions& options) {
  const Ground ground = ground_of(crowd, opening, options);
  const auto end_of = [&](double distance) {
    const auto end = std::ranges::lower_bound(ground.bearers, distance, {}, &Bearer::distance);
    return static_cast<std::size_t>(end - ground.bearers.begin());
  };
  for (double inner = ground.half; inner <= options.farthest * ground.half; inner += options.step) {
    const std::vector<std::size_t> links =
        chain(ground, end_of(inner), end_of(inner + 2 * options.thick * ground.widest), options);
    if (links.empty()) continue;
    Arch arch{inner, 0, {}};
    for (const std::size_t k : links) {
      const std::size_t person = ground.bearers[k].person;
      arch.people.push_back(person), arch.speed += crowd[person].speed / static_cast<double>(links.size());
    }
    return arch;
  }
  return std::nullopt;
}

}  // namespace inhabit::crowd
