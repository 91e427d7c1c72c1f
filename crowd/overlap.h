#pragma once
#include "crowd/agents.h"
#include "crowd/grid.h"
#include "crowd/walls.h"

namespace inhabit::crowd {

/// How deep people are in each other and in walls at one moment.
struct Overlap {
  double depth = 0;  ///< the largest r_i + r_j - |x_i - x_j|, metres
  double share = 0;  ///< the largest depth / (r_i + r_j)
  double wall = 0;   ///< the deepest that a disc reaches into a wall, metres
};

/// Looks at all pairs that touch; keeps its memory from one moment to the next.
class OverlapMeter {
 public:
  /// Independent of the number of threads. Cost: a few per cent of a step of any model.
  Overlap measure(const Agents& agents, const Walls& walls, int threads);

 private:
  Grid grid_;
  std::vector<float> x_, y_, radius_;
};

}  // namespace inhabit::crowd
