#include "layout/check.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/text.h"
#include "layout/check_parts.h"

namespace inhabit::layout {
namespace {

constexpr double kListedMetres = 0.05, kListedDegrees = 5;

/// What "0.31 m" is when it is too much, and when too little.
struct Wording {
  std::string_view type, above, below;
};
constexpr Wording kWordings[] = {{"distance", "too far", "too close"},
                                 {"focal_distance", "too far", "too close"},
                                 {"wall_distance", "too far from the wall", "too close to the wall"},
                                 {"traffic_lane", "into the lane", "into the lane"},
                                 {"heat_point", "off the point", "off the point"},
                                 {"focal_symmetry", "off the axis", "off the axis"},
                                 {"visual_balance", "off the room's centre", "off the room's centre"},
                                 {"align", "out of line", "out of line"},
                                 {"region", "out of its zone", "out of its zone"},
                                 {"keep_out", "into the forbidden zone", "into the forbidden zone"},
                                 {"pathway", "into the corridor", "into the corridor"},
                                 {"visibility", "into the view", "into the view"},
                                 {"accessibility", "into the free space", "into the free space"},
                                 {"stacking", "off its place", "off its place"},
                                 {"wall_orientation", "turned away", "turned away"},
                                 {"orientation", "turned away", "turned away"}};

std::string unit_name(bool angular) { return angular ? "deg" : "m"; }
double size_of(const Residual& r) { return std::abs(r.angular ? core::degrees(r.value) : r.value); }

/// How bad it is, metres and degrees alike: multiples of what is worth listing.
double badness(const CheckReport::Violation& v) {
  return std::abs(v.residual) / (v.unit == "deg" ? kListedDegrees : kListedMetres);
}

CheckReport::Violation describe(const Scene& scene, const Residual& r) {
  CheckReport::Violation v{std::string(r.type), {}, size_of(r), unit_name(r.angular), std::string(r.type)};
  std::string_view separator = " ";
  for (const Ref ref : r.between) {
    v.between.push_back(scene.id_of(ref));
    v.text.append(separator).append(v.between.back());
    separator = " – ";
  }
  std::string_view word = "off";
  for (const Wording& w : kWordings)
    if (w.type == r.type) word = r.value > 0 ? w.above : w.below;
  v.text += ": " + core::fixed(v.residual, r.angular ? 1 : 2) + (r.angular ? "° " : " m ") + std::string(word);
  return v;
}

CheckReport::Kind summary(std::string_view type, bool angular, std::vector<double> sizes) {
  std::ranges::sort(sizes);
  const std::size_t n = sizes.size();
  CheckReport::Kind kind{std::string(type), unit_name(angular), n, 0, 0, sizes.back()};
  kind.median = n % 2 == 1 ? sizes[n / 2] : (sizes[n / 2 - 1] + sizes[n / 2]) / 2;
  kind.p95 = sizes[(95 * n + 99) / 100 - 1];
  return kind;
}

/// One row per kind that occurs, two where a kind has lengths and angles: the document's kinds in the order of their
/// table, then what groups ask for, by name.
std::vector<CheckReport::Kind> summaries(const std::vector<Residual>& list) {
  std::map<std::pair<std::string_view, bool>, std::vector<double>> sizes;
  for (const Residual& r : list) sizes[{r.type, r.angular}].push_back(size_of(r));
  std::vector<CheckReport::Kind> kinds;
  for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
    for (const bool angular : {false, true}) {
      if (auto node = sizes.extract({T::kName, angular}))
        kinds.push_back(summary(T::kName, angular, std::move(node.mapped())));
    }
  });
  for (auto& [kind, values] : sizes) kinds.push_back(summary(kind.first, kind.second, std::move(values)));
  return kinds;
}

std::vector<CheckReport::Violation> violations(const Scene& scene, const std::vector<Residual>& list) {
  std::vector<CheckReport::Violation> found;
  for (const Residual& r : list)
    if (size_of(r) > (r.angular ? kListedDegrees : kListedMetres)) found.push_back(describe(scene, r));
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return badness(a) > badness(b); });
  return found;
}

}  // namespace

CheckReport check(const Scene& scene, const CheckOptions& options) {
  const Solids solids(scene);
  CheckReport report;
  OverlapFindings overlaps = find_overlaps(solids, options.all_collisions);
  report.overlaps = std::move(overlaps.list);
  report.overlap_count = overlaps.count;
  report.overlaps_exempt = overlaps.exempt;
  report.overlaps_rigid = overlaps.rigid;
  report.overlaps_pinned = overlaps.pinned;
  report.exempt_pairs = solids.relations.pairs_off();
  for (const Object& object : scene.objects)
    if (!object.position) report.outside.push_back({object.id, std::numeric_limits<double>::infinity()});
  report.missing = report.outside.size();
  OutsideFindings outside = find_outside(solids, options.threads);
  for (auto& found : outside.list) report.outside.push_back(std::move(found));
  report.outside_pinned = outside.pinned;
  report.feasible = report.overlap_count == 0 && report.outside.empty();

  report.blocked_doors = find_blocked_doors(solids);
  report.clearances = find_blocked_clearances(solids, options.threads);
  report.views = find_blocked_views(solids, options.threads);
  ReachFindings reach = find_reach(solids);
  report.reachable = std::move(reach.reachable);
  report.walkable_share = reach.walkable_share;
  report.raster_cell = reach.cell;

  if (report.missing == 0) {
    const Residuals all = residuals(scene);
    report.constraints = summaries(all.list);
    report.violations = violations(scene, all.list);
    report.energy = all.energy;
  }
  if (options.published) report.published = published_metrics(scene, scene.seed);
  return report;
}

}  // namespace inhabit::layout
