#pragma once
#include "crowd/grid.h"
#include "crowd/models/pbd_work.h"
#include "crowd/walls.h"

namespace inhabit::crowd::pbd_model {

struct Reach {
  float growth = 1.05f;  ///< of radii, for contacts
  float skin = 0;        ///< metres added to the reach of contacts
  bool far = false;
  float far_range = 5;
  std::uint32_t far_count = 10;
};

/// More than so many contacts of one agent are a pile, of which the nearest count.
constexpr std::size_t kMostContacts = 48;

/// Finds the neighbours of a chunk's agents: everybody whose grown disc comes within the skin, and the nearest few
/// within the far range (by distance, then by index). Requires: the agents are in the grid's order.
void find_neighbours(Work& work, const Grid& grid, const Reach& reach, std::size_t chunk);
/// The walls that a chunk's agents may touch: segments that they are in front of, within radius and skin.
void find_walls(Work& work, const Walls& walls, const Reach& reach, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model
