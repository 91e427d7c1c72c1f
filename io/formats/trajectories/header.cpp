#include "io/formats/trajectories/header.h"

#include <charconv>

#include "io/formats/trajectories/areas.h"

namespace inhabit::io {
namespace {

constexpr std::string_view kTitle = "title:", kWalkable = "walkable area:";

/// The first number behind `word`, if there is one on the line.
std::optional<double> number_after(std::string_view line, std::string_view word) {
  const std::size_t at = lower(line).find(word);
  if (at == std::string::npos) return std::nullopt;
  const std::string_view rest = line.substr(at + word.size());
  const std::size_t digit = rest.find_first_of("0123456789");
  if (digit == std::string_view::npos) return std::nullopt;
  double value = 0;
  const auto [end, problem] = std::from_chars(rest.data() + digit, rest.data() + rest.size(), value);
  return problem == std::errc{} ? std::optional(value) : std::nullopt;
}

}  // namespace

Comments read_comments(LineReader& lines) {
  Comments comments;
  while (lines.next()) {
    std::string_view line = trimmed_line(lines.line());
    if (line.empty()) continue;
    if (line.front() != '#') break;
    line = trimmed_line(line.substr(1));
    comments.any = true;
    if (!comments.frame_rate) comments.frame_rate = number_after(line, "framerate");
    if (!comments.frame_rate) comments.frame_rate = number_after(line, "frame rate");
    if (line.starts_with(kTitle)) {
      comments.title = trimmed_line(line.substr(kTitle.size()));
    } else if (line.starts_with(kWalkable)) {
      comments.walkable = trimmed_line(line.substr(kWalkable.size()));
    } else {
      const std::string words = lower(line);
      const auto says = [&](const char* part) { return words.find(part) != std::string::npos; };
      if (says("x/cm") || says("in cm")) comments.unit = LengthUnit::centimetres;
      if (says("x/m") || says("in m")) comments.unit = LengthUnit::metres;
      comments.columns = column_names(line, 0);
    }
  }
  return comments;
}

void take_comments(const Comments& comments, RawTrajectories& raw) {
  if (comments.frame_rate) raw.frame_rate = comments.frame_rate;
  if (comments.unit) raw.unit = comments.unit;
  if (!comments.title.empty()) raw.title = comments.title;
  if (!comments.walkable.empty()) take_walkable(comments.walkable, raw);
}

char separator_of(std::string_view line) {
  for (const char separator : {'\t', ';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return 0;
}

std::vector<std::string_view> column_names(std::string_view line, char separator) {
  std::vector<std::string_view> names(64);
  names.resize(std::min(names.size(), split_line(line, separator, names)));
  return names;
}

int column_of(const std::vector<std::string_view>& names, std::initializer_list<std::string_view> wanted) {
  for (const std::string_view name : wanted)
    for (std::size_t k = 0; k < names.size(); ++k)
      if (same_word(names[k], name)) return static_cast<int>(k);
  return -1;
}

int column_with(const std::vector<std::string_view>& names, std::string_view part) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k].find(part) != std::string_view::npos) return static_cast<int>(k);
  return -1;
}

}  // namespace inhabit::io
