#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "core/text.h"
#include "io/trajectory_checks.h"

namespace inhabit::io {
namespace {

/// Of event files, which have no rate of their own.
constexpr double kEventRate = 25;
/// Times are written with few digits: this share of a frame is nothing.
constexpr double kSlack = 0.25;
/// Half a gigabyte of positions; a few bytes of times far apart could ask for any number.
constexpr double kMostInterpolated = 20e6;

/// Row numbers by person, then time.
std::vector<std::uint32_t> by_person_and_time(const RawTrajectories& raw) {
  std::vector<std::uint32_t> order(raw.fixes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return std::tuple(raw.fixes[k].person, raw.times[k], k); });
  return order;
}

/// The rate of evenly spaced times: the mean of the gaps that are not much longer than the median one.
std::optional<double> rate_of_times(const RawTrajectories& raw, const std::vector<std::uint32_t>& order) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (raw.fixes[order[k]].person != raw.fixes[order[k - 1]].person) continue;
    const double gap = raw.times[order[k]] - raw.times[order[k - 1]];
    if (gap > 0) gaps.push_back(gap);
  }
  if (gaps.empty()) return std::nullopt;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  const double limit = 1.5 * *middle;
  std::erase_if(gaps, [&](double gap) { return gap > limit; });
  std::ranges::sort(gaps);  // so that the sum is that of the set
  const double rate = static_cast<double>(gaps.size()) / std::accumulate(gaps.begin(), gaps.end(), 0.0);
  if (!std::isfinite(rate) || rate > 10000 || rate < 1e-6) return std::nullopt;
  if (rate >= 1 && std::abs(rate - std::round(rate)) <= 0.005 * rate) return std::round(rate);
  return std::round(rate * 1000) / 1000 > 0 ? std::round(rate * 1000) / 1000 : rate;
}

/// Whether every time lies near a frame that fits 32 bits when frame 0 is at `start`.
bool all_near_frames(const std::vector<double>& times, double rate, double start) {
  return std::ranges::all_of(times, [&](double t) {
    const double f = (t - start) * rate;
    return std::abs(f - std::round(f)) <= kSlack && std::abs(f) < 2e9;
  });
}

/// The rows [from, to) of `order` are one person's.
struct Run {
  std::size_t from = 0, to = 0;
  double first = 0, last = 0;  ///< frames, whole numbers
};

std::vector<Run> runs_of(const RawTrajectories& raw, const std::vector<std::uint32_t>& order, double rate,
                         double start) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < order.size();) {
    Run run{k, k};
    while (run.to < order.size() && raw.fixes[order[run.to]].person == raw.fixes[order[k]].person) ++run.to;
    // A frame that rounding puts just outside belongs to the person.
    run.first = std::ceil((raw.times[order[k]] - start) * rate - 1e-6);
    run.last = std::floor((raw.times[order[run.to - 1]] - start) * rate + 1e-6);
    runs.push_back(run);
    k = run.to;
  }
  return runs;
}

void append_run(const RawTrajectories& raw, const std::vector<std::uint32_t>& order, const Run& run, double rate,
                double start, std::vector<scene::Fix>& out, std::vector<std::uint32_t>& lines) {
  std::size_t k = run.from;
  for (double frame = run.first; frame <= run.last; ++frame) {
    const double t = start + frame / rate;
    while (k + 1 < run.to && raw.times[order[k + 1]] < t) ++k;
    const std::size_t next = std::min(k + 1, run.to - 1);
    const double from = raw.times[order[k]], to = raw.times[order[next]];
    const double share = to > from ? std::clamp((t - from) / (to - from), 0.0, 1.0) : 0;
    const scene::Fix &a = raw.fixes[order[k]], &b = raw.fixes[order[next]];
    out.push_back({static_cast<std::int32_t>(frame), a.person, a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    if (!raw.lines.empty()) lines.push_back(raw.lines[order[k]]);
  }
}

Status interpolate(RawTrajectories& raw, const std::vector<std::uint32_t>& order, double rate, double start) {
  for (std::size_t k = 1; k < order.size(); ++k) {
    const scene::Fix &a = raw.fixes[order[k - 1]], &b = raw.fixes[order[k]];
    if (a.person == b.person && raw.times[order[k]] == raw.times[order[k - 1]] && a.at() != b.at())
      return invalid(raw.where(order[k]), "person " + std::to_string(b.person) + " is at two places at " +
                                              shortest(raw.times[order[k]]) + " s, also in " + raw.where(order[k - 1]));
  }
  const std::vector<Run> runs = runs_of(raw, order, rate, start);
  double count = 0;
  std::size_t lost = 0;
  for (const Run& run : runs) {
    if (std::abs(run.first) > 2e9 || std::abs(run.last) > 2e9)
      return invalid("", "the times reach over more frames than 32 bits hold; a smaller --fps has fewer");
    count += std::max(0.0, run.last - run.first + 1);
    lost += run.last < run.first;
  }
  if (count > kMostInterpolated)
    return invalid("", "would become " + shortest(count) + " positions at " + shortest(rate) +
                           " frames per second; a smaller --fps has fewer");
  std::vector<scene::Fix> fixes;
  std::vector<std::uint32_t> lines;
  fixes.reserve(static_cast<std::size_t>(count));
  for (const Run& run : runs) append_run(raw, order, run, rate, start, fixes, lines);
  if (lost > 0) raw.remarks.push_back(std::to_string(lost) + " people are there for less than a frame and left out");
  raw.fixes = std::move(fixes);
  raw.lines = std::move(lines);
  return Done{};
}

}  // namespace

Status frames_from_times(RawTrajectories& raw, std::optional<double> frame_rate) {
  const std::vector<std::uint32_t> order = by_person_and_time(raw);
  std::optional<double> rate = frame_rate ? frame_rate : raw.frame_rate;
  if (!rate && !raw.irregular) rate = rate_of_times(raw, order);
  const bool guessed = !rate;
  if (!rate) rate = kEventRate;
  const double earliest = *std::ranges::min_element(raw.times);
  const bool far = std::abs(earliest) * *rate > 1e9;
  double start = far ? std::floor(earliest) : 0;
  bool even = !raw.irregular && all_near_frames(raw.times, *rate, start);
  if (!even && !raw.irregular && all_near_frames(raw.times, *rate, earliest)) even = true, start = earliest;
  if (start != 0)
    raw.remarks.push_back("frame 0 is at " + fixed(start, start == std::floor(start) ? 0 : 3) + " s of the file");
  if (even) {
    for (std::size_t k = 0; k < raw.fixes.size(); ++k)
      raw.fixes[k].frame = static_cast<std::int32_t>(std::lround((raw.times[k] - start) * *rate));
  } else if (const Status done = interpolate(raw, order, *rate, start); !done) {
    return done;
  }
  if (!even)
    raw.remarks.push_back("positions are interpolated at " + shortest(*rate) + " frames per second" +
                          (frame_rate || raw.frame_rate ? "" : "; --fps N says otherwise"));
  else if (guessed)
    raw.remarks.push_back("all at one moment: " + shortest(*rate) + " frames per second are assumed");
  raw.times.clear();
  raw.frame_rate = rate;
  return Done{};
}

}  // namespace inhabit::io
