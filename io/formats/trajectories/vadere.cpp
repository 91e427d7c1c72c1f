#include "io/formats/trajectories/vadere.h"

#include <map>

#include "io/formats/trajectories/delimited.h"
#include "io/formats/trajectories/header.h"

namespace inhabit::io {
namespace {

/// The line with the names of the columns, which says `pedestrianId`; false when the first line that is no comment does
/// not.
bool find_header(LineReader& lines) {
  while (lines.next()) {
    const std::string_view line = trimmed_line(lines.line());
    if (line.empty() || line.front() == '#') continue;
    return line.find("pedestrianId") != std::string_view::npos;
  }
  return false;
}

}  // namespace

bool is_vadere(std::string_view bytes) {
  LineReader lines(bytes);
  return find_header(lines);
}

Result<RawTrajectories> read_vadere(std::string_view bytes) {
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  raw.irregular = true;
  LineReader lines(bytes);
  if (!find_header(lines)) return invalid("", "no line names the columns");
  const std::vector<std::string_view> names = column_names(lines.line(), 0);
  Columns columns;
  columns.person = column_with(names, "pedestrianId"), columns.time = column_with(names, "simTime");
  columns.x = column_with(names, "startX"), columns.y = column_with(names, "startY");
  for (const auto& [column, name] :
       {std::pair(columns.time, "simTime"), std::pair(columns.x, "startX"), std::pair(columns.y, "startY")})
    if (column < 0)
      return invalid(lines.where(),
                     std::string("the column ") + name + " is missing; footsteps have it (postvis.traj)");
  LineReader again = lines;
  if (const Status read = read_rows(lines, columns, raw); !read) return read.error();

  columns.time = column_with(names, "endTime"), columns.x = column_with(names, "endX");
  columns.y = column_with(names, "endY");
  if (columns.time < 0 || columns.x < 0 || columns.y < 0) return raw;
  RawTrajectories ends;
  if (const Status read = read_rows(again, columns, ends); !read) return read.error();
  // The last step of each person also has an end, where nothing else starts.
  std::map<std::int32_t, std::size_t> last;
  for (std::size_t k = 0; k < raw.fixes.size(); ++k) {
    const auto [place, fresh] = last.emplace(raw.fixes[k].person, k);
    if (!fresh && raw.times[k] >= raw.times[place->second]) place->second = k;
  }
  if (!raw.wide.empty()) return raw;
  for (const auto& [person, k] : last) {
    if (ends.times[k] <= raw.times[k]) continue;
    raw.fixes.push_back(ends.fixes[k]);
    raw.times.push_back(ends.times[k]);
    raw.lines.push_back(ends.lines[k]);
  }
  return raw;
}

}  // namespace inhabit::io
