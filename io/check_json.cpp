#include "io/check_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace inhabit::io {
namespace {

using Json = nlohmann::ordered_json;
using layout::CheckReport;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class T, class F>
Json array(const std::vector<T>& items, F&& write) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(write(item));
  return list;
}

Json constraints(const CheckReport& r) {
  return array(r.constraints, [](const CheckReport::Kind& k) {
    return Json{{"type", k.type},       {"count", k.count},     {"median", finite(k.median)},
                {"p95", finite(k.p95)}, {"max", finite(k.max)}, {"unit", k.unit}};
  });
}

Json violations(const CheckReport& r) {
  return array(r.violations, [](const CheckReport::Violation& v) {
    return Json{
        {"type", v.type}, {"between", v.between}, {"residual", finite(v.residual)}, {"unit", v.unit}, {"text", v.text}};
  });
}

Json published(const layout::PublishedMetrics& p) {
  Json json{{"asked", p.asked}, {"placed", p.placed}};
  for (const auto& m : p.measures) {
    const std::string name = m.unit.empty() ? m.name : m.name + " [" + m.unit + "]";
    json[m.source][name] = m.value ? finite(*m.value) : Json(nullptr);
  }
  json["left_out"] = array(p.left_out, [](const auto& l) { return Json{{"name", l.name}, {"why", l.why}}; });
  return json;
}

}  // namespace

std::string check_json(const CheckReport& r) {
  Json json;
  json["feasible"] = r.feasible;
  json["overlaps"] = array(r.overlaps, [](const auto& o) {
    return Json{{"a", o.a}, {"b", o.b}, {"depth", finite(o.depth)}};
  });
  json["outside"] = array(r.outside, [](const auto& o) { return Json{{"id", o.id}, {"depth", finite(o.depth)}}; });
  json["blocked_doors"] = array(r.blocked_doors, [](const auto& d) {
    return Json{{"id", d.id}, {"share", finite(d.share)}};
  });
  json["clearances"] = array(r.clearances, [](const auto& c) {
    return Json{{"id", c.id}, {"face", c.face}, {"blocked_share", finite(c.blocked_share)}};
  });
  json["reachable"] = {{"share", finite(r.reachable.share)}, {"unreachable", r.reachable.unreachable}};
  json["walkable_share"] = finite(r.walkable_share);
  json["views"] = array(r.views, [](const auto& v) {
    return Json{{"id", v.id}, {"blocked_share", finite(v.blocked_share)}};
  });
  json["constraints"] = constraints(r);
  json["energy"] = finite(r.energy);
  json["violations"] = violations(r);
  json["overlap_count"] = r.overlap_count;
  json["exempt_pairs"] = r.exempt_pairs;
  json["overlaps_exempt"] = r.overlaps_exempt;
  json["overlaps_rigid"] = r.overlaps_rigid;
  json["overlaps_pinned"] = r.overlaps_pinned;
  json["outside_pinned"] = r.outside_pinned;
  json["missing"] = r.missing;
  json["raster_cell"] = finite(r.raster_cell);
  if (r.published) json["published"] = published(*r.published);
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace inhabit::io
