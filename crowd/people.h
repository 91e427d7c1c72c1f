#pragma once
#include "core/rng.h"
#include "crowd/agents.h"
#include "scene/crowd.h"

/// Who somebody is: what a body's description, the seed and the person's number decide, and nothing else.
namespace inhabit::crowd {

/// Random numbers for one purpose and one person (or source): streams never meet.
enum class Draw : std::uint64_t { body, place, entry, arrivals };
inline Rng draw(std::uint64_t seed, Draw what, std::uint64_t number) {
  return Rng(seed, 8 * number + static_cast<std::uint64_t>(what));
}

struct Person {
  float radius = 0, mass = 1;                    ///< metres; relative
  float preferred_speed = 0, maximum_speed = 0;  ///< metres per second
};

/// The radius is uniform in its span. The preferred speed is normally distributed, drawn again while it is farther than
/// three deviations from the mean or below a tenth of it, and at most the maximum; the maximum is the body's or 1.3
/// times the preferred speed.
Person make_person(const scene::Body& body, std::uint64_t seed, std::uint32_t id);

/// Adds this person at rest and returns the index. (x, y) is relative to the world's origin.
std::size_t add_person(Agents& agents, const Person& person, std::uint32_t id, std::uint16_t route, float x, float y);

}  // namespace inhabit::crowd
