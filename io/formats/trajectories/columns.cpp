#include "io/formats/trajectories/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "io/formats/trajectories/delimited.h"

namespace inhabit::io {
namespace {

/// The median distance between one person's neighbouring rows.
double median_step(const std::vector<scene::Fix>& fixes) {
  std::vector<std::uint32_t> order(fixes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return std::tuple(fixes[k].person, fixes[k].frame, k); });
  std::vector<double> steps;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const scene::Fix &a = fixes[order[k - 1]], &b = fixes[order[k]];
    if (a.person == b.person) steps.push_back(length(b.at() - a.at()));
  }
  if (steps.empty()) return std::numeric_limits<double>::infinity();
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  return steps[steps.size() / 2];
}

}  // namespace

bool is_columns(std::string_view bytes) { return numeric_columns(bytes) >= 4; }

Result<RawTrajectories> read_columns(std::string_view bytes) {
  RawTrajectories raw;
  LineReader lines(bytes);
  const Status read = read_rows(lines, {.person = 0, .frame = 1, .x = 2, .y = 3}, raw);
  if (!read) return read.error();
  if (!raw.wide.empty()) return raw;
  std::vector<scene::Fix> frame_first = raw.fixes;
  for (scene::Fix& fix : frame_first) std::swap(fix.frame, fix.person);
  if (median_step(frame_first) < median_step(raw.fixes)) {
    raw.fixes = std::move(frame_first);
    raw.custom_row_rate = 2.5;
  }
  return raw;
}

}  // namespace inhabit::io
