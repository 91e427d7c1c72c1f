#include <algorithm>

#include "core/text.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

using crowd::known;

std::string number(double value, int digits) { return known(value) ? fixed(value, digits) : "-"; }

std::string point(Vec2 p) { return "(" + fixed(p.x, 2) + ", " + fixed(p.y, 2) + ")"; }

/// One measure: its name, its value with its unit, and how it is meant.
struct Lines {
  Table table{"measures", "", {{"measure"}, {"value"}, {"unit"}, {"of what"}}, {}, {}};
  void add(const std::string& name, const std::string& value, const char* unit, const std::string& what = "") {
    table.rows.push_back({name, value, unit, what});
  }
};

/// Share of the sorted values.
double at(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return crowd::kUnknown;
  const auto k = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5);
  return sorted[k];
}

double mean_density(const std::vector<crowd::AreaRow>& rows) {
  double sum = 0;
  for (const crowd::AreaRow& row : rows) sum += row.density;
  return rows.empty() ? crowd::kUnknown : sum / static_cast<double>(rows.size());
}

double most_density(const std::vector<crowd::AreaRow>& rows) {
  double most = 0;
  for (const crowd::AreaRow& row : rows) most = std::max(most, row.density);
  return most;
}

double mean_speed(const std::vector<crowd::AreaRow>& rows) {
  double sum = 0, count = 0;
  for (const crowd::AreaRow& row : rows)
    if (known(row.speed)) sum += row.speed, count += 1;
  return count > 0 ? sum / count : crowd::kUnknown;
}

template <class F>
double median_of(const std::vector<crowd::PathRow>& rows, F f) {
  std::vector<double> values;
  for (const crowd::PathRow& row : rows)
    if (known(f(row))) values.push_back(f(row));
  return values.empty() ? crowd::kUnknown : median(values);
}

void add_area(Lines& lines, const MeasureReport& r) {
  const std::string how = "Voronoi" + (r.place.cut_off > 0 ? ", cells cut at " + shortest(r.place.cut_off) + " m" : "");
  lines.add("density in the area, mean", number(mean_density(r.voronoi), 2), "1/m²", how);
  lines.add("density in the area, most", number(most_density(r.voronoi), 2), "1/m²", how);
  lines.add("density in the area, classic mean", number(mean_density(r.classic), 2), "1/m²", "heads per square metre");
  lines.add("speed in the area, mean", number(mean_speed(r.voronoi), 2), "m/s", how);
  const std::string span =
      r.steady ? "steady from " + fixed(r.steady->first, 2) + " to " + fixed(r.steady->second, 2) + " s, " : "";
  lines.add("distance from Weidmann's curve", number(crowd::weidmann_rmse(r.bins), 2), "m/s",
            span + "root mean square over " + std::to_string(r.bins.size()) + " slices of density");
}

void add_flow(Lines& lines, const MeasureReport& r) {
  const crowd::Flow& f = r.flow;
  lines.add("crossed the line", std::to_string(f.forward), "people", "along the flow");
  lines.add("crossed the line back", std::to_string(f.backward), "people", "against it");
  lines.add("flow", number(f.flow, 3), "1/s",
            f.times.empty() ? "" : "from " + fixed(f.from, 2) + " to " + fixed(f.until, 2) + " s");
  lines.add("specific flow", number(f.specific, 3), "1/(m s)", "of the line's " + fixed(r.place.width, 2) + " m");
  lines.add("headway, median", f.headways.empty() ? "-" : number(median(f.headways), 2), "s", "between crossings");
}

void add_safety(Lines& lines, const MeasureReport& r) {
  const std::string disc = "discs of " + shortest(r.radius) + " m";
  const crowd::Overlaps& o = r.overlaps;
  lines.add("overlapping pairs", std::to_string(o.pairs), "", disc + ", over all frames");
  lines.add("deepest overlap", fixed(o.worst, 4), "m",
            o.pairs == 0 ? disc
                         : "persons " + std::to_string(o.first) + " and " + std::to_string(o.second) + " at " +
                               fixed(o.worst_seconds, 2) + " s");
  std::vector<double> soonest;
  for (const float tau : r.times_to_collision.soonest)
    if (tau < 1e30f) soonest.push_back(tau);
  lines.add(
      "time to collision, median", soonest.empty() ? "-" : fixed(median(soonest), 2), "s",
      "0 for touching discs; on a collision course within 10 m and 10 s: " +
          fixed(100 * static_cast<double>(soonest.size() * r.collision_frames) / static_cast<double>(r.fixes), 0) +
          " % of the positions");
  if (!r.place.walls) return;
  lines.add("positions outside the walls", std::to_string(r.walls.outside), "");
  lines.add("touching a wall", std::to_string(r.walls.touching), "positions",
            std::to_string(r.walls.people) + " people, " + disc);
  lines.add("deepest in a wall", fixed(r.walls.worst, 4), "m",
            r.walls.touching == 0
                ? disc
                : "person " + std::to_string(r.walls.who) + " at " + fixed(r.walls.worst_seconds, 2) + " s");
}

}  // namespace

std::string measure_text(const MeasureReport& r) {
  Lines lines;
  lines.table.title = (r.name.empty() ? "trajectories" : r.name) + ": " + std::to_string(r.fixes) + " positions, " +
                      fixed(r.from, 2) + " to " + fixed(r.until, 2) + " s, " + shortest(r.frame_rate) +
                      " frames per second";
  lines.add("people", std::to_string(r.presence.people), "", "at once " + std::to_string(r.presence.most) + " at most");
  lines.add("last one gone after", fixed(r.presence.evacuation, 2), "s",
            r.presence.remaining > 0 ? std::to_string(r.presence.remaining) + " in the last frame" : "");
  lines.add(
      "speed, median", number(at(r.speeds, 0.5), 2), "m/s",
      "of all positions; 5 % below " + number(at(r.speeds, 0.05), 2) + ", 5 % above " + number(at(r.speeds, 0.95), 2));
  add_area(lines, r);
  add_flow(lines, r);
  const double order = crowd::mean_order(r.lanes);
  lines.add("lanes", number(order, 2), "",
            known(order) ? "order of two-way flow, 1 = perfect lanes" : "the flow is one-way");
  lines.add("detour, median", number(median_of(r.paths, [](const auto& p) { return p.detour(); }), 3), "",
            "way over the straight line");
  lines.add("effort, median", number(median_of(r.paths, [](const auto& p) { return p.effort_ratio(); }), 2), "",
            "over the least that the straight line can cost");
  add_safety(lines, r);
  const MeasurePlace& place = r.place;
  std::string text = table_text(lines.table);
  text += "area: " + fixed(place.area.size, 2) + " m² with corners";
  for (const Vec2 p : place.area.ring) text += " " + point(p);
  text += place.area_given ? "\n" : "; chosen round the line, --area gives another\n";
  text += "line: " + point(place.line.a) + " to " + point(place.line.b);
  text += place.line_given ? "\n" : "; chosen across the main flow in its middle, --line gives another\n";
  for (const std::string& remark : r.remarks) text += "note: " + remark + "\n";
  return text;
}

}  // namespace inhabit::session
