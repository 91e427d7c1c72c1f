#include "crowd/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/text.h"
#include "crowd/arrivals.h"
#include "crowd/journey.h"
#include "crowd/model_table.h"
#include "crowd/safety.h"

namespace inhabit::crowd {
namespace {

/// Everybody's body, populations' first.
std::vector<const scene::Body*> bodies(const scene::Crowd& crowd) {
  std::vector<const scene::Body*> list(crowd.populations.size() + crowd.sources.size());
  std::size_t k = 0;
  for (const scene::Population& p : crowd.populations) list[k++] = &p;
  for (const scene::Source& s : crowd.sources) list[k++] = &s;
  return list;
}

double widest(const scene::Crowd& crowd) {
  double radius = 0;
  for (const scene::Body* body : bodies(crowd)) radius = std::max(radius, body->radius.high);
  return radius;
}

double fastest(const scene::Crowd& crowd) {
  double speed = 0;
  for (const scene::Body* body : bodies(crowd))
    speed = std::max(speed, body->speed.maximum.value_or(1.3 * (body->speed.mean + 3 * body->speed.deviation)));
  return speed;
}

/// How far a model asks about walls, metres.
double wall_reach(const scene::CrowdModel& model, double radius, double speed, double dt) {
  struct Range {
    double radius, speed;
    double operator()(const scene::PbdModel& m) const { return radius * (1 + m.contact_margin); }
    double operator()(const scene::PowerLawModel& m) const { return radius + std::min(m.range, m.horizon * speed); }
    double operator()(const scene::SocialForceModel& m) const { return radius + m.range; }
    double operator()(const scene::OrcaModel& m) const { return radius + m.wall_horizon * speed; }
  };
  // Neighbours of walls may be kept for a few steps; a dozen is more than any model keeps them.
  return std::max(std::visit(Range{radius, speed}, model), 1.1 * radius) + 12 * speed * dt;
}

/// The model whose parameters these are.
template <std::size_t k = 0>
Models make_model(const scene::CrowdModel& parameters) {
  static_assert(std::variant_size_v<Models> == std::variant_size_v<scene::CrowdModel>);
  using M = std::variant_alternative_t<k, Models>;
  if constexpr (k + 1 < std::variant_size_v<Models>) {
    if (!std::holds_alternative<typename M::Parameters>(parameters)) return make_model<k + 1>(parameters);
  }
  return Models(std::in_place_type<M>, std::get<typename M::Parameters>(parameters));
}

std::string goal_names(const scene::Crowd& crowd, const std::vector<std::uint16_t>& leg) {
  std::string names;
  for (const std::uint16_t g : leg) names += (names.empty() ? "\"" : " or \"") + crowd.goals[g].id + "\"";
  return names;
}

Error unreachable(const scene::Crowd& crowd, const std::string& where, const std::string& who,
                  const std::vector<std::uint16_t>& leg) {
  return invalid(where + "/goal", "nobody can get from " + who + " to " + goal_names(crowd, leg) +
                                      ": no way wide enough for a radius of " + shortest(widest(crowd)) +
                                      " m leads there");
}

}  // namespace

struct Simulation::State {
  State(World w, Journeys j, const scene::CrowdModel& parameters)
      : world(std::move(w)), journeys(std::move(j)), model(make_model(parameters)) {}

  World world;
  std::optional<Planner> planner;  ///< always there
  Journeys journeys;
  Models model;
  Agents agents;
  std::vector<Gate> gates;
  std::vector<Intake> intakes;
  std::uint64_t seed = 1;
  std::uint32_t next_id = 0;
  float widest = 0;
  double dt = 1.0 / 48;
  int threads = 0;
  std::size_t steps = 0, put_back = 0;
  StepTimes times;

  void let_in();
  Status place(const scene::Crowd& crowd, const RouteBook& book);
  Status check_sources(const scene::Crowd& crowd);
  Status check_legs(const scene::Crowd& crowd, std::uint16_t route, const std::string& where) const;
  bool reachable_from(Vec2 point, std::uint16_t route, std::size_t leg) const;
};

/// Puts everybody where he starts and counts who cannot get to his first goal.
Status Simulation::State::place(const scene::Crowd& crowd, const RouteBook& book) {
  Spots spots(world, widest);
  for (std::size_t k = 0; k < crowd.populations.size(); ++k) {
    const scene::Population& population = crowd.populations[k];
    const std::uint16_t route = book.of_population[k];
    const std::string where = "/crowd/populations/" + std::to_string(k);
    const std::size_t before = agents.size();
    intakes.push_back(place_population(population, route, world, seed, next_id, spots, agents));
    Intake& intake = intakes.back();
    if (intake.population.empty()) intake.population = std::to_string(k);
    for (std::size_t i = before; i < agents.size(); ++i) planner->enter(agents, i, seed);
    if (intake.placed == 0 || book.routes.legs[route].empty()) continue;
    for (std::size_t i = before; i < agents.size(); ++i)
      if (std::isinf(planner->distance(agents, i))) ++intake.unreachable;
    const std::string who = "population \"" + intake.population + "\"";
    if (intake.unreachable == intake.placed) return unreachable(crowd, where, who, book.routes.legs[route].front());
    if (Status s = check_legs(crowd, route, where); !s) return s;
  }
  return Done{};
}

/// Whether somebody who stands there (relative to the origin) can get to a goal of the leg.
/// Directions and offsets are taken on trust: they begin wherever somebody stands.
bool Simulation::State::reachable_from(Vec2 point, std::uint16_t route, std::size_t leg) const {
  if (journeys.goals()[journeys.routes().legs[route][leg].front()].area.empty()) return true;
  Agents probe;
  add_person(probe, {widest, 1, 1, 1}, 0, route, static_cast<float>(point.x), static_cast<float>(point.y));
  probe.leg[0] = static_cast<std::uint16_t>(leg);
  return !std::isinf(planner->distance(probe, 0));
}

/// The legs after the first, from the goals before them. Goals that are no areas are taken on trust.
Status Simulation::State::check_legs(const scene::Crowd& crowd, std::uint16_t route, const std::string& where) const {
  const auto& legs = journeys.routes().legs[route];
  for (std::size_t k = 1; k < legs.size(); ++k) {
    bool asked = false, found = false;
    for (const std::uint16_t g : legs[k - 1]) {
      const std::optional<Vec2> from = point_inside(world, crowd.goals[g].area);
      if (!from) continue;
      asked = true;
      found = found || reachable_from(*from, route, k);
    }
    if (asked && !found) return unreachable(crowd, where, goal_names(crowd, legs[k - 1]), legs[k]);
  }
  return Done{};
}

Status Simulation::State::check_sources(const scene::Crowd& crowd) {
  for (std::size_t k = 0; k < gates.size(); ++k) {
    const std::string where = "/crowd/sources/" + std::to_string(k);
    const std::string who = "source \"" + gates[k].source().id + "\"";
    const std::optional<Vec2> inside = point_inside(world, gates[k].source().area);
    if (!inside) return invalid(where + "/area", "no floor is in it, so nobody of " + who + " can enter");
    const auto& legs = journeys.routes().legs[gates[k].route()];
    if (legs.empty()) continue;
    if (!reachable_from(*inside, gates[k].route(), 0)) return unreachable(crowd, where, who, legs.front());
    if (Status s = check_legs(crowd, gates[k].route(), where); !s) return s;
  }
  return Done{};
}

Result<Simulation> Simulation::make(const scene::Scene& scene, const Settings& settings) {
  const scene::Crowd& crowd = scene.crowd;
  if (crowd.populations.empty() && crowd.sources.empty())
    return invalid("/crowd", "there are no people in it: neither populations nor sources");
  const double dt = settings.step.value_or(crowd.step);
  if (!(dt > 0 && dt <= kLongestStep))
    return invalid(settings.step ? "" : "/crowd/step",
                   "a step of " + shortest(dt) + " s: it must be above 0 and at most 1 s (1/48 s is usual)");
  const scene::CrowdModel& model = settings.model ? *settings.model : crowd.model;

  Result<RouteBook> book = make_routes(crowd);
  if (!book) return book.error();
  const double radius = widest(crowd);
  Result<World> world = make_world(scene, wall_reach(model, radius, fastest(crowd), dt));
  if (!world) return world.error();
  Journeys journeys(crowd, *world, book->routes);
  auto state = std::make_unique<State>(*std::move(world), std::move(journeys), model);
  Result<Planner> planner = Planner::make(scene, state->world, book->routes, radius, settings.threads);
  if (!planner) return planner.error();
  state->planner = *std::move(planner);
  state->seed = settings.seed.value_or(scene.seed);
  state->dt = dt, state->threads = settings.threads, state->widest = static_cast<float>(radius);
  for (std::size_t k = 0; k < crowd.sources.size(); ++k)
    state->gates.emplace_back(crowd.sources[k], book->of_source[k], state->world, state->seed, k);
  if (Status s = state->check_sources(crowd); !s) return s.error();
  if (Status s = state->place(crowd, *book); !s) return s.error();
  if (std::ranges::any_of(crowd.populations, &scene::Population::walking)) {
    state->planner->aim(state->agents, settings.threads);
    start_walking(crowd.populations, state->intakes, state->agents);
  }
  return Simulation(std::move(state));
}

/// Whoever is due enters and walks at once: he comes from outside, where he was walking too.
void Simulation::State::let_in() {
  const std::size_t before = agents.size();
  const double now = static_cast<double>(steps) * dt;
  for (Gate& gate : gates) gate.let_in(now, widest, world, next_id, agents);
  for (std::size_t i = before; i < agents.size(); ++i) planner->enter(agents, i, seed);
  planner->aim(agents, threads);
  for (std::size_t i = before; i < agents.size(); ++i) agents.vx[i] = agents.wish_x[i], agents.vy[i] = agents.wish_y[i];
}

void Simulation::step() {
  State& s = *state_;
  auto before = std::chrono::steady_clock::now();
  const auto lap = [&](double& total) {
    const auto now = std::chrono::steady_clock::now();
    total += std::chrono::duration<double>(now - before).count();
    before = now;
  };
  s.let_in();
  lap(s.times.planning);
  if (!s.agents.empty()) {
    const Surroundings around{s.world.walls, static_cast<float>(s.dt), s.threads};
    std::visit([&](auto& model) { model.step(s.agents, around); }, s.model);
    lap(s.times.model);
    s.put_back += keep_on_floor(s.agents, s.world.walls, s.threads);
    lap(s.times.keeping);
    s.journeys.advance(s.agents, *s.planner, s.dt, s.threads);
    s.agents.take_out(s.journeys.leaving());
    lap(s.times.arriving);
  }
  ++s.steps;
}

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

double Simulation::time() const { return static_cast<double>(state_->steps) * state_->dt; }
const StepTimes& Simulation::times() const { return state_->times; }
Effort Simulation::effort() const {
  const Pbd* model = std::get_if<Pbd>(&state_->model);
  return model != nullptr ? model->effort() : Effort{};
}
double Simulation::dt() const { return state_->dt; }
std::size_t Simulation::steps() const { return state_->steps; }
const Agents& Simulation::agents() const { return state_->agents; }
const World& Simulation::world() const { return state_->world; }
std::span<const Intake> Simulation::intakes() const { return state_->intakes; }
std::size_t Simulation::arrived() const { return state_->journeys.arrived(); }
std::size_t Simulation::people() const { return state_->next_id; }
std::size_t Simulation::put_back() const { return state_->put_back; }

std::size_t Simulation::waiting_outside() const {
  std::size_t sum = 0;
  for (const Gate& gate : state_->gates) sum += gate.waiting();
  return sum;
}

bool Simulation::finished() const {
  return state_->agents.empty() && std::ranges::all_of(state_->gates, [](const Gate& gate) { return gate.finished(); });
}

}  // namespace inhabit::crowd
