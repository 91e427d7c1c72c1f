#pragma once
#include <span>
#include <string_view>

#include "io/formats/trajectories/raw.h"

/// Tables in text, which most formats of trajectories are: one row per line, numbers in columns.
namespace inhabit::io {

/// Goes through a text line by line; a byte order mark at the start and carriage returns are left out.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  /// False at the end of the text.
  bool next();
  std::string_view line() const { return line_; }
  std::uint32_t number() const { return number_; }
  std::string where() const { return "line " + std::to_string(number_); }

 private:
  std::string_view rest_, line_;
  std::uint32_t number_ = 0;
};

std::string_view trimmed_line(std::string_view text);
/// Cuts the line at `separator`, or where there is white space when that is 0, and returns how many fields there are,
/// which may be more than `fields` takes. Fields have no white space or quotation marks around them.
std::size_t split_line(std::string_view line, char separator, std::span<std::string_view> fields);
/// The number that is the whole text, perhaps not a finite one.
std::optional<double> number_of(std::string_view text);
/// The whole number that is the whole text: 12, 12.0, 1.2e+01.
std::optional<std::int64_t> whole_of(std::string_view text);

/// Which column holds what, from 0; -1: none does.
struct Columns {
  int person = -1, frame = -1, time = -1, x = -1, y = -1, vx = -1, vy = -1;
  char separator = 0;  ///< 0: white space
  char comment = '#';
};

/// Reads the lines that are left; empty ones and comments are passed over. Where there is a column of frames and one of
/// times, the frame rate follows. Errors name the line.
Status read_rows(LineReader& lines, const Columns& columns, RawTrajectories& raw);

/// The first line that is no comment has at least `least` columns and all of them are numbers: how many. Else 0.
std::size_t numeric_columns(std::string_view bytes);

/// "x" in any case.
bool same_word(std::string_view a, std::string_view b);
std::string lower(std::string_view text);

}  // namespace inhabit::io
