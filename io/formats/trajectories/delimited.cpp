#include "io/formats/trajectories/delimited.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/text.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

constexpr std::size_t kMostColumns = 64;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view unquoted(std::string_view field) {
  field = trimmed_line(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
  return field;
}

/// What is in the columns of one line; `problem` when it is no row.
struct Row {
  std::array<std::string_view, kMostColumns> fields;
  std::size_t count = 0;
  std::string problem;

  double number(int column, const char* what) {
    const std::optional<double> value = number_of(text(column));
    if (!value) fail(column, what, "is no number");
    return value.value_or(0);
  }
  std::int64_t whole(int column, const char* what) {
    const std::optional<std::int64_t> value = whole_of(text(column));
    if (!value) fail(column, what, "is no whole number");
    return value.value_or(0);
  }

 private:
  std::string_view text(int column) const { return fields[static_cast<std::size_t>(column)]; }
  void fail(int column, const char* what, const char* why) {
    if (!problem.empty()) return;
    problem.append(what).append(": ");
    problem.append(text(column).empty() ? "is empty" : quoted(text(column)) + " " + why);
  }
};

/// The frame rate of a file that has a column of frames and one of seconds; nearly whole rates are whole.
std::optional<double> rate_of(std::int64_t frames, double seconds) {
  if (frames <= 0 || !(seconds > 0)) return std::nullopt;
  const double rate = static_cast<double>(frames) / seconds;
  return std::abs(rate - std::round(rate)) <= 1e-4 * rate ? std::round(rate) : rate;
}

/// The earliest and the latest frame with their times.
struct Span {
  std::int64_t first = 0, last = 0;
  double from = 0, to = 0;
  bool empty = true;
  void add(std::int64_t frame, double time) {
    if (empty || frame < first) first = frame, from = time;
    if (empty || frame > last) last = frame, to = time;
    empty = false;
  }
};

}  // namespace

LineReader::LineReader(std::string_view text) : rest_(text) {
  if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view trimmed_line(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t split_line(std::string_view line, char separator, std::span<std::string_view> fields) {
  std::size_t count = 0;
  line = separator == '\t' ? line : trimmed_line(line);
  if (line.empty()) return 0;
  for (;;) {
    const std::size_t end = separator != 0
                                ? std::min(line.find(separator), line.size())
                                : static_cast<std::size_t>(std::ranges::find_if(line, is_space) - line.begin());
    if (count < fields.size()) fields[count] = unquoted(line.substr(0, end));
    ++count;
    if (end == line.size()) return count;
    line.remove_prefix(end + 1);
    if (separator == 0) line = trimmed_line(line);
  }
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> whole_of(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc{} && end == text.data() + text.size()) return value;
  const std::optional<double> number = number_of(text);
  // Up to 2^53 every whole number has a double of its own.
  if (!number || !(std::abs(*number) <= 9e15) || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

Status read_rows(LineReader& lines, const Columns& columns, RawTrajectories& raw) {
  RawRows rows(raw);
  Row row;
  Span span;
  const int last =
      std::max({columns.person, columns.frame, columns.time, columns.x, columns.y, columns.vx, columns.vy});
  while (lines.next()) {
    const std::string_view line = trimmed_line(lines.line());
    if (line.empty() || line.front() == columns.comment) continue;
    row.count = split_line(lines.line(), columns.separator, row.fields);
    if (row.count <= static_cast<std::size_t>(last))
      return invalid(lines.where(),
                     "has " + std::to_string(row.count) + " columns where " + std::to_string(last + 1) + " are needed");
    const std::int64_t person = row.whole(columns.person, "person");
    const std::int64_t frame = columns.frame >= 0 ? row.whole(columns.frame, "frame") : 0;
    const double time = columns.time >= 0 ? row.number(columns.time, "time") : 0;
    const double x = row.number(columns.x, "x"), y = row.number(columns.y, "y");
    if (columns.vx >= 0 && row.problem.empty())
      raw.speeds.push_back(
          static_cast<float>(std::hypot(row.number(columns.vx, "v_x"), row.number(columns.vy, "v_y"))));
    if (!row.problem.empty()) return invalid(lines.where(), row.problem);
    const bool taken = columns.frame >= 0 ? rows.add(person, frame, x, y, lines.number())
                                          : rows.add_at(person, time, x, y, lines.number());
    if (!taken) return invalid(lines.where(), rows.problem);
    if (columns.frame >= 0 && columns.time >= 0) span.add(frame, time);
  }
  if (!span.empty) raw.frame_rate = rate_of(span.last - span.first, span.to - span.from);
  return Done{};
}

std::size_t numeric_columns(std::string_view bytes) {
  LineReader lines(bytes);
  std::array<std::string_view, kMostColumns> fields;
  while (lines.next()) {
    const std::string_view line = trimmed_line(lines.line());
    if (line.empty()) continue;
    const std::size_t count = split_line(line, 0, fields);
    if (count > fields.size()) return 0;
    for (std::size_t k = 0; k < count; ++k)
      if (!number_of(fields[k])) return 0;
    return count;
  }
  return 0;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return out;
}
bool same_word(std::string_view a, std::string_view b) { return lower(a) == lower(b); }

}  // namespace inhabit::io
