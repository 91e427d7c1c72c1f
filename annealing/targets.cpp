#include "annealing/targets.h"

#include <algorithm>
#include <map>

#include "core/angle.h"

namespace inhabit::annealing {
namespace {

/// Seconds of a pair that stand farther from a wall than this are placed by their partner alone.
constexpr double kAtWall = 0.25;

/// Streams of the random numbers, apart from those of the search.
constexpr std::uint64_t kWallStream = 0x7a11, kPairStream = 0x9a12;

/// The index of the mode that the share u in [0, 1) of all examples falls to. Modes without counts share evenly.
template <class Mode>
std::size_t mode_at(const std::vector<Mode>& modes, double u) {
  double all = 0;
  for (const Mode& m : modes) all += std::max(m.count, 0);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < modes.size(); ++k) {
    sum += all > 0 ? std::max(modes[k].count, 0) / all : 1.0 / static_cast<double>(modes.size());
    if (u < sum) return k;
  }
  return modes.size() - 1;
}

class Chooser {
 public:
  Chooser(const Scene& scene, const Priors& priors, std::uint64_t seed) : scene_(scene), priors_(priors), seed_(seed) {
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) of_kind_[prior_kind(scene.objects[i])].push_back(i);
  }

  Targets run() {
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) out_.objects.push_back(object(i));
    for (const PairPrior& pair : priors_.pairs) gather(pair);
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) carry(i);
    warn_of_kinds();
    return std::move(out_);
  }

 private:
  ObjectTarget object(std::uint32_t i) const {
    const Object& o = scene_.objects[i];
    ObjectTarget target;
    target.prior = priors_.of(prior_kind(o));
    target.mount = o.mount;
    target.view = o.view;
    if (o.clearance.any()) target.access = {o.clearance.back, o.clearance.left, o.clearance.front, o.clearance.right};
    if (target.prior == nullptr) return target;
    const KindPrior& prior = *target.prior;
    target.back = prior.back;
    if (!o.clearance.any()) target.access = prior.access;
    if (!target.view) target.view = prior.view;
    if (o.mount == Mount::floor && o.on.none() && !o.position && !prior.support.empty() &&
        prior.support.front().on.empty())
      target.mount = prior.support.front().mount;
    if (!prior.wall.empty()) {
      Rng rng(seed_ ^ kWallStream, i);
      target.wall = prior.wall[mode_at(prior.wall, rng.uniform())];
    }
    return target;
  }

  /// Seconds go to their firsts evenly, in the order of the document.
  void gather(const PairPrior& pair) {
    const auto first = of_kind_.find(pair.first), second = of_kind_.find(pair.second);
    if (first == of_kind_.end() || second == of_kind_.end() || pair.modes.empty()) return;
    const std::vector<std::uint32_t>&firsts = first->second, &seconds = second->second;
    if (pair.first == pair.second) return gather_equals(pair, firsts);
    // No more firsts than the seconds need: two chairs of three desks stand at two of them.
    const double each = std::max(1.0, pair.per_first);
    const std::size_t wanted = static_cast<std::size_t>(std::ceil(static_cast<double>(seconds.size()) / each - 1e-9));
    const std::size_t used = each > 1.5 ? firsts.size() : std::min(firsts.size(), std::max<std::size_t>(wanted, 1));
    for (std::size_t f = 0; f < used; ++f) {
      const std::size_t begin = seconds.size() * f / used, end = seconds.size() * (f + 1) / used;
      seat(pair, firsts[f], {seconds.data() + begin, end - begin});
    }
  }

  /// Two of one kind (the gallery's chairs): first and second, third and fourth.
  void gather_equals(const PairPrior& pair, const std::vector<std::uint32_t>& all) {
    for (std::size_t k = 0; k + 1 < all.size(); k += 2) seat(pair, all[k], {all.data() + k + 1, 1});
  }

  /// Shares the modes out among those round one object: systematic sampling, so that the shares are kept as well as
  /// whole numbers can, in an order of chance.
  void seat(const PairPrior& pair, std::uint32_t first, std::span<const std::uint32_t> seconds) {
    if (seconds.empty()) return;
    Rng rng(seed_ ^ kPairStream, first);
    const auto n = static_cast<std::uint32_t>(seconds.size());
    const double u = rng.uniform();
    std::vector<std::size_t> modes;
    for (std::uint32_t k = 0; k < n; ++k) modes.push_back(mode_at(pair.modes, (k + u) / n));
    for (std::uint32_t k = n; k > 1; --k) std::swap(modes[k - 1], modes[rng.index(k)]);
    for (std::uint32_t k = 0; k < n; ++k) {
      out_.pairs.push_back({first, seconds[k], pair.modes[modes[k]], pair.concentric});
      // Deviation: the paper draws a chair to its table and, as strongly, to the distance and angle that chairs have to
      // walls on average, which contradict each other wherever the table stands.
      auto& wall = out_.objects[seconds[k]].wall;
      if (wall && wall->distance > kAtWall) wall.reset();
    }
  }

  /// What object i stands on: the scene's word, else by the prior; near its partner if that has something to do with a
  /// carrier, else in turns.
  void carry(std::uint32_t i) {
    const Object& o = scene_.objects[i];
    ObjectTarget& target = out_.objects[i];
    std::vector<std::string> kinds;
    if (o.on.kind == Ref::Kind::object) {
      kinds.push_back(prior_kind(scene_.objects[o.on.index]));
      target.carrier = o.on.index;
    } else if (o.mount == Mount::floor && !o.position && target.prior != nullptr) {
      for (const Support& s : target.prior->support) {
        if (s.on.empty() && kinds.empty()) return;  // mostly on the floor or on a wall
        if (!s.on.empty()) kinds.push_back(s.on);
      }
    }
    if (kinds.empty()) return;
    for (const std::string& kind : kinds) {
      const auto found = of_kind_.find(kind);
      if (found == of_kind_.end()) continue;
      for (const std::uint32_t c : found->second)
        if (c != i && can_carry(c, i)) target.carriers.push_back(c);
    }
    std::ranges::sort(target.carriers);
    if (target.carrier != kNobody) return;
    if (target.carriers.empty()) {
      out_.warnings.push_back("\"" + o.id + "\" (" + prior_kind(o) + ") stands on the floor: there is no " +
                              kinds.front() + " to carry it");
      return;
    }
    target.carrier = near_partner(i).value_or(target.carriers[turn_[prior_kind(o)]++ % target.carriers.size()]);
  }

  /// A first-tier object that is large enough.
  bool can_carry(std::uint32_t c, std::uint32_t i) const {
    const Object &below = scene_.objects[c], &above = scene_.objects[i];
    return below.on.none() && below.mount == Mount::floor &&
           std::min(above.size.x, above.size.y) <= std::max(below.size.x, below.size.y);
  }

  /// A dish set stands on the table of its chair.
  std::optional<std::uint32_t> near_partner(std::uint32_t i) const {
    for (const PairTarget& p : out_.pairs) {
      if (p.second != i && p.first != i) continue;
      const std::uint32_t partner = p.second == i ? p.first : p.second;
      const auto& carriers = out_.objects[i].carriers;
      if (std::ranges::binary_search(carriers, partner)) return partner;
      for (const PairTarget& q : out_.pairs) {
        const std::uint32_t other = q.first == partner ? q.second : q.second == partner ? q.first : kNobody;
        if (other != kNobody && other != i && std::ranges::binary_search(carriers, other)) return other;
      }
    }
    return std::nullopt;
  }

  void warn_of_kinds() {
    for (const auto& [kind, list] : of_kind_) {
      const KindPrior* prior = priors_.of(kind);
      const std::string name = kind.empty() ? "objects without a kind" : "\"" + kind + "\"";
      const std::string many = std::to_string(list.size()) + (list.size() == 1 ? " object" : " objects");
      if (prior == nullptr) {
        out_.warnings.push_back("nothing is known of " + name + " (" + many +
                                "): " + "they only keep clear of others; write a prior of your own for it");
      } else if (prior->count <= 1 && !prior->by_hand) {
        out_.warnings.push_back("the prior of " + name + " rests on one example");
      }
    }
  }

  const Scene& scene_;
  const Priors& priors_;
  std::uint64_t seed_;
  std::map<std::string, std::vector<std::uint32_t>> of_kind_;
  std::map<std::string, std::size_t> turn_;
  Targets out_;
};

}  // namespace

double angle_strength(double deviation) {
  return std::clamp((radians(90) - std::abs(deviation)) / radians(60), 0.0, 1.0);
}

Targets choose_targets(const Scene& scene, const Priors& priors, std::uint64_t seed) {
  return Chooser(scene, priors, seed).run();
}

}  // namespace inhabit::annealing
