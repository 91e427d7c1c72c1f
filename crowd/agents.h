#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/core.h"
#include "geometry/polygon.h"

/// People as discs on the plane. One array for each attribute; positions and velocities are floats, relative to the
/// world's origin (crowd/world.h), so that a hall anywhere on earth keeps a tenth of a millimetre.
namespace inhabit::crowd {
using namespace core;
using namespace geometry;

struct Agents {
  // What models read and write.
  std::vector<float> x, y;             ///< metres
  std::vector<float> vx, vy;           ///< metres per second
  std::vector<float> wish_x, wish_y;   ///< preferred velocity, set by the planner before each step
  std::vector<float> radius;           ///< metres
  std::vector<float> mass;             ///< relative; > 0
  std::vector<float> preferred_speed;  ///< metres per second
  std::vector<float> maximum_speed;    ///< metres per second
  // Who they are.
  std::vector<std::uint32_t> id;     ///< never given twice; from 0
  std::vector<std::uint16_t> route;  ///< index of the route they follow
  std::vector<std::uint16_t> leg;    ///< how far they are on it
  std::vector<float> wait;           ///< seconds still to be spent where they are; below 0: they have arrived for good
  // Where they were before the model's step, always on the floor: the simulation's alone.
  std::vector<float> kept_x, kept_y;  ///< metres

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }

  /// Calls f(array) for every array, so that nothing is forgotten when agents come, go or change places.
  template <class F>
  void for_each_array(F&& f) {
    f(x), f(y), f(vx), f(vy), f(wish_x), f(wish_y), f(radius), f(mass), f(preferred_speed), f(maximum_speed);
    f(id), f(route), f(leg), f(wait), f(kept_x), f(kept_y);
  }

  void reserve(std::size_t count) {
    for_each_array([&](auto& array) { array.reserve(count); });
  }
  /// Adds one agent of zeros (mass and radius too) and returns its index.
  std::size_t add() {
    for_each_array([](auto& array) { array.emplace_back(); });
    return size() - 1;
  }
  /// Agent k becomes what agent order[k] was. Requires: a permutation of 0 … size() - 1.
  void permute(std::span<const std::uint32_t> order, int threads = 1);
  /// Removes every agent whose flag is set; the others keep their order.
  void remove(std::span<const std::uint8_t> flags);
  /// Removes the agents of these indices; the last ones take their places. Cost: the number of indices, not of agents.
  /// Requires: ascending, none twice.
  void take_out(std::span<const std::uint32_t> indices);
};

}  // namespace inhabit::crowd
