#include "annealing/arrange.h"

#include <chrono>
#include <mutex>

namespace inhabit::annealing {
namespace {

/// Metres off its learned distance from which an object that belongs at a wall counts as not having found one.
constexpr double kNoWall = 0.1;

/// Iterations for every object that moves, unless said otherwise: with a seventh of it the paper's restaurant ends at
/// four times the cost, chairs and dishes at the wrong tables.
constexpr std::int64_t kEach = 20000;

Costs weighted_parts(const Costs& costs, const Weights& weights) {
  Costs parts = costs;
  for_each_term(parts, [&]<class T>(std::type_identity<T>, double& part) { part *= T::weight(weights); });
  return parts;
}

/// What one start is told beyond the options.
struct Start {
  int number = 1;
  std::vector<TraceRow>* trace = nullptr;
  core::Progress progress;
};

Arranged outcome_of(const Arranger& arranger) {
  const Arrangement& x = arranger.arrangement();
  const Furniture& f = x.furniture();
  Arranged out;
  for (std::uint32_t i = 0; i < f.items.size(); ++i) {
    out.poses.push_back({x.position(i), x.angle(i)});
    out.bases.push_back(x.body(i).low);
    out.carriers.push_back(f.items[i].carried ? x.carrier(i) : kNobody);
  }
  for (std::uint32_t p = 0; p < f.paths.size(); ++p)
    out.paths.push_back({f.paths[p].from, x.points(p)[0], x.points(p)[1], f.paths[p].to});
  out.parts = weighted_parts(arranger.costs(), f.weights);
  out.cost = arranger.cost();
  std::size_t k = 0;
  out.fits = true;
  for_each_term(out.parts, [&]<class T>(std::type_identity<T>, double&) {
    const double cost = arranger.costs()[k++];
    if constexpr (std::is_same_v<T, Overlap> || std::is_same_v<T, Inside>) out.fits = out.fits && cost < kTouch / 2;
  });
  return out;
}

Arranged run_start(const Furniture& furniture, const Options& options, const Start& start) {
  const auto clock = std::chrono::steady_clock::now();
  const Vec2 room = furniture.room.extent().size();
  Arranger arranger(furniture, {options.hot, std::max(room.x, room.y) / 4, kPi / 2, options.paper_moves});
  Rng scatter(options.seed ^ 0x5ca77e2, static_cast<std::uint64_t>(start.number));
  arranger.scatter(scatter, options.given);
  AnnealOptions anneal_options;
  anneal_options.iterations =
      options.iterations > 0 ? options.iterations
                             : kEach * static_cast<std::int64_t>(std::max<std::size_t>(1, furniture.walkers.size()));
  anneal_options.schedule = {Schedule::Shape::geometric, options.hot, options.cold};
  anneal_options.seed = options.seed, anneal_options.stream = static_cast<std::uint64_t>(start.number);
  anneal_options.replicas = options.replicas, anneal_options.threads = options.threads;
  anneal_options.progress = start.progress, anneal_options.cancel = options.cancel;
  Observer<Arranger> observer;
  if (start.trace != nullptr) {
    observer.every = options.trace_every;
    observer.look = [&](std::int64_t i, double temperature, double cost, const Arranger& a) {
      start.trace->push_back({start.number, i, temperature, cost, weighted_parts(a.costs(), furniture.weights)});
    };
  }
  const AnnealResult result = anneal(arranger, anneal_options, observer);
  Arranged out = outcome_of(arranger);
  out.start = start.number, out.iterations = result.iterations;
  out.proposed = result.proposed, out.accepted = result.accepted;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return out;
}

bool better(const Arranged& a, const Arranged& b) { return a.fits != b.fits ? a.fits : a.cost < b.cost; }

/// "Some furniture objects that should be positioned against walls may be placed at a distance from the nearest wall
/// that is already occupied" (Yu et al. 7): they are named.
std::vector<std::string> without_wall(const Furniture& f, const Arranged& best) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < f.items.size(); ++i) {
    const Item& item = f.items[i];
    if (!item.has_wall || item.wall_distance > kNoWall || item.carried || !item.moves) continue;
    const Vec2 away = direction(best.poses[i].angle + item.back_turn);
    const WallPoint w = f.room.nearest_wall(best.poses[i].p - item.back_half * away);
    if (std::abs(w.distance - item.wall_distance) > kNoWall) names.push_back(f.scene->objects[i].id);
  }
  return names;
}

}  // namespace

Result<Outcome> arrange(const Scene& scene, const Targets& targets, const Options& options) {
  Result<Furniture> compiled = compile(scene, targets, options.weights);
  if (!compiled) return compiled.error();
  compiled->path_width = options.path_width;
  const Furniture& furniture = *compiled;
  const auto count = static_cast<std::size_t>(std::max(1, options.starts));
  std::vector<std::optional<Arranged>> done(count);
  std::vector<std::vector<TraceRow>> traces(count);
  std::mutex telling;
  double sum = 0;
  std::vector<double> shares(count);
  const auto run = [&](std::size_t i) {
    if (options.cancel != nullptr && options.cancel->requested() && i > 0) return;
    Start start{static_cast<int>(i) + 1, options.trace_every > 0 ? &traces[i] : nullptr, {}};
    if (options.progress)
      start.progress = [&, i](double share, std::string_view what) {
        const std::lock_guard lock(telling);
        sum += share - shares[i], shares[i] = share;
        options.progress(sum / static_cast<double>(count), what);
      };
    done[i] = run_start(furniture, options, start);
  };
  core::parallel_for(count, options.threads, run);
  Outcome out;
  for (std::size_t i = 0; i < count; ++i) {
    if (done[i]) out.starts.push_back(std::move(*done[i]));
    out.trace.insert(out.trace.end(), traces[i].begin(), traces[i].end());
  }
  out.best = *std::ranges::min_element(out.starts, better);
  out.without_wall = without_wall(furniture, out.best);
  out.cancelled = options.cancel != nullptr && options.cancel->requested();
  return out;
}

Scene with_arrangement(Scene scene, const Arranged& arranged) {
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    Object& o = scene.objects[i];
    o.position = Vec3{arranged.poses[i].p.x, arranged.poses[i].p.y, arranged.bases[i]};
    o.angle = arranged.poses[i].angle;
    if (arranged.carriers[i] != kNobody) o.on = {Ref::Kind::object, arranged.carriers[i]};
  }
  for (Group& g : scene.groups) {
    if (g.rigid) g.position.reset(), g.angle.reset();
  }
  return scene;
}

}  // namespace inhabit::annealing
