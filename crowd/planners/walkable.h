#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "crowd/world.h"
#include "geometry/eikonal.h"

/// Where the middle of a body can be, cell by cell: what all flow fields of a world share.
namespace inhabit::crowd {

/// A passage may be narrower than a body's width by this share: people turn their shoulders, and plans are rounded.
constexpr double kSqueeze = 0.03;

struct Walkable {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr float kClosed = std::numeric_limits<float>::infinity();

  Lattice lattice;  ///< relative to the world's origin
  double body = 0;  ///< metres
  Walls walls;      ///< the world's, with a reach that suits the lattice

  /// What a metre through each cell counts: 1 away from walls, up to 3 where a body touches one, infinite where a
  /// body's middle cannot be. A cell is open when some point of it is (1 - kSqueeze) bodies away from every wall, so
  /// that a passage just wide enough is open wherever the cells' centres happen to lie.
  std::vector<float> cost;
  /// For closed cells the open cell that leads out, for open cells themselves; kNone farther than a few bodies inside
  /// a wall, and in corners of the floor without any open cell.
  std::vector<std::uint32_t> exit;
};

/// Cells of `cell` metres, or as much larger as it takes to need at most `most` of them. `body`: radius of the widest.
Walkable make_walkable(const World& world, double body, double cell, std::size_t most);

}  // namespace inhabit::crowd
