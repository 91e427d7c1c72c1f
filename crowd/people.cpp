#include "crowd/people.h"

#include <algorithm>
#include <cmath>

#include "core/distributions.h"

namespace inhabit::crowd {
namespace {

constexpr double kDeviations = 3, kSlowest = 0.1, kHeadroom = 1.3;
/// Half of the draws or more are good whatever mean and deviation are; after so many bad ones the mean is taken.
constexpr int kDraws = 64;

double preferred_speed(const scene::Speed& speed, Rng& rng) {
  for (int k = 0; k < kDraws; ++k) {
    const double z = standard_normal(rng), v = speed.mean + speed.deviation * z;
    if (std::abs(z) <= kDeviations && v >= kSlowest * speed.mean) return v;
  }
  return speed.mean;
}

}  // namespace

Person make_person(const scene::Body& body, std::uint64_t seed, std::uint32_t id) {
  Rng rng = draw(seed, Draw::body, id);
  Person person;
  person.radius = static_cast<float>(rng.uniform(body.radius.low, body.radius.high));
  person.mass = static_cast<float>(body.mass);
  const double wish = preferred_speed(body.speed, rng);
  const double most = body.speed.maximum.value_or(kHeadroom * wish);
  person.preferred_speed = static_cast<float>(std::min(wish, most));
  person.maximum_speed = static_cast<float>(most);
  return person;
}

std::size_t add_person(Agents& agents, const Person& person, std::uint32_t id, std::uint16_t route, float x, float y) {
  const std::size_t i = agents.add();
  agents.x[i] = agents.kept_x[i] = x, agents.y[i] = agents.kept_y[i] = y;
  agents.radius[i] = person.radius, agents.mass[i] = person.mass;
  agents.preferred_speed[i] = person.preferred_speed, agents.maximum_speed[i] = person.maximum_speed;
  agents.id[i] = id, agents.route[i] = route;
  return i;
}

}  // namespace inhabit::crowd
