#include <nlohmann/json.hpp>

#include "io/json_text.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

using Json = nlohmann::ordered_json;

Json known_or_null(double value) { return crowd::known(value) ? Json(value) : Json(nullptr); }
Json point(Vec2 p) { return Json::array({p.x, p.y}); }

Json area_json(const std::vector<crowd::AreaRow>& rows) {
  double density = 0, most = 0, speed = 0, measured = 0;
  for (const crowd::AreaRow& row : rows) {
    density += row.density, most = std::max(most, row.density);
    if (crowd::known(row.speed)) speed += row.speed, measured += 1;
  }
  return {{"density_mean", rows.empty() ? 0 : density / static_cast<double>(rows.size())},
          {"density_most", most},
          {"speed_mean", measured > 0 ? Json(speed / measured) : Json(nullptr)}};
}

Json bins_json(const std::vector<crowd::DensityBin>& bins) {
  Json list = Json::array();
  for (const crowd::DensityBin& b : bins)
    list.push_back({{"from", b.low},
                    {"to", b.high},
                    {"points", b.count},
                    {"density", b.density},
                    {"speed", b.median},
                    {"speed_quartiles", {b.lower, b.upper}}});
  return list;
}

Json place_json(const MeasureReport& r) {
  Json ring = Json::array();
  for (const Vec2 p : r.place.area.ring) ring.push_back(point(p));
  return {{"area", std::move(ring)},
          {"area_m2", r.place.area.size},
          {"area_given", r.place.area_given},
          {"line", Json::array({point(r.place.line.a), point(r.place.line.b)})},
          {"line_width", r.place.width},
          {"line_given", r.place.line_given},
          {"walls_known", r.place.walls},
          {"cut_off", r.place.cut_off},
          {"flow_axis", point(r.main_flow.axis)}};
}

Json flow_json(const crowd::Flow& f) {
  return {{"forward", f.forward},
          {"backward", f.backward},
          {"from", f.from},
          {"until", f.until},
          {"flow", known_or_null(f.flow)},
          {"specific_flow", known_or_null(f.specific)},
          {"headway_median", f.headways.empty() ? Json(nullptr) : Json(median(f.headways))},
          {"speed_mean", known_or_null(f.speed)}};
}

template <class F>
Json median_of(const std::vector<crowd::PathRow>& rows, F f) {
  std::vector<double> values;
  for (const crowd::PathRow& row : rows)
    if (crowd::known(f(row))) values.push_back(f(row));
  return values.empty() ? Json(nullptr) : Json(median(values));
}

Json collision_json(const crowd::TimesToCollision& ttc) {
  std::vector<double> soonest;
  std::size_t below_one = 0;
  for (const float tau : ttc.soonest) {
    if (!(tau < 1e30f)) continue;
    soonest.push_back(tau);
    below_one += tau < 1 ? 1 : 0;
  }
  return {{"horizon", ttc.horizon},
          {"positions", soonest.size()},
          {"positions_below_1s", below_one},
          {"soonest_median", soonest.empty() ? Json(nullptr) : Json(median(soonest))},
          {"pairs", ttc.pairs}};
}

}  // namespace

std::string measure_json(const MeasureReport& r) {
  Json json;
  json["name"] = r.name;
  json["frame_rate"] = r.frame_rate;
  json["from"] = r.from;
  json["until"] = r.until;
  json["positions"] = r.fixes;
  json["people"] = r.presence.people;
  json["people_at_once"] = r.presence.most;
  json["remaining"] = r.presence.remaining;
  json["evacuation_time"] = r.presence.evacuation;
  json["place"] = place_json(r);
  json["speed"] = {{"median", r.speeds.empty() ? Json(nullptr) : Json(median(r.speeds))},
                   {"p05", r.speeds.empty() ? Json(nullptr) : Json(quantile(r.speeds, 0.05))},
                   {"p95", r.speeds.empty() ? Json(nullptr) : Json(quantile(r.speeds, 0.95))}};
  json["voronoi"] = area_json(r.voronoi);
  json["classic"] = area_json(r.classic);
  json["steady"] = r.steady ? Json::array({r.steady->first, r.steady->second}) : Json(nullptr);
  json["fundamental_diagram"] = bins_json(r.bins);
  json["weidmann_rmse"] = known_or_null(crowd::weidmann_rmse(r.bins));
  json["flow"] = flow_json(r.flow);
  json["lane_order"] = known_or_null(crowd::mean_order(r.lanes));
  json["detour_median"] = median_of(r.paths, [](const crowd::PathRow& p) { return p.detour(); });
  json["effort_median"] = median_of(r.paths, [](const crowd::PathRow& p) { return p.effort_ratio(); });
  json["radius"] = r.radius;
  json["overlaps"] = {{"pairs", r.overlaps.pairs},
                      {"worst", r.overlaps.worst},
                      {"worst_share", r.overlaps.worst_share},
                      {"worst_seconds", r.overlaps.worst_seconds}};
  json["walls"] = {{"outside", r.walls.outside},
                   {"touching", r.walls.touching},
                   {"people", r.walls.people},
                   {"worst", r.walls.worst}};
  json["time_to_collision"] = collision_json(r.times_to_collision);
  json["time_to_collision"]["one_frame_in"] = r.collision_frames;
  json["notes"] = r.remarks;
  return io::pretty_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace inhabit::session
