#include <algorithm>
#include <map>
#include <tuple>

#include "io/formats/object_reader.h"
#include "io/formats/priors_json.h"
#include "io/formats/priors_members.h"

namespace inhabit::io {
namespace {

class PriorsReader : public ObjectReader<PriorsReader> {
 public:
  bool read(JsonValue root, Priors& priors) {
    if (!root.is(Json::object))
      return fail(root, std::string("a priors file is an object, this is ") + std::string(name_of(root.kind())));
    if (!root.find("space").none() && root.find("kinds").none())
      return fail(root, "this is a scene; inhabit learn makes priors of scenes");
    if (!check_header(root, kPriorsName, kPriorsVersion)) return false;
    if (!read_object(root, priors, {"format", "version"})) return false;
    return check_kinds(root.find("kinds"), priors) && check_pairs(root.find("pairs"), priors) && sort(priors);
  }

 private:
  friend class ObjectReader<PriorsReader>;
  using ObjectReader::read;

  bool read(JsonValue v, std::vector<std::string>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    for (const JsonValue item : v)
      if (!read(item, out.emplace_back(), spec)) return false;
    return true;
  }
  bool read(JsonValue v, std::array<double, 4>& out, const Spec&) {
    Clearance faces;
    if (!read_object(v, faces)) return false;
    out = {faces.back, faces.left, faces.front, faces.right};
    return true;
  }
  /// Written by hand, one way is one example's worth.
  template <class T>
  bool read_counted(JsonValue v, T& out) {
    out.count = 1;
    return read_object(v, out);
  }
  bool read(JsonValue v, WallMode& out, const Spec&) { return read_counted(v, out); }
  bool read(JsonValue v, PairMode& out, const Spec&) { return read_counted(v, out); }
  bool read(JsonValue v, Support& out, const Spec&) { return read_counted(v, out); }

  static JsonValue item(JsonValue list, std::size_t index) {
    auto it = list.begin();
    while (index-- > 0) ++it;
    return *it;
  }

  bool check_kinds(JsonValue list, const Priors& priors) {
    std::map<std::string_view, std::size_t> seen;
    for (std::size_t i = 0; i < priors.kinds.size(); ++i) {
      const KindPrior& prior = priors.kinds[i];
      const JsonValue at = item(list, i);
      if (const auto [before, fresh] = seen.emplace(prior.kind, i); !fresh)
        return fail(at.find("kind"),
                    quoted(prior.kind) + " is there already, in /kinds/" + std::to_string(before->second));
      for (std::size_t k = 0; k < prior.support.size(); ++k)
        if (!check_support(item(at.find("support"), k), prior, prior.support[k], priors)) return false;
    }
    return true;
  }

  bool check_support(JsonValue at, const KindPrior& prior, const Support& support, const Priors& priors) {
    if (support.on.empty()) return true;
    if (support.mount != Mount::floor) return fail(at, "both hangs and stands on something");
    if (support.on == prior.kind) return fail(at.find("on"), "a " + support.on + " cannot carry itself");
    const KindPrior* carrier = priors.of(support.on);
    if (carrier == nullptr) return true;
    // Books lie on desks here and there; only what always stands on the other cannot carry it.
    const auto always = [](const KindPrior& p, const std::string& on) {
      return !p.support.empty() && std::ranges::all_of(p.support, [&](const Support& s) { return s.on == on; });
    };
    if (always(prior, carrier->kind) && always(*carrier, prior.kind))
      return fail(at.find("on"),
                  "a " + prior.kind + " stands on a " + carrier->kind + ", which stands on a " + prior.kind);
    return true;
  }

  bool check_pairs(JsonValue list, const Priors& priors) {
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> seen;
    for (std::size_t i = 0; i < priors.pairs.size(); ++i) {
      const PairPrior& pair = priors.pairs[i];
      const JsonValue at = item(list, i);
      if (pair.modes.empty()) return fail(at.find("modes"), "says nothing: a pair needs a way to stand");
      const std::string both = quoted(pair.first) + " and " + quoted(pair.second);
      if (const auto [before, fresh] =
              seen.emplace(std::pair<std::string_view, std::string_view>(pair.first, pair.second), i);
          !fresh)
        return fail(at, both + " are there already, in /pairs/" + std::to_string(before->second));
      if (const auto other = seen.find(std::pair<std::string_view, std::string_view>(pair.second, pair.first));
          other != seen.end() && pair.first != pair.second)
        return fail(at, both + " are there the other way round, in /pairs/" + std::to_string(other->second));
    }
    return true;
  }

  static bool sort(Priors& priors) {
    const auto by_count = [](auto& list) {
      std::ranges::stable_sort(list, [](const auto& a, const auto& b) { return a.count > b.count; });
    };
    for (KindPrior& prior : priors.kinds) by_count(prior.wall), by_count(prior.support);
    for (PairPrior& pair : priors.pairs) by_count(pair.modes);
    std::ranges::stable_sort(priors.kinds, {}, &KindPrior::kind);
    std::ranges::stable_sort(priors.pairs, [](const PairPrior& a, const PairPrior& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    return true;
  }
};

}  // namespace

Result<Priors> read_priors(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  Priors priors;
  PriorsReader reader;
  if (!reader.read(document->root(), priors)) return *reader.error;
  return priors;
}

}  // namespace inhabit::io
