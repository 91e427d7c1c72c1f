#pragma once
#include <oneapi/tbb/cache_aligned_allocator.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "crowd/agents.h"
#include "scene/crowd_models.h"

/// What the position-based model keeps between and within steps. Agents are handled in blocks of sixteen neighbours in
/// memory; arrays are padded to whole blocks, so that vector code needs no tails.
namespace inhabit::crowd::pbd_model {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kBlocksPerChunk = 32;  ///< a chunk is what one thread takes at a time: 512 agents
constexpr std::size_t kChunk = kLanes * kBlocksPerChunk;

using FloatArray = std::vector<float, tbb::cache_aligned_allocator<float>>;
using IndexArray = std::vector<std::int32_t, tbb::cache_aligned_allocator<std::int32_t>>;

/// For each block of agents rows of sixteen indices: entry [row][lane] is a neighbour of the block's agent `lane`, or
/// that agent itself where it has no more neighbours.
struct NeighbourRows {
  IndexArray items;
  std::array<std::uint32_t, kBlocksPerChunk + 1> first{};  ///< row numbers
};

/// A wall that an agent of the chunk may come to touch.
struct NearWall {
  std::uint32_t agent = 0, segment = 0;
};

/// A chunk's neighbours, found together and used together.
struct Chunk {
  NeighbourRows contacts, far;
  std::vector<NearWall> walls;  ///< ascending by agent
};

/// What a step needs of the agents, in their order.
struct Work {
  std::size_t count = 0;
  FloatArray x, y;              ///< where they are
  FloatArray next_x, next_y;    ///< where they will be
  FloatArray base_x, base_y;    ///< where they were when the sub-steps began, and
  FloatArray moved_x, moved_y;  ///< how far they have come since: kept apart, or a float would round it away
  FloatArray predicted_x, predicted_y;
  FloatArray corrected_x, corrected_y;
  FloatArray vx, vy, wish_x, wish_y, maximum_speed;
  FloatArray radius, mass;  ///< empty when everybody is alike
  float common_radius = 0;  ///< when everybody is alike, and the largest otherwise
  std::vector<Chunk> chunks;

  bool alike() const { return radius.empty(); }
  std::size_t blocks() const { return (count + kLanes - 1) / kLanes; }
  std::size_t blocks_of(std::size_t chunk) const {
    return std::min(kBlocksPerChunk, blocks() - chunk * kBlocksPerChunk);
  }
};

/// The model's parameters as the inner loops want them.
struct Constants {
  float dt = 0;    ///< of the whole step
  float part = 0;  ///< of a sub-step
  float inverse_part = 0;
  float blend = 0;       ///< alpha of eq. 4.1 for a sub-step
  float growth = 1.05f;  ///< 1 + contact margin
  float over_relaxation = 1.2f;
  float static_friction = 0, kinetic_friction = 0;
  float velocity_change = 0;  ///< largest in a sub-step
  float skin = 0;
  int far = 0;
  float far_horizon = 0;
  float headway = 0;
  float cohesion = 0, cohesion_range = 0;
  const float* stiffness_of_delay = nullptr;  ///< k exp(-(m dt)^2 / tau_0) for m = 0, 1, …
};

}  // namespace inhabit::crowd::pbd_model
