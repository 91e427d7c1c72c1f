#include "exemplar/learn.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "exemplar/kinds.h"
#include "exemplar/pairs.h"
#include "scene/kind.h"

namespace inhabit::exemplar {
namespace {

constexpr std::size_t kMostNotes = 20;

double rounded_length(double v) { return std::round(v * 1e4) / 1e4; }
double rounded_angle(double v) { return wrap_angle(radians(std::round(degrees(v) * 100) / 100)); }
double rounded_share(double v) { return std::round(v * 1e3) / 1e3; }

void round_off(KindPrior& prior) {
  prior.back_share = rounded_share(prior.back_share);
  prior.elevation = rounded_length(prior.elevation);
  for (double& depth : prior.access) depth = rounded_length(depth);
  if (prior.view) prior.view = View{rounded_length(prior.view->distance), rounded_angle(prior.view->angle)};
  for (WallMode& mode : prior.wall) {
    mode.distance = rounded_length(mode.distance), mode.distance_deviation = rounded_length(mode.distance_deviation);
    mode.angle = rounded_angle(mode.angle), mode.angle_deviation = rounded_angle(mode.angle_deviation);
  }
}

void round_off(PairPrior& prior) {
  prior.per_first = rounded_share(prior.per_first), prior.spread = rounded_share(prior.spread);
  for (PairMode& mode : prior.modes) {
    mode.distance = rounded_length(mode.distance), mode.distance_deviation = rounded_length(mode.distance_deviation);
    for (double* angle : {&mode.bearing, &mode.facing, &mode.bearing_deviation, &mode.facing_deviation})
      *angle = rounded_angle(*angle);
  }
}

class Learner {
 public:
  Learner(std::span<const Scene> rooms, const LearnOptions& options) : rooms_(rooms), options_(options) {}

  Result<Learned> run() {
    if (rooms_.empty()) return invalid("", "there is no room to learn from");
    look_at_rooms();
    if (things_.empty()) {
      const std::string why = out_.notes.empty() ? "" : " (" + out_.notes.front() + ")";
      return invalid("", "there is nothing to learn from: no room has anything placed in it" + why);
    }
    learn_kinds();
    if (const Status named = learn_named_pairs(); !named) return named.error();
    propose();
    note_what_is_weak();
    return std::move(out_);
  }

 private:
  void look_at_rooms() {
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      const int room = static_cast<int>(i);
      out_.priors.rooms.push_back(rooms_[i].name.empty() ? "room " + std::to_string(i + 1) : rooms_[i].name);
      Observed seen = observe(rooms_[i], room);
      for (const std::string& why : seen.skipped) note(out_.priors.rooms.back() + ": " + why);
      if (seen.things.empty()) note(out_.priors.rooms.back() + ": nothing is placed in it");
      furnished_ += seen.things.empty() ? 0 : 1;
      things_.insert(things_.end(), seen.things.begin(), seen.things.end());
    }
    out_.things = static_cast<int>(things_.size());
  }

  void note(std::string text) {
    ++notes_;
    if (notes_ <= kMostNotes) out_.notes.push_back(std::move(text));
  }

  void learn_kinds() {
    std::map<std::string, std::vector<const Thing*>> by_kind;
    for (const Thing& t : things_) by_kind[t.kind].push_back(&t);
    for (const auto& [kind, list] : by_kind) {
      KindFound found = find_kind_prior(list, rooms_);
      round_off(found.prior);
      kinds_.push_back(kind);
      out_.priors.kinds.push_back(std::move(found.prior));
      out_.kinds.push_back(std::move(found.evidence));
    }
  }

  /// The kind that the user means: as the rooms call it, or by what both words mean (television: tv).
  Result<std::string> kind_meant(const std::string& name) const {
    const std::string words = words_of(name, ' ');
    if (std::ranges::find(kinds_, words) != kinds_.end()) return words;
    const std::string known(kind_of(name));
    if (!known.empty() && std::ranges::find(kinds_, known) != kinds_.end()) return known;
    const std::vector<std::string_view> names(kinds_.begin(), kinds_.end());
    return Error{ErrorCode::not_found, "no example has a \"" + name + "\"" + did_you_mean(words, names), "--pair"};
  }

  Status learn_named_pairs() {
    for (const auto& [a, b] : options_.pairs) {
      const Result<std::string> first = kind_meant(a), second = kind_meant(b);
      if (!first) return first.error();
      if (!second) return second.error();
      if (known(*first, *second)) continue;
      PairFound found = find_pair(things_, *first, *second);
      if (found.prior.count == 0)
        return invalid("--pair",
                       "no room has both a " + *first + " and " + (*first == *second ? "another one" : "a " + *second));
      found.prior.by_hand = true;
      keep(std::move(found));
    }
    return Done{};
  }

  bool known(const std::string& first, const std::string& second) const {
    return std::ranges::any_of(out_.priors.pairs, [&](const PairPrior& p) {
      return (p.first == first && p.second == second) || (p.first == second && p.second == first);
    });
  }

  void keep(PairFound found) {
    round_off(found.prior);
    const auto at = std::ranges::find_if(out_.priors.pairs, [&](const PairPrior& p) {
      return std::tie(p.first, p.second) > std::tie(found.prior.first, found.prior.second);
    });
    const auto index = at - out_.priors.pairs.begin();
    out_.priors.pairs.insert(at, std::move(found.prior));
    out_.pairs.insert(out_.pairs.begin() + index, std::move(found.evidence));
  }

  void propose() {
    if (!options_.propose) return;
    // Whoever names the first of a kind knows best to whom it belongs.
    const auto named = [&](const std::string& second) {
      return std::ranges::any_of(out_.priors.pairs,
                                 [&](const PairPrior& p) { return p.by_hand && p.second == second; });
    };
    for (PairFound& found : propose_pairs(things_, furnished_))
      if (!named(found.prior.second) && !known(found.prior.first, found.prior.second)) keep(std::move(found));
  }

  void note_what_is_weak() {
    if (notes_ > kMostNotes) out_.notes.push_back("and " + std::to_string(notes_ - kMostNotes) + " more left out");
    if (furnished_ == 1)
      out_.notes.push_back("learned from one room alone: every prior says where that room has it, not what is usual");
    std::string once;
    for (const KindPrior& prior : out_.priors.kinds)
      if (prior.count == 1) once += (once.empty() ? "" : ", ") + prior.kind;
    if (!once.empty()) out_.notes.push_back("weak, seen only once: " + once);
    for (const KindPrior& prior : out_.priors.kinds)
      if (prior.back != Face::back)
        out_.notes.push_back("the " + prior.kind + " stands with its " +
                             std::string(kFaceNames[static_cast<std::size_t>(prior.back)]) + " face to the wall");
  }

  std::span<const Scene> rooms_;
  const LearnOptions& options_;
  Learned out_;
  std::vector<Thing> things_;
  std::vector<std::string> kinds_;
  int furnished_ = 0;
  std::size_t notes_ = 0;
};

}  // namespace

Result<Learned> learn(std::span<const Scene> rooms, const LearnOptions& options) {
  return Learner(rooms, options).run();
}

}  // namespace inhabit::exemplar
