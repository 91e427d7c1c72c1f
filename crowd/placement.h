#pragma once
#include <span>
#include <string>

#include "crowd/agents.h"
#include "crowd/spots.h"

/// How the people of a scene come to stand where they start.
namespace inhabit::crowd {

/// What became of the request, for people: who could not be placed, moved out of walls, cannot reach a goal.
struct Intake {
  std::string population;
  std::size_t asked = 0, placed = 0, moved = 0, unreachable = 0;
};

/// The points of a population's grid, in the scene's coordinates: centres of the square cells that the area's bounding
/// box holds, row by row from its lower left corner, those in the area alone, each moved by its jitter. Random numbers
/// from (seed, first_id + index of the point). Requires: a spacing.
std::vector<Vec2> grid_points(const scene::Population& population, std::uint64_t seed, std::uint32_t first_id);

/// Adds a population's people to `agents`, with numbers from `next_id` on, and says how many. On a grid everybody
/// stands on his point, or on the nearest free place when that is in a wall or on somebody; the budget of that search
/// is limited, so that a hopeless population is refused in a second. At random, discs are thrown until they hit
/// somebody too often; then they stand on the widest lattice of hexagons that holds them, disturbed. Fewer than asked
/// when no more fit.
Intake place_population(const scene::Population& population, std::uint16_t route, const World& world,
                        std::uint64_t seed, std::uint32_t& next_id, Spots& spots, Agents& agents);

/// Gives the people of populations that start walking their wishes as velocities. Requires: the agents are in the order
/// in which the intakes placed them, one intake per population, and the planner has written their wishes.
void start_walking(std::span<const scene::Population> populations, std::span<const Intake> intakes, Agents& agents);

/// Any point of the floor inside the area, relative to the origin: its centre when that will do, else the middle-most
/// of a lattice. Nothing when the area has no floor.
std::optional<Vec2> point_inside(const World& world, const Ring& area);

}  // namespace inhabit::crowd
