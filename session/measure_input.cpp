#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/text.h"
#include "crowd/world.h"
#include "io/file.h"
#include "io/formats/wkt.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

/// Finite numbers parted by commas or blanks; nothing when there is anything else.
std::optional<std::vector<double>> numbers(std::string text) {
  for (char& c : text)
    if (c == ',' || c == ';') c = ' ';
  std::vector<double> values;
  const char* at = text.c_str();
  while (true) {
    while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
    if (*at == 0) return values;
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    at = end;
  }
}

}  // namespace

Result<Ring> parse_area(const std::string& text) {
  if (const auto v = numbers(text); v && v->size() == 4) {
    const double x0 = std::min((*v)[0], (*v)[2]), x1 = std::max((*v)[0], (*v)[2]);
    const double y0 = std::min((*v)[1], (*v)[3]), y1 = std::max((*v)[1], (*v)[3]);
    if (x0 == x1 || y0 == y1) return invalid("--area", "\"" + text + "\" encloses no area");
    return Ring{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }
  if (text.find('(') == std::string::npos)
    return invalid("--area", "\"" + text + "\" is neither x0,y0,x1,y1 nor a POLYGON ((…))");
  Result<std::vector<Scene>> scenes = io::read_wkt(text);
  if (!scenes) return invalid("--area", scenes.error().text());
  if (scenes->size() != 1 || !scenes->front().space.holes.empty())
    return invalid("--area", "one polygon without holes is wanted");
  for (const auto& [key, value] : scenes->front().extras)
    if (key == "x-origin") return invalid("--area", "the polygon lies too far from the origin");
  return std::move(scenes->front().space.outline);
}

Result<crowd::MeasureLine> parse_line(const std::string& text) {
  const auto v = numbers(text);
  if (!v || v->size() != 4) return invalid("--line", "\"" + text + "\" is not x0,y0,x1,y1");
  const crowd::MeasureLine line{{(*v)[0], (*v)[1]}, {(*v)[2], (*v)[3]}};
  if (!(line.length() > 0)) return invalid("--line", "both ends are the same point");
  return line;
}

Result<std::vector<crowd::FundamentalPoint>> read_curve(const std::string& path) {
  const Result<std::string> bytes = io::read_file(path);
  if (!bytes) return bytes.error();
  std::vector<crowd::FundamentalPoint> points;
  std::istringstream file(*bytes);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    const auto v = numbers(line);
    if (v && v->empty()) continue;
    if (!v || v->size() != 2)
      return invalid("line " + std::to_string(number), "two numbers are wanted, density and speed");
    points.push_back({(*v)[0], (*v)[1]});
  }
  if (points.empty()) return invalid("", "there are no points in it");
  return points;
}

Table curve_table(const std::vector<crowd::FundamentalPoint>& ours, const std::vector<crowd::FundamentalPoint>& theirs,
                  double width) {
  Table table{"curve", "Median speed by density, ours and the reference", {}, {}, {}};
  table.columns = {
      {"density from", 2},  {"to", 2}, {"points", 0}, {"speed m/s", 3}, {"reference points", 0}, {"reference m/s", 3},
      {"difference m/s", 3}};
  const auto a = crowd::density_bins(ours, width), b = crowd::density_bins(theirs, width);
  for (const crowd::DensityBin& bin : a)
    for (const crowd::DensityBin& other : b)
      if (bin.low == other.low)
        table.rows.push_back({bin.low, bin.high, static_cast<double>(bin.count), bin.median,
                              static_cast<double>(other.count), other.median, bin.median - other.median});
  const crowd::CurveComparison c = crowd::compare_curves(a, b, 5);
  if (c.bins > 0)
    table.notes.push_back("over " + std::to_string(c.bins) + " slices with at least 5 points each: mean difference " +
                          fixed(c.mean, 3) + " m/s, root mean square " + fixed(c.rmse, 3) + ", largest " +
                          fixed(c.worst, 3));
  return table;
}

Result<std::vector<Area>> walkable_of(const Document& document) {
  std::vector<Area> areas;
  for (const Scene& scene : document.scenes) {
    Result<crowd::World> world = crowd::make_world(scene, 1);
    if (!world) return world.error();
    for (Floor& floor : world->floors) areas.push_back({std::move(floor.outline), std::move(floor.holes)});
  }
  if (areas.empty()) return invalid("", "there is no floor to walk on");
  return areas;
}

}  // namespace inhabit::session
