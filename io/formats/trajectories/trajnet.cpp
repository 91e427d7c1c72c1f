#include "io/formats/trajectories/trajnet.h"

#include "io/formats/trajectories/delimited.h"
#include "io/json_document.h"

namespace inhabit::io {
namespace {

constexpr std::size_t kLongestLine = 1 << 16;

/// The number called `name` of `object`; `problem` when there is none.
double number_in(JsonValue object, std::string_view name, std::string& problem) {
  const JsonValue value = object.find(name);
  if (!value.none() && value.is(Json::number)) return value.number();
  if (problem.empty()) problem = "\"" + std::string(name) + "\" must be a number";
  return 0;
}
std::int64_t whole_in(JsonValue object, std::string_view name, std::string& problem) {
  number_in(object, name, problem);
  if (!problem.empty()) return 0;
  const std::optional<std::int64_t> whole = whole_of(object.find(name).text());
  if (!whole) problem = "\"" + std::string(name) + "\" must be a whole number";
  return whole.value_or(0);
}

}  // namespace

bool is_trajnet(std::string_view bytes) {
  LineReader lines(bytes);
  while (lines.next()) {
    std::string_view line = trimmed_line(lines.line());
    if (line.empty()) continue;
    if (!line.starts_with('{')) return false;
    line = trimmed_line(line.substr(1));
    return line.starts_with("\"scene\"") || line.starts_with("\"track\"");
  }
  return false;
}

Result<RawTrajectories> read_trajnet(std::string_view bytes) {
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  raw.row_rate = 2.5;
  RawRows rows(raw);
  LineReader lines(bytes);
  std::size_t predictions = 0;
  while (lines.next()) {
    const std::string_view line = trimmed_line(lines.line());
    if (line.empty()) continue;
    if (line.size() > kLongestLine) return invalid(lines.where(), "is longer than a track or a scene can be");
    const Result<JsonDocument> document = JsonDocument::parse(line);
    if (!document) return invalid(lines.where(), document.error().message);
    const JsonValue root = document->root(), track = root.find("track"), scene = root.find("scene");
    if (track.none() && scene.none()) return invalid(lines.where(), "neither a \"track\" nor a \"scene\"");
    if (!scene.none() && !scene.find("fps").none() && scene.find("fps").is(Json::number))
      raw.row_rate = scene.find("fps").number();
    if (track.none()) continue;
    if (!track.find("prediction_number").none() && !track.find("prediction_number").is(Json::null)) {
      ++predictions;
      continue;
    }
    std::string problem;
    const std::int64_t person = whole_in(track, "p", problem), frame = whole_in(track, "f", problem);
    const double x = number_in(track, "x", problem), y = number_in(track, "y", problem);
    if (!problem.empty()) return invalid(lines.where(), problem);
    if (!rows.add(person, frame, x, y, lines.number())) return invalid(lines.where(), rows.problem);
  }
  if (predictions > 0) raw.remarks.push_back(std::to_string(predictions) + " predicted positions are left out");
  return raw;
}

}  // namespace inhabit::io
