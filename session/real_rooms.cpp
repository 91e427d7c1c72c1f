#include "session/real_rooms.h"

#include <algorithm>
#include <cmath>

#include "exemplar/kinds.h"
#include "exemplar/learn.h"
#include "exemplar/pairs.h"
#include "layout/check.h"
#include "layout/house_rules.h"
#include "session/jobs.h"
#include "session/learn_job.h"

namespace inhabit::session {
namespace {

constexpr std::size_t kLeastValues = 3;

bool is_movable(const Object& o) { return !o.fixed && o.mount == Mount::floor && o.on.none(); }

std::size_t movable(const Scene& scene) {
  return static_cast<std::size_t>(std::ranges::count_if(scene.objects, is_movable));
}

/// The wishes of learned priors as the clearances that check looks at.
Scene with_access(Scene room, const scene::Priors& priors) {
  for (Object& o : room.objects) {
    const scene::KindPrior* prior = priors.of(scene::prior_kind(o));
    if (prior == nullptr || !is_movable(o)) continue;
    o.clearance = {
        .front = prior->access[2], .back = prior->access[0], .left = prior->access[1], .right = prior->access[3]};
  }
  return room;
}

/// The area between the distribution functions of two samples.
double between(std::vector<double> a, std::vector<double> b) {
  std::ranges::sort(a);
  std::ranges::sort(b);
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  std::ranges::sort(all);
  double area = 0;
  std::size_t i = 0, k = 0;
  for (std::size_t n = 0; n + 1 < all.size(); ++n) {
    while (i < a.size() && a[i] <= all[n]) ++i;
    while (k < b.size() && b[k] <= all[n]) ++k;
    const double gap =
        static_cast<double>(i) / static_cast<double>(a.size()) - static_cast<double>(k) / static_cast<double>(b.size());
    area += std::abs(gap) * (all[n + 1] - all[n]);
  }
  return area;
}

void append(Features& to, const Features& from) {
  for (const auto& [key, values] : from) to[key].insert(to[key].end(), values.begin(), values.end());
}

}  // namespace

Result<std::vector<HeldOut>> held_out_homes(std::span<const Document> homes, std::size_t least) {
  std::vector<HeldOut> all;
  for (std::size_t h = 0; h < homes.size(); ++h) {
    std::vector<Document> others;
    for (std::size_t i = 0; i < homes.size(); ++i)
      if (i != h) others.push_back(homes[i]);
    const Result<exemplar::Learned> learned = learn_job(others, {});
    if (!learned) return learned.error();
    HeldOut held{homes[h].name, learned->priors, {}};
    for (const Scene& room : homes[h].scenes)
      if (movable(room) >= least) held.rooms.push_back(room);
    all.push_back(std::move(held));
  }
  return all;
}

std::vector<RealMethod> real_methods(const layout::Options& base) {
  const auto by_priors = [base](Method method) {
    return [base, method](const Scene& stripped, const scene::Priors& priors, std::uint64_t seed) -> Result<Scene> {
      FurnishJob job;
      job.method = method, job.priors = priors, job.layout = base;
      job.layout.seed = seed, job.layout.threads = 1, job.layout.start = layout::Start::random;
      job.anneal.given = false;
      Document room;
      room.scenes = {stripped};
      Result<Furnished> furnished = furnish_job(room, job);
      if (!furnished) return furnished.error();
      return std::move(furnished->rooms.front().suggestions.front().scene);
    };
  };
  const auto place = [base](const Scene& scene, std::uint64_t seed) -> Result<Scene> {
    layout::Options options = base;
    options.seed = seed, options.threads = 1, options.start = layout::Start::random;
    const Result<layout::Outcome> outcome = layout::furnish(scene, options);
    if (!outcome) return outcome.error();
    return layout::with_placement(scene, outcome->best.placement);
  };
  return {{"no wishes",
           [place](const Scene& stripped, const scene::Priors&, std::uint64_t seed) { return place(stripped, seed); }},
          {"house rules",
           [place](const Scene& stripped, const scene::Priors&, std::uint64_t seed) {
             Scene scene = stripped;
             layout::add_house_rules(scene);
             return place(scene, seed);
           }},
          {"priors, projected", by_priors(Method::pbd)},
          {"priors, annealed", by_priors(Method::anneal)},
          {"priors, both", by_priors(Method::both)}};
}

void RoomFeatures::add(const RoomFeatures& other) {
  append(wall_distance, other.wall_distance), append(wall_angle, other.wall_angle);
  append(pair_distance, other.pair_distance), append(pair_facing, other.pair_facing);
}

RoomFeatures room_features(const Scene& room, const scene::Priors& priors) {
  RoomFeatures out;
  const exemplar::Observed seen = exemplar::observe(room, 0);
  for (const exemplar::Thing& thing : seen.things) {
    const Object& o = room.objects[thing.object];
    if (!is_movable(o) || thing.flat) continue;
    const scene::WallSample at = exemplar::wall_sample(thing, scene::Face::back, room);
    out.wall_distance[thing.kind].push_back(at.distance);
    out.wall_angle[thing.kind].push_back(std::abs(degrees(at.angle)));
  }
  for (const scene::PairPrior& pair : priors.pairs) {
    const exemplar::PairFound found = exemplar::find_pair(seen.things, pair.first, pair.second);
    const std::string key = pair.first + " & " + pair.second;
    for (const scene::PairSample& s : found.evidence.samples) {
      out.pair_distance[key].push_back(s.distance);
      out.pair_facing[key].push_back(std::abs(degrees(s.facing)));
    }
  }
  return out;
}

void RoomQuality::add(const Scene& room, const scene::Priors& priors) {
  const Scene asking = with_access(room, priors);
  const layout::CheckReport report = layout::check(asking, {.threads = 1});
  ++rooms;
  feasible += report.feasible ? 1 : 0, doors_free += report.blocked_doors.empty() ? 1 : 0;
  all_reachable += report.reachable.unreachable.empty() ? 1 : 0;
  walkable_share += report.walkable_share;
  for (const Object& o : asking.objects)
    for (const double depth : {o.clearance.front, o.clearance.back, o.clearance.left, o.clearance.right})
      faces += depth > 0 ? 1 : 0;
  faces_blocked +=
      static_cast<int>(std::ranges::count_if(report.clearances, [](const auto& c) { return c.blocked_share > 0.1; }));
}

double difference(const Features& human, const Features& other) {
  double sum = 0, weight = 0;
  for (const auto& [key, values] : human) {
    const auto found = other.find(key);
    if (found == other.end() || values.size() < kLeastValues || found->second.size() < kLeastValues) continue;
    const double n = static_cast<double>(values.size());
    sum += n * between(values, found->second), weight += n;
  }
  return weight > 0 ? sum / weight : 0;
}

}  // namespace inhabit::session
