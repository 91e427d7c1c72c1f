#include "io/formats/trajectories/obsmat.h"

#include "io/formats/trajectories/delimited.h"

namespace inhabit::io {

bool is_obsmat(std::string_view bytes) { return numeric_columns(bytes) == 8; }

Result<RawTrajectories> read_obsmat(std::string_view bytes) {
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  LineReader lines(bytes);
  const Status read = read_rows(lines, {.person = 1, .frame = 0, .x = 2, .y = 4, .vx = 5, .vy = 7}, raw);
  if (!read) return read.error();
  raw.row_rate = 2.5;
  return raw;
}

}  // namespace inhabit::io
