#include "crowd/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "crowd/planners/fields.h"
#include "crowd/planners/ways.h"

namespace inhabit::crowd {
namespace {

/// Agents are aimed in blocks of so many.
constexpr std::size_t kBlock = 1024;
/// On the last bit to a point people walk no faster than the distance in so many seconds: twice the models' relaxation
/// time, so that they overshoot by 4 % at most.
constexpr float kSlowing = 1;
/// Walkers of `paths` look every so many steps whether their corner is in sight, and choose anew every so many.
constexpr std::uint64_t kLook = 8, kChoose = 48;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// People who are going to head for the goals of a leg, by the document.
double expected(const scene::Scene& scene, const std::vector<std::uint16_t>& goals) {
  const auto heads_there = [&](const scene::Route& route) {
    return std::ranges::any_of(route.legs, [&](const std::vector<std::string>& leg) {
      return std::ranges::any_of(leg, [&](const std::string& id) {
        return std::ranges::any_of(goals, [&](std::uint16_t g) { return scene.crowd.goals[g].id == id; });
      });
    });
  };
  double people = 0;
  for (const scene::Population& p : scene.crowd.populations) {
    if (!heads_there(p.goal)) continue;
    if (p.count) {
      people += *p.count;
    } else if (p.spacing && p.area.size() >= 3) {
      people += std::abs(signed_area(p.area)) / (*p.spacing * *p.spacing);
    }
  }
  for (const scene::Source& s : scene.crowd.sources) {
    if (!heads_there(s.goal)) continue;
    const double most = s.count ? *s.count : kInfinity;
    people += std::min(most, s.rate * std::max(0.0, s.until.value_or(scene.crowd.seconds) - s.from));
  }
  return people;
}

}  // namespace

struct Planner::Plans {
  enum class How : std::uint8_t { nowhere, direction, offset, straight, paths, field };
  struct Leg {
    How how = How::nowhere;
    std::uint32_t plan = 0;  ///< of `ways` or `fields`
    std::vector<std::uint16_t> goals;
  };
  /// What is remembered of each person, by id.
  struct Memory {
    float x = 0, y = 0;  ///< where they started
    std::uint32_t target = Ways::kNone, leg = 0;
  };

  using Goals = std::vector<std::uint16_t>;

  std::vector<Place> places;
  std::vector<Leg> legs;
  std::vector<std::uint32_t> first_leg;  ///< per route, and where the last one ends
  std::vector<std::uint32_t> field_of;   ///< per leg; kNone for other ways
  std::vector<Floor> floors;             ///< relative to the origin
  std::size_t reflex_corners = 0;        ///< that stick into the floors
  Fields fields;
  std::unique_ptr<Corners> corners;
  std::vector<Ways> ways;
  std::vector<Memory> memory;
  std::uint64_t seed = 0, steps = 0;

  static constexpr std::uint32_t kNoLeg = 0xffffffffu;
  std::uint32_t leg_index(const Agents& agents, std::size_t i) const {
    const std::size_t route = agents.route[i];
    if (route + 1 >= first_leg.size()) return kNoLeg;
    const std::uint32_t k = first_leg[route] + agents.leg[i];
    return k < first_leg[route + 1] ? k : kNoLeg;
  }
  const Leg* leg_of(const Agents& agents, std::size_t i) const {
    const std::uint32_t k = leg_index(agents, i);
    return k != kNoLeg ? &legs[k] : nullptr;
  }
  /// Whether something must be remembered of those who follow the route.
  bool remembers(std::size_t route) const {
    if (route + 1 >= first_leg.size()) return false;
    const auto begin = legs.begin() + first_leg[route], end = legs.begin() + first_leg[route + 1];
    return std::any_of(begin, end, [](const Leg& leg) { return leg.how == How::offset || leg.how == How::paths; });
  }
  void add_leg(const scene::Scene& scene, const Goals& goals, std::vector<Goals>& by_path,
               std::vector<Goals>& by_field);
  Region::Way to_offset(const Agents& agents, std::size_t i, const Leg& leg) const;
  Region::Way to_nearest(const Leg& leg, float x, float y) const;
  bool inside(const Leg& leg, float x, float y) const {
    for (const std::uint16_t g : leg.goals)
      if (places[g].area.contains(x, y)) return true;
    return false;
  }
  bool arrived(const Agents& agents, std::size_t i) const;
  Region::Way along_path(const Agents& agents, std::size_t i, const Leg& leg);
  Region::Way wish(const Agents& agents, std::size_t i, const Leg& leg);
  /// Whether all of those agents walk straight to the same rectangle; then `leg` is theirs.
  bool same_straight(const Agents& agents, std::size_t begin, std::size_t end, std::uint32_t& leg) const;
  void aim(Agents& agents, std::size_t begin, std::size_t end);
};

namespace {

using Goals = std::vector<std::uint16_t>;

/// The index of `goals` in `all`, where it is added when it is new.
std::uint32_t index_of(std::vector<Goals>& all, Goals goals) {
  std::ranges::sort(goals);
  const auto found = std::ranges::find(all, goals);
  if (found != all.end()) return static_cast<std::uint32_t>(found - all.begin());
  all.push_back(std::move(goals));
  return static_cast<std::uint32_t>(all.size() - 1);
}

/// Corners that stick into the floors.
std::size_t reflex_corners(const std::vector<Floor>& floors) {
  std::size_t count = 0;
  const auto add = [&](const Ring& ring, bool outline) {
    const double sign = (signed_area(ring) > 0) == outline ? 1 : -1;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], b = ring[(k + 1) % ring.size()], c = ring[(k + 2) % ring.size()];
      if (sign * cross(unit(b - a), unit(c - b)) < -1e-6) ++count;
    }
  };
  for (const Floor& floor : floors) {
    add(floor.outline, true);
    for (const Ring& hole : floor.holes) add(hole, false);
  }
  return count;
}

}  // namespace

/// Decides how the ways of a leg are found.
void Planner::Plans::add_leg(const scene::Scene& scene, const Goals& goals, std::vector<Goals>& by_path,
                             std::vector<Goals>& by_field) {
  Leg leg;
  const Place::Kind kind = goals.empty() ? Place::Kind::nowhere : places[goals[0]].kind;
  if (kind == Place::Kind::direction || kind == Place::Kind::offset) {
    leg.how = kind == Place::Kind::direction ? How::direction : How::offset, leg.goals = {goals[0]};
  } else {
    for (const std::uint16_t g : goals)
      if (places[g].kind == Place::Kind::area) leg.goals.push_back(g);
    const auto method = scene.crowd.planner;
    const bool automatic = method == scene::Planner::automatic;
    if (leg.goals.empty()) {
      leg.how = How::nowhere;
    } else if (method == scene::Planner::straight || floors.empty() || (automatic && reflex_corners == 0)) {
      leg.how = How::straight;
    } else if (method == scene::Planner::field || reflex_corners > kMostCorners ||
               (automatic && expected(scene, leg.goals) >= kShared)) {
      leg.how = How::field, leg.plan = index_of(by_field, leg.goals);
    } else {
      leg.how = How::paths, leg.plan = index_of(by_path, leg.goals);
    }
  }
  field_of.push_back(leg.how == How::field ? leg.plan : Fields::kNone);
  legs.push_back(std::move(leg));
}

Result<Planner> Planner::make(const scene::Scene& scene, const World& world, const Routes& routes, double widest,
                              int threads) {
  auto plans = std::make_unique<Plans>();
  for (const scene::Goal& goal : scene.crowd.goals) plans->places.emplace_back(goal, world.origin);
  for (const Floor& floor : world.floors) {
    Floor own = floor;
    for (Vec2& p : own.outline) p -= world.origin;
    for (Ring& hole : own.holes)
      for (Vec2& p : hole) p -= world.origin;
    plans->floors.push_back(make_floor(std::move(own.outline), std::move(own.holes)));
  }
  plans->reflex_corners = reflex_corners(plans->floors);
  std::vector<Goals> by_path, by_field;
  for (const auto& route : routes.legs) {
    plans->first_leg.push_back(static_cast<std::uint32_t>(plans->legs.size()));
    for (const Goals& goals : route) plans->add_leg(scene, goals, by_path, by_field);
  }
  plans->first_leg.push_back(static_cast<std::uint32_t>(plans->legs.size()));

  const auto places_of = [&](const Goals& goals) {
    std::vector<const Place*> places;
    for (const std::uint16_t g : goals) places.push_back(&plans->places[g]);
    return places;
  };
  if (!by_field.empty()) {
    std::vector<std::vector<const Place*>> targets;
    for (const Goals& goals : by_field) targets.push_back(places_of(goals));
    plans->fields = Fields(world, targets, widest, threads);
  }
  if (!by_path.empty()) {
    // Where there is room, corners are passed at a hand's breadth.
    plans->corners = std::make_unique<Corners>(world, (1 - kSqueeze) * widest, 1.2 * widest + 0.02, threads);
    for (const Goals& goals : by_path) plans->ways.emplace_back(*plans->corners, places_of(goals));
  }
  return Planner(std::move(plans));
}

Planner::Planner(std::unique_ptr<Plans> plans) : plans_(std::move(plans)) {}
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;
Planner::~Planner() = default;

void Planner::enter(const Agents& agents, std::size_t i, std::uint64_t seed) {
  const std::size_t id = agents.id[i];
  plans_->seed = seed;
  if (!plans_->remembers(agents.route[i])) return;
  if (id >= plans_->memory.size()) plans_->memory.resize(std::max(id + 1, id + id / 2));
  plans_->memory[id] = {agents.x[i], agents.y[i], Ways::kNone, 0};
}

Region::Way Planner::Plans::to_offset(const Agents& agents, std::size_t i, const Leg& leg) const {
  INHABIT_ASSERT(agents.id[i] < memory.size());
  const Memory& start = memory[agents.id[i]];
  const Region::Way own = own_offset(places[leg.goals[0]], seed, agents.id[i], leg.goals[0]);
  return {start.x + own.x - agents.x[i], start.y + own.y - agents.y[i]};
}

Region::Way Planner::Plans::to_nearest(const Leg& leg, float x, float y) const {
  Region::Way best = places[leg.goals[0]].way_from(x, y);
  float least = best.x * best.x + best.y * best.y;
  for (std::size_t k = 1; k < leg.goals.size(); ++k) {
    const Region::Way way = places[leg.goals[k]].way_from(x, y);
    const float square = way.x * way.x + way.y * way.y;
    if (square < least) least = square, best = way;
  }
  return best;
}

/// The unit vector of the shortest way; nothing in the goal and where no way leads on.
Region::Way Planner::Plans::along_path(const Agents& agents, std::size_t i, const Leg& leg) {
  const Vec2 p{agents.x[i], agents.y[i]};
  for (const std::uint16_t g : leg.goals)
    if (places[g].aim.contains(agents.x[i], agents.y[i])) {
      const Region::Way way = places[g].way_from(agents.x[i], agents.y[i]);
      const Vec2 d{way.x, way.y};
      return d == Vec2{} ? way : Region::Way{static_cast<float>(unit(d).x), static_cast<float>(unit(d).y)};
    }
  INHABIT_ASSERT(agents.id[i] < memory.size());
  Memory& mine = memory[agents.id[i]];
  const auto index = static_cast<std::uint32_t>(&leg - legs.data());
  if (mine.leg != index) mine.leg = index, mine.target = Ways::kNone;
  const Ways& ways_there = ways[leg.plan];
  const std::uint64_t turn = steps + agents.id[i];
  Ways::Step step;
  if (mine.target != Ways::kNone && turn % kChoose != 0) {
    step = ways_there.step(p, mine.target, false);
    const bool moved_on = step.target != mine.target;
    if (step.target != Ways::kNone && (moved_on || turn % kLook == 0) &&
        !ways_there.in_sight(p, step.target, step.towards))
      step.target = Ways::kNone;
  }
  if (step.target == Ways::kNone) {
    const Ways::Choice choice = ways_there.choose(p, mine.target);
    if (choice.target != Ways::kNone) step = ways_there.step(p, choice.target, true);
    if (step.target == Ways::kNone) {
      mine.target = Ways::kNone;
      if (corners->on_floor(p)) return {};
      step.direction = unit(corners->nearest_wall(p) - p);  // out of the wall first
    }
  }
  mine.target = step.target;
  return {static_cast<float>(step.direction.x), static_cast<float>(step.direction.y)};
}

/// The wish of an agent that has a goal and does not wait, for every way but fields.
Region::Way Planner::Plans::wish(const Agents& agents, std::size_t i, const Leg& leg) {
  const float speed = agents.preferred_speed[i];
  if (leg.how == How::direction) {
    const Place& place = places[leg.goals[0]];
    return {speed * place.x, speed * place.y};
  }
  if (leg.how == How::paths) {
    const Region::Way way = along_path(agents, i, leg);
    return {speed * way.x, speed * way.y};
  }
  const bool point = leg.how == How::offset;
  const Region::Way way = point ? to_offset(agents, i, leg) : to_nearest(leg, agents.x[i], agents.y[i]);
  const float distance = std::sqrt(way.x * way.x + way.y * way.y);
  if (!(distance > 0)) return {};
  // Areas are walked into at full speed; a point would be overshot.
  const float scale = point ? std::min(speed, distance / kSlowing) / distance : speed / distance;
  return {scale * way.x, scale * way.y};
}

bool Planner::Plans::same_straight(const Agents& agents, std::size_t begin, std::size_t end, std::uint32_t& leg) const {
  leg = leg_index(agents, begin);
  if (leg == kNoLeg || legs[leg].how != How::straight || legs[leg].goals.size() != 1) return false;
  const Place& place = places[legs[leg].goals[0]];
  if (!place.aim.is_box || !place.area.is_box) return false;
  bool same = true;
  for (std::size_t i = begin; i < end; ++i)
    same =
        same & (agents.route[i] == agents.route[begin]) & (agents.leg[i] == agents.leg[begin]) & !(agents.wait[i] > 0);
  return same;
}

namespace {

/// Wishes to walk straight to a place of rectangles, as `wish` has them; without branches, which makes vectors of it.
void aim_at(const Place& place, Agents& agents, std::size_t begin, std::size_t end) {
  const Region &aim = place.aim, &area = place.area;
  const float *x = agents.x.data(), *y = agents.y.data(), *speed = agents.preferred_speed.data();
  float *wish_x = agents.wish_x.data(), *wish_y = agents.wish_y.data();
  const auto into = [](float low, float high, float at) { return std::min(std::max(at, low), high) - at; };
  for (std::size_t i = begin; i < end; ++i) {
    const float ax = into(aim.min_x, aim.max_x, x[i]), ay = into(aim.min_y, aim.max_y, y[i]);
    const float bx = into(area.min_x, area.max_x, x[i]), by = into(area.min_y, area.max_y, y[i]);
    const bool on_aim = (ax == 0) & (ay == 0);
    const float wx = on_aim ? bx : ax, wy = on_aim ? by : ay;
    const float distance = std::sqrt(wx * wx + wy * wy);
    const float scale = distance > 0 ? speed[i] / distance : 0.0f;
    wish_x[i] = scale * wx, wish_y[i] = scale * wy;
  }
}

}  // namespace

void Planner::Plans::aim(Agents& agents, std::size_t begin, std::size_t end) {
  if (std::uint32_t leg = 0; same_straight(agents, begin, end, leg)) {
    aim_at(places[legs[leg].goals[0]], agents, begin, end);
    return;
  }
  std::array<std::uint32_t, kBlock> field;
  bool any_field = false;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t leg = agents.wait[i] > 0 ? kNoLeg : leg_index(agents, i);
    const std::uint32_t mine = leg == kNoLeg ? Fields::kNone : field_of[leg];
    field[i - begin] = mine;
    if (mine != Fields::kNone) {
      any_field = true;
      continue;
    }
    const Region::Way way = leg == kNoLeg || legs[leg].how == How::nowhere ? Region::Way{} : wish(agents, i, legs[leg]);
    agents.wish_x[i] = way.x, agents.wish_y[i] = way.y;
  }
  if (!any_field) return;
  const auto part = [&](auto& array) { return std::span(array).subspan(begin, end - begin); };
  fields.look_up(std::span(field).first(end - begin), part(agents.x), part(agents.y), part(agents.preferred_speed),
                 part(agents.wish_x), part(agents.wish_y));
}

void Planner::aim(Agents& agents, int threads) {
  parallel_for((agents.size() + kBlock - 1) / kBlock, agents.size() < 4 * kBlock ? 1 : threads,
               [&](std::size_t b) { plans_->aim(agents, b * kBlock, std::min((b + 1) * kBlock, agents.size())); });
  ++plans_->steps;
}

bool Planner::Plans::arrived(const Agents& agents, std::size_t i) const {
  const Leg* leg = leg_of(agents, i);
  if (leg == nullptr || leg->how == How::nowhere || leg->how == How::direction) return false;
  if (leg->how != How::offset) return inside(*leg, agents.x[i], agents.y[i]);
  const Region::Way way = to_offset(agents, i, *leg);
  const float near = std::max(kArrival, agents.radius[i] / 2);
  return way.x * way.x + way.y * way.y <= near * near;
}

bool Planner::arrived(const Agents& agents, std::size_t i) const { return plans_->arrived(agents, i); }

void Planner::arrived(const Agents& agents, std::span<std::uint8_t> flags, int threads) const {
  INHABIT_ASSERT(flags.size() == agents.size());
  parallel_for((agents.size() + kBlock - 1) / kBlock, agents.size() < 4 * kBlock ? 1 : threads, [&](std::size_t b) {
    for (std::size_t i = b * kBlock; i < std::min((b + 1) * kBlock, agents.size()); ++i)
      flags[i] = plans_->arrived(agents, i) ? 1 : 0;
  });
}

double Planner::distance(const Agents& agents, std::size_t i) const {
  const Plans& plans = *plans_;
  const Plans::Leg* leg = plans.leg_of(agents, i);
  using How = Plans::How;
  if (leg == nullptr || leg->how == How::direction) return 0;
  if (leg->how == How::nowhere) return kInfinity;
  const float x = agents.x[i], y = agents.y[i];
  if (leg->how == How::offset) {
    const Region::Way way = plans.to_offset(agents, i, *leg);
    return std::hypot(way.x, way.y);
  }
  if (plans.inside(*leg, x, y)) return 0;
  if (leg->how == How::field) return plans.fields.distance(leg->plan, x, y);
  if (leg->how == How::paths) return plans.ways[leg->plan].choose({x, y}).length;
  const Region::Way way = plans.to_nearest(*leg, x, y);
  const bool together = plans.floors.size() < 2 || std::ranges::any_of(plans.floors, [&](const Floor& floor) {
                          return contains(floor, Vec2{x, y}) && std::ranges::any_of(leg->goals, [&](std::uint16_t g) {
                                   const Bounds box = bounds(plans.places[g].aim.ring);
                                   return meet(box, floor.outline_bounds);
                                 });
                        });
  return together ? std::hypot(way.x, way.y) : kInfinity;
}

scene::Planner Planner::method(std::size_t route, std::size_t leg) const {
  const Plans::Leg& l = plans_->legs[plans_->first_leg[route] + leg];
  return l.how == Plans::How::field   ? scene::Planner::field
         : l.how == Plans::How::paths ? scene::Planner::paths
                                      : scene::Planner::straight;
}

}  // namespace inhabit::crowd
