#include "crowd/journey.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/parallel.h"
#include "core/text.h"

namespace inhabit::crowd {
namespace {

constexpr std::size_t kMost = 65535;
/// Waits end this early: sums of floats are not exact, and a step is a thousand times longer.
constexpr float kMoment = 1e-5f;

/// Boxes of so many goals are looked through in less time than everybody is asked, in blocks of so many people.
constexpr std::size_t kMostBoxes = 4, kBlock = 4096;
/// Positions are floats: boxes are larger than areas by this much, metres.
constexpr double kRim = 0.01;

using Legs = std::vector<std::vector<std::uint16_t>>;

Result<Legs> resolve(const scene::Crowd& crowd, const scene::Route& route, const std::string& where) {
  Legs legs;
  for (const std::vector<std::string>& names : route.legs) {
    std::vector<std::uint16_t> leg;
    for (const std::string& name : names) {
      const auto goal = std::ranges::find(crowd.goals, name, &scene::Goal::id);
      if (goal == crowd.goals.end()) {
        std::vector<std::string_view> known;
        for (const scene::Goal& g : crowd.goals) known.push_back(g.id);
        return invalid(where, "no goal is called \"" + name + "\"" + did_you_mean(name, known));
      }
      leg.push_back(static_cast<std::uint16_t>(goal - crowd.goals.begin()));
    }
    if (!leg.empty()) legs.push_back(std::move(leg));
  }
  if (legs.size() > kMost) return invalid(where, "a route has at most 65,535 legs");
  return legs;
}

}  // namespace

Result<RouteBook> make_routes(const scene::Crowd& crowd) {
  if (crowd.goals.size() > kMost) return invalid("/crowd/goals", "there may be at most 65,535 goals");
  RouteBook book;
  std::vector<Legs>& all = book.routes.legs;
  const auto add = [&](const scene::Route& route, const std::string& where,
                       std::vector<std::uint16_t>& list) -> Status {
    Result<Legs> legs = resolve(crowd, route, where + "/goal");
    if (!legs) return legs.error();
    auto known = std::ranges::find(all, *legs);
    if (known == all.end()) known = all.insert(all.end(), *std::move(legs));
    if (all.size() > kMost) return invalid(where, "there may be at most 65,535 different routes");
    list.push_back(static_cast<std::uint16_t>(known - all.begin()));
    return Done{};
  };
  for (std::size_t k = 0; k < crowd.populations.size(); ++k)
    if (Status s = add(crowd.populations[k].goal, "/crowd/populations/" + std::to_string(k), book.of_population); !s)
      return s.error();
  for (std::size_t k = 0; k < crowd.sources.size(); ++k)
    if (Status s = add(crowd.sources[k].goal, "/crowd/sources/" + std::to_string(k), book.of_source); !s)
      return s.error();
  return book;
}

Journeys::Journeys(const scene::Crowd& crowd, const World& world, Routes routes)
    : goals_(crowd.goals), routes_(std::move(routes)), origin_(world.origin) {
  std::vector<std::uint8_t> used(goals_.size(), 0);
  for (const Legs& legs : routes_.legs)
    for (const std::vector<std::uint16_t>& leg : legs)
      for (const std::uint16_t g : leg) used[g] = 1;
  bool everywhere = false;
  for (std::size_t g = 0; g < goals_.size(); ++g) {
    if (!used[g] || goals_[g].direction) continue;
    endless_ = false;
    everywhere = everywhere || goals_[g].area.size() < 3;
    Bounds box = bounds(goals_[g].area);
    box = {box.min - origin_, box.max - origin_};
    boxes_.push_back({static_cast<float>(box.min.x - kRim), static_cast<float>(box.min.y - kRim),
                      static_cast<float>(box.max.x + kRim), static_cast<float>(box.max.y + kRim)});
  }
  if (everywhere || boxes_.size() > kMostBoxes) boxes_.clear();
}

/// Sets flags_: who is in a goal of his leg. Few are near one, and only they are asked for exactly.
void Journeys::find_arrivals(const Agents& agents, const Planner& planner, int threads) {
  if (boxes_.empty()) return planner.arrived(agents, flags_, threads);
  const std::size_t n = agents.size();
  parallel_for((n + kBlock - 1) / kBlock, threads, [&](std::size_t b) {
    const std::size_t begin = b * kBlock, end = std::min(n, begin + kBlock);
    std::array<std::int32_t, kBlock> inside{};
    for (const Box& box : boxes_) {
      const float *x = &agents.x[begin], *y = &agents.y[begin];
      for (std::size_t k = 0; k < end - begin; ++k)  // without branches: compilers turn it into vectors
        inside[k] |= static_cast<std::int32_t>(x[k] >= box.low_x) & static_cast<std::int32_t>(x[k] <= box.high_x) &
                     static_cast<std::int32_t>(y[k] >= box.low_y) & static_cast<std::int32_t>(y[k] <= box.high_y);
    }
    for (std::size_t i = begin; i < end; ++i) flags_[i] = inside[i - begin] != 0 && planner.arrived(agents, i);
  });
}

const scene::Goal* Journeys::goal_at(const Agents& agents, std::size_t i) const {
  const Legs& legs = routes_.legs[agents.route[i]];
  if (agents.leg[i] >= legs.size()) return nullptr;
  const std::vector<std::uint16_t>& choice = legs[agents.leg[i]];
  const scene::Goal* best = &goals_[choice.front()];
  if (choice.size() == 1) return best;
  // The planner has its own arithmetic for what lies on a border: the nearest is the one that it meant.
  const Vec2 p = origin_ + Vec2{agents.x[i], agents.y[i]};
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint16_t g : choice) {
    const Ring& area = goals_[g].area;
    if (area.size() < 3) continue;
    const double distance = contains(area, p) ? 0 : nearest_on_ring(area, p).distance;
    if (distance < least) least = distance, best = &goals_[g];
  }
  return best;
}

void Journeys::next_leg(Agents& agents, std::size_t i, const scene::Goal* goal) {
  if (agents.leg[i] + 1u < routes_.legs[agents.route[i]].size()) {
    ++agents.leg[i];
    return;
  }
  ++arrived_;
  if (goal == nullptr || goal->absorb) {
    leaving_.push_back(static_cast<std::uint32_t>(i));
  } else {
    agents.wait[i] = kStays, ++paused_;
  }
}

/// Somebody who waits, or who is in a goal of his leg.
void Journeys::visit(Agents& agents, std::size_t i, double dt) {
  float& wait = agents.wait[i];
  if (wait < 0) return;
  const scene::Goal* goal = goal_at(agents, i);
  if (wait > 0) {
    wait -= static_cast<float>(dt);
    if (wait > kMoment) return;
    wait = 0, --paused_;
  } else if (goal != nullptr && goal->wait > 0) {
    wait = static_cast<float>(goal->wait), ++paused_;
    return;
  }
  next_leg(agents, i, goal);
}

void Journeys::advance(Agents& agents, const Planner& planner, double dt, int threads) {
  leaving_.clear();
  if (endless_) return;
  const std::size_t n = agents.size();
  flags_.resize(n);
  find_arrivals(agents, planner, threads);
  if (paused_ > 0)
    for (std::size_t i = 0; i < n; ++i) flags_[i] = flags_[i] | static_cast<std::uint8_t>(agents.wait[i] != 0);
  // Few flags are up, and bytes are found faster than they are looked at one by one.
  for (std::size_t i = 0; i < n; ++i) {
    const void* up = std::memchr(flags_.data() + i, 1, n - i);
    if (up == nullptr) break;
    i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(up) - flags_.data());
    visit(agents, i, dt);
  }
}

}  // namespace inhabit::crowd
