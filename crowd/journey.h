#pragma once
#include "crowd/planner.h"
#include "scene/crowd.h"

/// Routes from goal to goal: what a scene says about them, and how far everybody is on his.
namespace inhabit::crowd {

/// The routes of a scene's people, equal ones once.
struct RouteBook {
  Routes routes;
  std::vector<std::uint16_t> of_population, of_source;
};

/// Errors: goals that there are not, with the nearest name; more goals, routes or legs than 65,535.
Result<RouteBook> make_routes(const scene::Crowd& crowd);

/// The wait of people who have arrived for good.
constexpr float kStays = -1;

/// Takes people from goal to goal after each step.
class Journeys {
 public:
  Journeys(const scene::Crowd& crowd, const World& world, Routes routes);

  /// Whoever is in a goal of his leg waits there as long as the goal says, then goes on with the next leg; at the end
  /// of the route he leaves, or stays for ever (an infinite wait) in a goal that does not absorb. The indices of those
  /// who leave are `leaving()`, ascending.
  void advance(Agents& agents, const Planner& planner, double dt, int threads);
  std::span<const std::uint32_t> leaving() const { return leaving_; }
  /// People who have reached the end of their route so far.
  std::size_t arrived() const { return arrived_; }
  const Routes& routes() const { return routes_; }
  const std::vector<scene::Goal>& goals() const { return goals_; }

 private:
  struct Box {
    float low_x, low_y, high_x, high_y;
  };
  const scene::Goal* goal_at(const Agents& agents, std::size_t i) const;
  void find_arrivals(const Agents& agents, const Planner& planner, int threads);
  void visit(Agents& agents, std::size_t i, double dt);
  void next_leg(Agents& agents, std::size_t i, const scene::Goal* goal);

  std::vector<scene::Goal> goals_;
  Routes routes_;
  Vec2 origin_;
  /// Nobody arrives outside these; empty when there are too many to look through, or goals that are everywhere.
  std::vector<Box> boxes_;
  bool endless_ = true;  ///< nobody ever arrives: there are but directions
  std::size_t arrived_ = 0;
  std::size_t paused_ = 0;  ///< people who wait or stay
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> leaving_;
};

}  // namespace inhabit::crowd
