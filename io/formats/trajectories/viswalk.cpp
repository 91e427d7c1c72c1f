#include "io/formats/trajectories/viswalk.h"

#include "io/formats/trajectories/delimited.h"
#include "io/formats/trajectories/header.h"

namespace inhabit::io {

bool is_viswalk(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return bytes.starts_with("$VISION") || bytes.starts_with("$PEDESTRIAN:");
}

Result<RawTrajectories> read_viswalk(std::string_view bytes) {
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  LineReader lines(bytes);
  constexpr std::string_view kTable = "$PEDESTRIAN:";
  while (lines.next()) {
    std::string_view line = trimmed_line(lines.line());
    if (!line.starts_with(kTable)) continue;
    line.remove_prefix(kTable.size());
    Columns columns{.separator = ';', .comment = '*'};
    const std::vector<std::string_view> names = column_names(line, ';');
    columns.person = column_of(names, {"NO"});
    columns.time = column_of(names, {"SIMSEC"});
    columns.x = column_of(names, {"COORDCENTX"});
    columns.y = column_of(names, {"COORDCENTY"});
    for (const auto& [column, name] : {std::pair(columns.person, "NO"), std::pair(columns.time, "SIMSEC"),
                                       std::pair(columns.x, "COORDCENTX"), std::pair(columns.y, "COORDCENTY")})
      if (column < 0) return invalid(lines.where(), std::string("the column ") + name + " is missing");
    const Status read = read_rows(lines, columns, raw);
    if (!read) return read.error();
    return raw;
  }
  return invalid("", "no line starts with $PEDESTRIAN: and names the columns");
}

}  // namespace inhabit::io
