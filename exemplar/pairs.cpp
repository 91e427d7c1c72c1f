#include "exemplar/pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/statistics.h"
#include "exemplar/cluster.h"
#include "scene/kind.h"

namespace inhabit::exemplar {
namespace {

constexpr double kNear = 0.8, kFarSeen = 6, kTouching = 0.35;
constexpr double kSteadyLength = 0.12, kSteadyShare = 0.15, kSteadyFacing = 25 * kPi / 180,
                 kSteadyBearing = 30 * kPi / 180;

double gap_between(const Thing& a, const Thing& b) { return std::max(0.0, -separation(a.box(), b.box()).depth); }

/// Seconds round one first, evenly: every gap between neighbouring bearings within a quarter of the mean gap, and all
/// look at it within 30 degrees.
bool evenly_round(std::vector<double> bearings, const std::vector<double>& facings) {
  if (bearings.size() < 3) return false;
  if (std::ranges::any_of(facings, [](double f) { return std::abs(f) > kPi / 6; })) return false;
  std::ranges::sort(bearings);
  const double mean = 2 * kPi / static_cast<double>(bearings.size());
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const double next = i + 1 < bearings.size() ? bearings[i + 1] : bearings[0] + 2 * kPi;
    if (std::abs(next - bearings[i] - mean) > 0.25 * mean) return false;
  }
  return true;
}

/// Of the groups of three and more, most stand evenly round their first.
bool is_concentric(const std::vector<PairSample>& samples) {
  std::map<int, std::pair<std::vector<double>, std::vector<double>>> groups;
  for (const PairSample& s : samples) {
    groups[s.first].first.push_back(s.bearing);
    groups[s.first].second.push_back(s.facing);
  }
  int large = 0, even = 0;
  for (const auto& [first, group] : groups) {
    if (group.first.size() < 3) continue;
    ++large, even += evenly_round(group.first, group.second) ? 1 : 0;
  }
  return large > 0 && even >= 0.7 * large;
}

void add_modes(PairFound& found) {
  std::vector<Sample> samples;
  const bool concentric = found.prior.concentric;
  for (const PairSample& s : found.evidence.samples)
    samples.push_back({s.distance, concentric ? std::array{s.facing, 0.0} : std::array{s.facing, s.bearing}});
  const Clustering clusters = cluster(samples, {.angles = concentric ? 1 : 2});
  double spread = 0, mean = 0, steady = 0;
  for (const Cluster& c : clusters.clusters) {
    PairMode mode;
    mode.distance = c.length, mode.distance_deviation = c.length_deviation;
    mode.facing = c.angles[0], mode.facing_deviation = c.angle_deviations[0];
    mode.bearing = c.angles[1], mode.bearing_deviation = concentric ? kPi : c.angle_deviations[1];
    mode.count = c.count;
    spread += c.count * c.length_deviation, mean += c.count * c.length;
    // A mode of one example varies by nothing, which shows nothing.
    if (c.count > 1 && c.length_deviation <= std::max(kSteadyLength, kSteadyShare * c.length) &&
        mode.facing_deviation <= kSteadyFacing && (concentric || mode.bearing_deviation <= kSteadyBearing))
      steady += c.count;
    found.prior.modes.push_back(mode);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) found.evidence.samples[i].mode = clusters.of[i];
  found.prior.spread = mean > 0 ? spread / mean : 0;
  found.steady = steady / std::max(1, found.prior.count);
}

Vec2 mean_size(std::span<const Thing> things, const std::string& kind) {
  Vec2 sum;
  double n = 0;
  for (const Thing& t : things)
    if (t.kind == kind) sum += Vec2{t.size.x, t.size.y}, ++n;
  return n > 0 ? (1 / n) * sum : sum;
}

struct KindSeen {
  std::set<int> rooms;
  int count = 0;
  double area = 0;
  bool seen = false;  ///< people sit down to look at it
  bool seat = false;
};

/// A television and an easel; a picture or a clock is glanced at.
bool sat_before(std::string_view kind) {
  return must_be_seen(kind) && kind_of(kind) != "picture" && words_of(kind, ' ').find("clock") == std::string::npos;
}
bool is_seat(std::string_view kind) {
  static constexpr std::array<std::string_view, 6> kSeats = {"sofa",  "armchair", "office chair",
                                                             "stool", "bench",    "chair"};
  return std::ranges::find(kSeats, kind_of(kind)) != kSeats.end();
}

/// What may stand in a pair that nobody named.
bool proposable(const Thing& t) {
  return !t.flat && t.mount != Mount::ceiling && ((t.on.empty() && t.mount == Mount::floor) || sat_before(t.kind));
}

bool convincing(const PairFound& found, const KindSeen& first, const KindSeen& second, int rooms) {
  if (found.prior.count < 3 || found.prior.rooms < std::min(2, rooms)) return false;
  if (found.prior.rooms < 0.5 * static_cast<double>(second.rooms.size())) return false;
  if (found.carried > 0 || std::max(found.steady, found.beside) < 0.7) return false;
  if (first.seen) return second.seat && found.gap <= kFarSeen && std::abs(found.prior.modes.front().facing) < kPi / 4;
  return found.gap <= kNear;
}

}  // namespace

bool must_be_seen(std::string_view kind) {
  const std::string_view known = kind_of(kind);
  if (known == "tv" || known == "picture") return true;
  const std::string words = " " + words_of(kind, ' ') + " ";
  for (const std::string_view word : {" clock ", " easel ", " whiteboard ", " board ", " sign ", " poster "})
    if (words.find(word) != std::string::npos) return true;
  return false;
}

PairFound find_pair(std::span<const Thing> things, const std::string& first, const std::string& second) {
  PairFound found;
  found.prior.first = first, found.prior.second = second;
  std::map<std::size_t, int> firsts;  // those that somebody belongs to, and all others of their rooms
  std::set<int> rooms;
  std::vector<double> gaps;
  for (const Thing& b : things) {
    if (b.kind != second) continue;
    std::pair nearest{1e300, 1e300};
    const Thing* a = nullptr;
    for (const Thing& candidate : std::ranges::equal_range(things, b.room, {}, &Thing::room)) {
      if (candidate.kind != first || &candidate == &b) continue;
      const std::pair at{gap_between(candidate, b), length(candidate.pose.p - b.pose.p)};
      if (at < nearest) nearest = at, a = &candidate;
    }
    if (a == nullptr) continue;
    const auto number = static_cast<std::size_t>(a - things.data());
    const Vec2 way = b.pose.p - a->pose.p;
    PairSample s;
    s.distance = length(way);
    s.bearing = wrap_angle(angle_of(way) - a->pose.angle);
    s.facing = wrap_angle(b.pose.angle - angle_of(-way));
    s.room = b.room, s.first = firsts.emplace(number, static_cast<int>(firsts.size())).first->second;
    found.evidence.samples.push_back(s);
    rooms.insert(b.room), gaps.push_back(nearest.first);
    found.beside += nearest.first <= kTouching ? 1 : 0;
    found.carried += a->on == second || b.on == first ? 1 : 0;
  }
  found.prior.count = static_cast<int>(found.evidence.samples.size());
  found.prior.rooms = static_cast<int>(rooms.size());
  if (found.prior.count == 0) return found;
  found.beside /= found.prior.count, found.carried /= found.prior.count;
  int all = 0;
  for (const Thing& t : things) all += t.kind == first && rooms.contains(t.room);
  found.prior.per_first = static_cast<double>(found.prior.count) / all;
  found.gap = median(gaps);
  found.prior.concentric = is_concentric(found.evidence.samples);
  found.evidence.first_size = mean_size(things, first), found.evidence.second_size = mean_size(things, second);
  add_modes(found);
  return found;
}

std::vector<PairFound> propose_pairs(std::span<const Thing> things, int rooms) {
  std::map<std::string, KindSeen> kinds;
  for (const Thing& t : things) {
    if (!proposable(t)) continue;
    KindSeen& kind = kinds[t.kind];
    kind.rooms.insert(t.room), ++kind.count;
    kind.area += t.box().area(), kind.seen = sat_before(t.kind), kind.seat = is_seat(t.kind);
  }
  std::vector<PairFound> all;
  for (const auto& [second, b] : kinds) {
    if (b.seen) continue;
    std::vector<PairFound> candidates;
    for (const auto& [first, a] : kinds) {
      // The larger of two is the one that others belong to; what is seen is always looked at.
      if (first == second || (!a.seen && a.area / a.count < b.area / b.count)) continue;
      PairFound found = find_pair(things, first, second);
      if (found.prior.count > 0 && convincing(found, a, b, rooms)) candidates.push_back(std::move(found));
    }
    std::ranges::stable_sort(candidates, [](const PairFound& x, const PairFound& y) {
      return std::pair(x.gap, x.prior.spread) < std::pair(y.gap, y.prior.spread);
    });
    // The nearest, and of what a seat looks at the nearest, too.
    bool seen = false, beside = false;
    for (PairFound& candidate : candidates) {
      bool& taken = kinds[candidate.prior.first].seen ? seen : beside;
      if (!taken) all.push_back(std::move(candidate));
      taken = true;
    }
  }
  std::ranges::stable_sort(all, [](const PairFound& x, const PairFound& y) {
    return std::tie(x.prior.first, x.prior.second) < std::tie(y.prior.first, y.prior.second);
  });
  return all;
}

}  // namespace inhabit::exemplar
