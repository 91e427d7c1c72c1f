#pragma once
#include <concepts>

#include "crowd/agents.h"
#include "crowd/walls.h"

namespace inhabit::crowd {

/// What a step may look at beside the agents.
struct Surroundings {
  const Walls& walls;
  float dt = 1.0f / 48;  ///< seconds
  int threads = 0;       ///< 0: all there are; never changes the result
};

/// A model of how people walk: one file in crowd/models/, one line in crowd/model_table.h. `Parameters` is its noun in
/// scene/crowd_models.h. `step` moves every agent from t to t + dt: it reads positions, velocities and wishes and
/// writes positions and velocities. It may permute the agents; who is who says `id`. The result must not depend on the
/// number of threads. Everything else is the simulation's business (crowd/simulation.h): goals, coming and going, that
/// nobody ends inside a wall.
template <class M>
concept Model = requires(M model, Agents& agents, const Surroundings& around) {
  typename M::Parameters;
  requires std::constructible_from<M, const typename M::Parameters&>;
  { model.step(agents, around) } -> std::same_as<void>;
};

}  // namespace inhabit::crowd
