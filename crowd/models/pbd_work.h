#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/aligned.h"
#include "crowd/agents.h"
#include "scene/crowd_models.h"

/// What the position-based model keeps between and within steps. Agents are handled in blocks of sixteen that stand
/// side by side in memory; arrays are padded to whole blocks, so that vector code needs no tails. Two coordinates of an
/// agent stand together ("pairs": x0 y0 x1 y1 …), so that a neighbour's both come with one look.
namespace inhabit::crowd::pbd_model {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kBlocksPerChunk = 16;  ///< a chunk is what one thread takes at a time: 256 agents
constexpr std::size_t kChunk = kLanes * kBlocksPerChunk;

using FloatArray = core::AlignedVector<float>;
using IndexArray = core::AlignedVector<std::int32_t>;

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
  /// Per block, when neighbours were found: the narrowest gap between two grown discs, metres; below 0 when a wall is
  /// near.
  std::array<float, kBlocksPerChunk> gap{};
  // Of the step that is being made.
  NeighbourRows near;  ///< those of `contacts` who may touch somebody before the step is over
  std::array<std::uint8_t, kBlocksPerChunk> busy{};  ///< blocks that have such or walls; the others walk freely
  std::uint32_t busy_count = 0;
  bool crowded = false;  ///< so many touch each other that whole rows are the quicker way
  float thrown = 0;      ///< how far stabilising has moved somebody, metres
};

/// What a step needs of the agents, in their order. Arrays without a remark are pairs.
struct Work {
  std::size_t count = 0;
  FloatArray at;         ///< where they are
  FloatArray next;       ///< where they will be
  FloatArray base;       ///< where they were when the sub-steps began, and
  FloatArray moved;      ///< how far they have come since: kept apart, or a float would round it away
  FloatArray predicted;  ///< where they would be at the end of the sub-step, contacts so far considered
  FloatArray corrected;  ///< the same after the iteration that is being made
  FloatArray v, wish;
  FloatArray maximum_speed;  ///< no pairs
  FloatArray radius, mass;   ///< no pairs; empty when everybody is alike
  float common_radius = 0;   ///< when everybody is alike, and the largest otherwise
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
  int parts = 1;         ///< sub-steps
  float blend = 0;       ///< alpha of eq. 4.1 for a sub-step
  float growth = 1.05f;  ///< 1 + contact margin
  float over_relaxation = 1.2f;
  float static_friction = 0, kinetic_friction = 0;
  float velocity_change = 0;  ///< largest in a step
  float skin = 0;
  float moved = 0;   ///< how far anybody is from where he was when neighbours were found, metres
  float stride = 0;  ///< how far anybody gets in a step, metres
  int far = 0;
  float far_horizon = 0;
  float cohesion = 0, cohesion_range = 0;
  const float* stiffness_of_delay = nullptr;  ///< k exp(-(m dt)^2 / tau_0) for m = 0, 1, …
};

}  // namespace inhabit::crowd::pbd_model
