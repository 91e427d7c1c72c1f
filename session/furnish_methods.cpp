#include "session/furnish_methods.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/text.h"
#include "session/prior_scene.h"

namespace inhabit::session {
namespace {

/// Rounds of new starts for as long as something is wrong with the best of all. The first has the weights as they are;
/// in those that follow what people need (free spaces, views, pathways) weighs more and more: a view's weight of 0.01
/// (Yu et al. 4.3) is little beside a metre off the wall's 1.
constexpr int kRounds = 14;
constexpr std::array<double, kRounds> kNeeds = {1, 10, 10, 50, 50, 50, 10, 50, 200, 10, 50, 200, 50, 200};
/// From this round on every search has other clustered means for its objects: some sets of them have no good place.
constexpr int kOtherMeans = 4;

Suggestion judged(Scene scene, layout::Layout layout) {
  Suggestion s;
  s.report = layout::check(scene);
  s.scene = std::move(scene);
  s.layout = std::move(layout);
  return s;
}

layout::Placement placement_of(const Scene& scene) {
  layout::Placement placement;
  for (const Object& o : scene.objects) placement.objects.push_back({o.position.value_or(Vec3{}), o.angle.value_or(0)});
  placement.groups.resize(scene.groups.size());
  return placement;
}

/// As layout::suggest has it: some object differs by more than its own size, or by 45 degrees.
bool distinct(const Scene& a, const Scene& b) {
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const Object &p = a.objects[i], &q = b.objects[i];
    if (length(p.position->xy() - q.position->xy()) > std::max(p.size.x, p.size.y)) return true;
    if (std::abs(wrap_angle(*p.angle - *q.angle)) > kPi / 4) return true;
  }
  return false;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// An annealed arrangement on its way to a suggestion.
struct Candidate {
  Suggestion suggestion;
  Faults faults;
  double cost = 0;
};
bool better(const Candidate& a, const Candidate& b) {
  if (a.faults != b.faults) return a.faults < b.faults;
  return a.cost < b.cost;
}

/// Furnishes one room by annealing, as often as it takes.
class Search {
 public:
  Search(const Scene& scene, const FurnishJob& job) : scene_(scene), job_(job), both_(job.method == Method::both) {}

  /// One suggestion. `variant` 0 is the seed itself.
  Result<Candidate> run(int variant, Found& found) {
    const std::uint64_t seed = job_.layout.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(variant);
    annealing::Targets targets = annealing::choose_targets(scene_, *job_.priors, seed);
    Scene asked = with_targets(scene_, targets);
    if (variant == 0) found.notes = targets.warnings;
    std::optional<Candidate> best;
    std::vector<std::string> homeless;
    const int rounds = both_ ? kRounds : 1;
    for (int round = 0; round < rounds; ++round) {
      if (round >= kOtherMeans) {
        targets = annealing::choose_targets(scene_, *job_.priors, seed + static_cast<std::uint64_t>(round));
        asked = with_targets(scene_, targets);
      }
      annealing::Options options = job_.anneal;
      options.seed = seed + static_cast<std::uint64_t>(round) * 7919;
      CostWeights& weights = options.weights.learned;
      const double needs = kNeeds[static_cast<std::size_t>(round)];
      weights.accessibility *= needs, weights.visibility *= needs, weights.pathway *= needs;
      options.starts = job_.layout.starts, options.threads = job_.layout.threads;
      options.cancel = job_.layout.cancel;
      options.trace_every = round == 0 && variant == 0 ? job_.anneal.trace_every : 0;
      if (round == 0) options.progress = job_.layout.progress;
      Result<annealing::Outcome> outcome = annealing::arrange(scene_, targets, options);
      if (!outcome) return outcome.error();
      if (options.trace_every > 0) found.anneal_trace = std::move(outcome->trace);
      found.cancelled = found.cancelled || outcome->cancelled;
      judge(asked, *outcome, best, homeless);
      if (best->faults.none() || found.cancelled) break;
    }
    if (variant == 0 && !homeless.empty()) found.notes.push_back("found no wall to stand at: " + joined(homeless));
    return std::move(*best);
  }

 private:
  void judge(const Scene& asked, const annealing::Outcome& outcome, std::optional<Candidate>& best,
             std::vector<std::string>& homeless) const {
    std::vector<const annealing::Arranged*> ranked;
    for (const annealing::Arranged& a : outcome.starts) ranked.push_back(&a);
    std::ranges::stable_sort(ranked, {}, [](const annealing::Arranged* a) { return std::pair(!a->fits, a->cost); });
    for (const annealing::Arranged* a : ranked) {
      Candidate c = both_ ? settled(asked, *a) : as_annealed(asked, *a);
      if (!best || better(c, *best)) best = std::move(c), homeless = outcome.without_wall;
      // The rest cost more: only what is wrong is worth looking further for.
      if (!both_ || best->faults.none()) break;
    }
  }

  Candidate as_annealed(const Scene& asked, const annealing::Arranged& a) const {
    Scene scene = annealing::with_arrangement(asked, a);
    layout::Layout layout;
    layout.placement = placement_of(scene);
    layout.start = a.start, layout.iterations = static_cast<int>(std::min<std::int64_t>(a.iterations, 2000000000));
    layout.seconds = a.seconds;
    Candidate c{judged(std::move(scene), std::move(layout)), {}, a.cost};
    c.suggestion.layout.feasible = c.suggestion.report.feasible;
    c.suggestion.layout.energy = c.suggestion.report.energy;
    c.faults = faults_of(c.suggestion.scene, c.suggestion.report);
    return c;
  }

  /// Projection from where annealing left everything, with the pathways as zones.
  Candidate settled(const Scene& asked, const annealing::Arranged& a) const {
    Candidate annealed = as_annealed(asked, a);
    Scene problem = annealed.suggestion.scene;
    add_path_zones(problem, a.paths, job_.anneal.path_width);
    layout::Options options = job_.layout;
    options.start = layout::Start::given, options.paper = false, options.trace = false;
    options.progress = nullptr;
    Result<layout::Outcome> outcome = layout::furnish(problem, options);
    if (!outcome) return annealed;
    Candidate c{
        judged(layout::with_placement(annealed.suggestion.scene, outcome->best.placement), outcome->best), {}, a.cost};
    c.suggestion.layout.iterations += annealed.suggestion.layout.iterations;
    c.suggestion.layout.start = a.start;
    c.suggestion.layout.feasible = c.suggestion.report.feasible;
    c.suggestion.layout.energy = c.suggestion.report.energy;
    c.faults = faults_of(c.suggestion.scene, c.suggestion.report);
    // Settling is for what annealing left undone; it must not undo what was done.
    return better(annealed, c) ? annealed : c;
  }

  const Scene& scene_;
  const FurnishJob& job_;
  bool both_;
};

}  // namespace

Faults faults_of(const Scene& scene, const layout::CheckReport& report) {
  Faults f;
  f.bodies = report.overlap_count + report.outside.size();
  f.doors = report.blocked_doors.size();
  f.views = report.views.size();
  f.spaces = report.clearances.size();
  for (const Object& o : scene.objects) {
    const auto& list = report.reachable.unreachable;
    if (o.clearance.any() && std::ranges::find(list, o.id) != list.end()) ++f.unreachable;
  }
  return f;
}

Result<Found> furnish_by_projection(const Scene& original, const FurnishJob& job) {
  Found found;
  Scene scene = original, problem;
  layout::Options options = job.layout;
  if (job.priors) {
    const annealing::Targets targets = annealing::choose_targets(original, *job.priors, job.layout.seed);
    scene = with_targets(original, targets);
    found.notes = targets.warnings;
  }
  problem = scene;
  if (job.priors) {
    const auto paths = empty_room_paths(scene, job.layout.seed, job.anneal.path_width);
    add_path_zones(problem, paths, job.anneal.path_width);
  }
  std::vector<layout::Layout> layouts;
  if (job.variants > 1) {
    Result<std::vector<layout::Layout>> several = layout::suggest(problem, options, job.variants);
    if (!several) return several.error();
    layouts = std::move(*several);
    found.cancelled = options.cancel != nullptr && options.cancel->requested();
  } else {
    Result<layout::Outcome> outcome = layout::furnish(problem, options);
    if (!outcome) return outcome.error();
    layouts.push_back(std::move(outcome->best));
    found.trace = std::move(outcome->trace);
    found.cancelled = outcome->cancelled;
  }
  for (layout::Layout& layout : layouts) {
    Scene placed = layout::with_placement(scene, layout.placement);
    found.list.push_back(judged(std::move(placed), std::move(layout)));
  }
  return found;
}

Result<Found> furnish_by_annealing(const Scene& scene, const FurnishJob& job) {
  if (!job.priors) return invalid("", "annealing needs priors: learn them from furnished rooms (inhabit learn)");
  Found found;
  std::vector<Candidate> chosen;
  Search search(scene, job);
  for (int variant = 0; variant < 8 * job.variants && static_cast<int>(chosen.size()) < job.variants; ++variant) {
    Result<Candidate> candidate = search.run(variant, found);
    if (!candidate) return candidate.error();
    const bool fresh = std::ranges::all_of(
        chosen, [&](const Candidate& c) { return distinct(c.suggestion.scene, candidate->suggestion.scene); });
    if (fresh) chosen.push_back(std::move(*candidate));
    if (found.cancelled) break;
  }
  std::ranges::stable_sort(chosen, better);
  for (Candidate& c : chosen) found.list.push_back(std::move(c.suggestion));
  return found;
}

Status set_weight(annealing::Weights& weights, std::string_view name, double value) {
  std::string wanted(name);
  std::ranges::replace(wanted, '-', ' ');
  std::ranges::replace(wanted, '_', ' ');
  CostWeights& w = weights.learned;
  const std::pair<std::string_view, double*> known[] = {
      {"accessibility", &w.accessibility}, {"visibility", &w.visibility}, {"pathway", &w.pathway},
      {"wall distance", &w.wall_distance}, {"wall angle", &w.wall_angle}, {"pair distance", &w.pair_distance},
      {"pair angle", &w.pair_angle},       {"overlap", &weights.overlap}, {"inside", &weights.inside}};
  std::vector<std::string_view> names;
  for (const auto& [known_name, weight] : known) {
    if (known_name == wanted) {
      *weight = value;
      return Done{};
    }
    names.push_back(known_name);
  }
  return invalid("", "no cost term called " + std::string(name) + did_you_mean(wanted, names));
}

}  // namespace inhabit::session
