#include "io/formats/trajectories/splines.h"

#include <cmath>

#include "io/formats/trajectories/delimited.h"

namespace inhabit::io {
namespace {

constexpr double kFrameRate = 25;

geometry::Vec2 mapped(const Homography& h, double x, double y) {
  const double scale = h[6] * x + h[7] * y + h[8];
  return {(h[0] * x + h[1] * y + h[2]) / scale, (h[3] * x + h[4] * y + h[5]) / scale};
}

/// The text of a line without the comment, which starts with a dash that stands alone.
std::string_view content(std::string_view line) {
  const std::size_t comment = line.find(" - ");
  return trimmed_line(line.substr(0, comment));
}

/// The next line that has anything: its numbers.
bool next_numbers(LineReader& lines, std::array<double, 4>& numbers, std::size_t& count, bool& good) {
  std::array<std::string_view, 4> fields;
  while (lines.next()) {
    const std::string_view line = content(lines.line());
    if (line.empty()) continue;
    count = split_line(line, 0, fields);
    good = count <= fields.size();
    for (std::size_t k = 0; good && k < count; ++k) {
      const std::optional<double> number = number_of(fields[k]);
      good = number.has_value();
      if (good) numbers[k] = *number;
    }
    return true;
  }
  return false;
}

}  // namespace

Result<Homography> read_homography(std::string_view text) {
  Homography h{};
  std::size_t count = 0;
  LineReader lines(text);
  while (lines.next()) {
    std::array<std::string_view, 16> fields;
    const std::size_t columns = std::min(fields.size(), split_line(lines.line(), 0, fields));
    for (std::size_t k = 0; k < columns; ++k, ++count) {
      const std::optional<double> number = number_of(fields[k]);
      if (!number || !std::isfinite(*number)) return invalid(lines.where(), "a homography is nine numbers");
      if (count < h.size()) h[count] = *number;
    }
  }
  if (count != h.size()) return invalid("", "a homography is nine numbers, not " + std::to_string(count));
  const double determinant =
      h[0] * (h[4] * h[8] - h[5] * h[7]) - h[1] * (h[3] * h[8] - h[5] * h[6]) + h[2] * (h[3] * h[7] - h[4] * h[6]);
  if (determinant == 0 || !std::isfinite(determinant)) return invalid("", "the homography's determinant is 0");
  return h;
}

bool is_splines(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  return bytes.substr(0, std::min<std::size_t>(end, 4096)).find("number of splines") != std::string_view::npos;
}

Result<RawTrajectories> read_splines(std::string_view bytes, const Homography* ground_from_image) {
  if (ground_from_image == nullptr)
    return invalid("",
                   "positions are pixels: --homography FILE with the 3x3 matrix from the image to metres is needed");
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  raw.irregular = true;
  raw.frame_rate = kFrameRate;
  RawRows rows(raw);
  LineReader lines(bytes);
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  bool good = false;
  const auto whole = [&](double most) {
    return good && count == 1 && numbers[0] >= 0 && numbers[0] <= most && numbers[0] == std::floor(numbers[0]);
  };
  if (!next_numbers(lines, numbers, count, good) || !whole(1e9))
    return invalid("line 1", "the number of splines belongs here");
  const auto people = static_cast<std::int64_t>(numbers[0]);
  for (std::int64_t person = 1; person <= people; ++person) {
    if (!next_numbers(lines, numbers, count, good))
      return invalid("", "ends after " + std::to_string(person - 1) + " of " + std::to_string(people) + " people");
    if (!whole(1e9)) return invalid(lines.where(), "the number of control points belongs here");
    const auto points = static_cast<std::int64_t>(numbers[0]);
    for (std::int64_t k = 0; k < points; ++k) {
      if (!next_numbers(lines, numbers, count, good))
        return invalid("", "ends within person " + std::to_string(person));
      if (!good || count < 3) return invalid(lines.where(), "a control point is x y frame gaze");
      const geometry::Vec2 p = mapped(*ground_from_image, numbers[0], numbers[1]);
      if (!rows.add_at(person, numbers[2] / kFrameRate, p.x, p.y, lines.number()))
        return invalid(lines.where(), rows.problem);
    }
  }
  return raw;
}

}  // namespace inhabit::io
