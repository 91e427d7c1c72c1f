#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/check_json.h"
#include "session/jobs.h"

namespace inhabit::session {

bool Checked::feasible() const {
  return std::all_of(rooms.begin(), rooms.end(), [](const CheckedRoom& room) { return room.report.feasible; });
}

bool Checked::as_asked() const {
  return feasible() && std::all_of(rooms.begin(), rooms.end(), [](const CheckedRoom& room) {
           return room.house_rules || room.report.violations.empty();
         });
}

Checked check_job(const Document& document, const layout::CheckOptions& options) {
  Checked checked;
  for (const Scene& scene : document.scenes)
    checked.rooms.push_back({scene.name, layout::check(scene, options), scene.house_rules});
  return checked;
}

std::string check_text(const layout::CheckReport& report, bool house_rules) {
  std::string text = io::check_table(report);
  if (house_rules && !report.violations.empty()) text += "\n  these constraints are house rules, which may be missed\n";
  return text;
}

std::string check_text(const Checked& checked) {
  std::string text;
  for (const auto& [name, report, house_rules] : checked.rooms) {
    if (checked.rooms.size() > 1) text += name + "\n";
    text += check_text(report, house_rules);
  }
  return text;
}

std::string check_json(const Checked& checked) {
  if (checked.rooms.size() == 1) return io::check_json(checked.rooms.front().report) + "\n";
  nlohmann::ordered_json json;
  json["feasible"] = checked.feasible();
  json["rooms"] = nlohmann::ordered_json::array();
  for (const auto& [name, report, house_rules] : checked.rooms) {
    nlohmann::ordered_json item;
    item["name"] = name;
    item.update(nlohmann::ordered_json::parse(io::check_json(report)));
    json["rooms"].push_back(std::move(item));
  }
  return json.dump() + "\n";
}

}  // namespace inhabit::session
