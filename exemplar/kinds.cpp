#include "exemplar/kinds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/statistics.h"
#include "exemplar/cluster.h"
#include "exemplar/pairs.h"

namespace inhabit::exemplar {
namespace {

constexpr double kVotes = 0.5, kTie = 0.05, kLeastAccess = 0.1;

/// In the first tier, standing: what people walk up to.
bool stands(const Thing& t) { return t.mount == Mount::floor && t.on.empty() && !t.flat; }

std::vector<WallMode> wall_modes(std::vector<WallSample>& samples) {
  std::vector<Sample> points;
  for (const WallSample& s : samples) points.push_back({s.distance, {s.angle, 0}});
  const Clustering found = cluster(points, {.angles = 1});
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].mode = found.of[i];
  std::vector<WallMode> modes;
  for (const Cluster& c : found.clusters)
    modes.push_back({c.length, c.angles[0], c.length_deviation, c.angle_deviations[0], c.count});
  return modes;
}

std::vector<Support> supports(Things things) {
  std::map<std::pair<int, std::string>, int> counts;
  for (const Thing* t : things) ++counts[{t->on.empty() ? static_cast<int>(t->mount) : 0, t->on}];
  std::vector<Support> list;
  for (const auto& [key, count] : counts) list.push_back({static_cast<Mount>(key.first), key.second, count});
  std::ranges::stable_sort(list, [](const Support& a, const Support& b) { return a.count > b.count; });
  return list;
}

/// How far people look at it: as the scenes say, or the free depth in front; 1 to 4 m.
std::optional<View> learned_view(Things things) {
  std::vector<double> given, angles, seen;
  for (const Thing* t : things) {
    if (t->view) given.push_back(t->view->distance), angles.push_back(t->view->angle);
    seen.push_back(t->faces[static_cast<std::size_t>(Face::front)].free);
  }
  if (!given.empty()) return View{median(given), median(angles)};
  if (!must_be_seen(things.front()->kind)) return std::nullopt;
  return View{std::clamp(median(seen), 1.0, kLookDepth), radians(45)};
}

double mean_elevation(Things things) {
  double sum = 0, n = 0;
  for (const Thing* t : things)
    if (t->mount == Mount::wall) sum += t->base, ++n;
  return n > 0 ? sum / n : 0;
}

}  // namespace

WallSample wall_sample(const Thing& t, Face back, const Scene& scene) {
  const Ring& outline = scene.space.outline;
  const Vec2 center = face_center(t.pose, t.size, back);
  const Nearest nearest = nearest_on_ring(outline, center);
  const Vec2 wall = outline[(nearest.side + 1) % outline.size()] - outline[nearest.side];
  WallSample sample;
  sample.distance = contains(outline, center) ? nearest.distance : -nearest.distance;
  sample.angle = wrap_angle(angle_of(-face_normal(t.pose, back)) - angle_of(perp(wall)));
  sample.room = t.room;
  return sample;
}

BackVote vote_back(Things things) {
  std::array<int, 4> votes{};
  int all = 0;
  for (const Thing* t : things) {
    std::size_t nearest = 0;
    for (std::size_t f = 1; f < 4; ++f)
      if (t->faces[f].wall < t->faces[nearest].wall - (nearest == 0 ? kTie : 0)) nearest = f;
    if (t->faces[nearest].wall > kVotes) continue;
    ++votes[nearest], ++all;
  }
  if (all == 0) return {};
  const auto most = static_cast<std::size_t>(std::ranges::max_element(votes) - votes.begin());
  const bool other = most != 0 && votes[most] >= 3 && votes[most] >= 0.75 * all;
  const std::size_t chosen = other ? most : 0;
  return {static_cast<Face>(chosen), static_cast<double>(votes[chosen]) / all};
}

double access_depth(Things things, Face face) {
  std::vector<double> free;
  for (const Thing* t : things) {
    if (!stands(*t)) continue;
    const FaceSeen& seen = t->faces[static_cast<std::size_t>(face)];
    if (!seen.at_wall) free.push_back(seen.free);
  }
  if (free.empty()) return 0;
  const double depth = std::min(quantile(free, 0.25), kAdultDepth);
  return depth < kLeastAccess ? 0 : depth;
}

KindFound find_kind_prior(Things things, std::span<const Scene> rooms) {
  KindFound found;
  KindPrior& prior = found.prior;
  prior.kind = things.front()->kind, prior.count = static_cast<int>(things.size());
  std::set<int> in;
  for (const Thing* t : things) in.insert(t->room);
  prior.rooms = static_cast<int>(in.size());
  const BackVote back = vote_back(things);
  prior.back = back.face, prior.back_share = back.share;
  for (const Thing* t : things) {
    if (t->mount != Mount::ceiling)
      found.evidence.wall.push_back(wall_sample(*t, back.face, rooms[static_cast<std::size_t>(t->room)]));
    std::array<double, 4> free{};
    for (std::size_t f = 0; f < 4; ++f) free[f] = t->faces[f].free;
    found.evidence.free_depth.push_back(free);
  }
  prior.wall = wall_modes(found.evidence.wall);
  prior.support = supports(things);
  for (std::size_t f = 0; f < 4; ++f) prior.access[f] = access_depth(things, static_cast<Face>(f));
  prior.view = learned_view(things);
  prior.elevation = mean_elevation(things);
  return found;
}

}  // namespace inhabit::exemplar
