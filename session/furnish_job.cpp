#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "io/check_json.h"
#include "io/formats/scene_json.h"
#include "layout/house_rules.h"
#include "session/furnish_methods.h"
#include "session/jobs.h"
#include "session/table.h"

namespace inhabit::session {
namespace {

Result<FurnishedRoom> furnish_room(const Scene& original, const FurnishJob& job, bool& cancelled) {
  Scene scene = original;
  if (job.house_rules) layout::add_house_rules(scene);
  scene.house_rules = scene.house_rules || scene.constraints.size() > original.constraints.size();
  FurnishedRoom room;
  room.name = scene.name;
  const auto begin = std::chrono::steady_clock::now();
  Result<Found> found =
      job.method == Method::pbd ? furnish_by_projection(scene, job) : furnish_by_annealing(scene, job);
  room.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!found) return found.error();
  cancelled = cancelled || found->cancelled;
  room.suggestions = std::move(found->list);
  room.trace = std::move(found->trace);
  room.anneal_trace = std::move(found->anneal_trace);
  room.notes = std::move(found->notes);
  return room;
}

std::string counted(std::size_t n, std::string_view what) {
  std::string text = std::to_string(n);
  text += ' ';
  text += what;
  if (n != 1) text += 's';
  return text;
}

std::string summary_line(const FurnishedRoom& room, std::size_t k) {
  const Suggestion& s = room.suggestions[k];
  std::string line = room.name.empty() ? "scene" : room.name;
  if (room.suggestions.size() > 1) line += ", suggestion " + std::to_string(k + 1);
  line += s.report.feasible ? ": feasible" : ": NOT feasible";
  line += ", " + counted(s.scene.objects.size(), "object") + ", energy " + fixed(s.report.energy, 3);
  line += ", " + counted(static_cast<std::size_t>(s.layout.iterations), "iteration") + ", start " +
          std::to_string(s.layout.start);
  line += ", " + fixed(1000 * room.seconds, 1) + " ms\n";
  return line;
}

}  // namespace

bool Furnished::feasible() const {
  return std::all_of(rooms.begin(), rooms.end(), [](const FurnishedRoom& room) {
    return !room.suggestions.empty() && room.suggestions.front().report.feasible;
  });
}

bool Furnished::as_asked() const {
  return feasible() && std::all_of(rooms.begin(), rooms.end(), [](const FurnishedRoom& room) {
           const Suggestion& best = room.suggestions.front();
           return best.scene.house_rules || best.report.violations.empty();
         });
}

Document Furnished::document(const Document& original, std::size_t k) const {
  Document result = original;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (!rooms[i].suggestions.empty())
      result.scenes[i] = rooms[i].suggestions[std::min(k, rooms[i].suggestions.size() - 1)].scene;
  return result;
}

Result<Furnished> furnish_job(const Document& document, const FurnishJob& job) {
  Furnished furnished;
  const std::size_t count = document.scenes.size();
  for (std::size_t i = 0; i < count; ++i) {
    FurnishJob part = job;
    if (job.layout.progress)
      part.layout.progress = [&job, i, count](double done, std::string_view what) {
        job.layout.progress((static_cast<double>(i) + done) / static_cast<double>(count), what);
      };
    Result<FurnishedRoom> room = furnish_room(document.scenes[i], part, furnished.cancelled);
    if (!room && count == 1) return room.error();
    if (room) {
      furnished.rooms.push_back(std::move(*room));
    } else {
      FurnishedRoom failed;
      failed.name = document.scenes[i].name;
      failed.error = room.error();
      furnished.rooms.push_back(std::move(failed));
    }
  }
  return furnished;
}

std::string furnish_text(const Furnished& furnished) {
  std::string text;
  for (const FurnishedRoom& room : furnished.rooms) {
    if (room.error) text += room.name + ": not furnished: " + room.error->text() + "\n";
    for (const std::string& note : room.notes) text += "note: " + note + "\n";
    for (std::size_t k = 0; k < room.suggestions.size(); ++k) {
      text += summary_line(room, k);
      if (k == 0 || !room.suggestions[k].report.feasible)
        text += check_text(room.suggestions[k].report, room.suggestions[k].scene.house_rules);
    }
  }
  if (furnished.cancelled) text += "interrupted: this is the best so far\n";
  return text;
}

std::string furnish_json(const Furnished& furnished, bool with_scenes) {
  nlohmann::ordered_json json;
  json["feasible"] = furnished.feasible();
  json["cancelled"] = furnished.cancelled;
  json["rooms"] = nlohmann::ordered_json::array();
  for (const FurnishedRoom& room : furnished.rooms) {
    nlohmann::ordered_json item;
    item["name"] = room.name;
    item["seconds"] = room.seconds;
    if (room.error) item["error"] = room.error->text();
    if (!room.notes.empty()) item["notes"] = room.notes;
    item["suggestions"] = nlohmann::ordered_json::array();
    for (const Suggestion& s : room.suggestions) {
      nlohmann::ordered_json entry;
      entry["feasible"] = s.report.feasible;
      entry["energy"] = s.report.energy;
      entry["start"] = s.layout.start;
      entry["iterations"] = s.layout.iterations;
      entry["check"] = nlohmann::ordered_json::parse(io::check_json(s.report));
      if (with_scenes) entry["scene"] = nlohmann::ordered_json::parse(io::write_scene(s.scene));
      item["suggestions"].push_back(std::move(entry));
    }
    json["rooms"].push_back(std::move(item));
  }
  return json.dump() + "\n";
}

std::string trace_csv(const std::vector<layout::TraceRow>& trace) {
  std::string csv = "start,iteration,energy,overlap,feasible,relocated\n";
  for (const layout::TraceRow& row : trace) {
    csv += std::to_string(row.start) + ',' + std::to_string(row.iteration) + ',' + shortest(row.energy) + ',';
    csv += shortest(row.overlap) + (row.feasible ? ",1" : ",0") + (row.relocated ? ",1\n" : ",0\n");
  }
  return csv;
}

std::string trace_csv(const std::vector<annealing::TraceRow>& trace) {
  std::string csv = "start,iteration,temperature,cost";
  for (const std::string_view name : annealing::term_names()) csv += ',' + std::string(name);
  csv += '\n';
  for (const annealing::TraceRow& row : trace) {
    csv += std::to_string(row.start) + ',' + std::to_string(row.iteration) + ',' + shortest(row.temperature) + ',';
    csv += shortest(row.cost);
    for (const double part : row.parts) csv += ',' + shortest(part);
    csv += '\n';
  }
  return csv;
}

}  // namespace inhabit::session
