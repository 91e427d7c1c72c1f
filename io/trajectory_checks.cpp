#include "io/trajectory_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/text.h"

namespace inhabit::io {
namespace {

using scene::Fix;

constexpr double kSlowest = 0.1, kFastest = 5, kJump = 3;  // metres per second
constexpr double kWalking = 1.2;                           // what a question aims at
constexpr std::size_t kMostMeasured = 1'000'000;           // steps that a median is taken of

void renumber_people(RawTrajectories& raw) {
  if (raw.wide.empty()) return;
  std::vector<std::int64_t> people = raw.wide;
  std::ranges::sort(people);
  people.erase(std::unique(people.begin(), people.end()), people.end());
  for (std::size_t k = 0; k < raw.fixes.size(); ++k)
    raw.fixes[k].person = static_cast<std::int32_t>(std::ranges::lower_bound(people, raw.wide[k]) - people.begin()) + 1;
  raw.remarks.push_back("people's numbers do not fit 32 bits: they are numbered from 1 in order, " +
                        std::to_string(people.front()) + " first");
  raw.wide.clear();
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  if (values.empty()) return;
  std::vector<T> sorted;
  sorted.reserve(values.size());
  for (const std::uint32_t k : order) sorted.push_back(values[k]);
  values = std::move(sorted);
}

/// By frame, then person, then place in the file. Rows without a line become numbered when they move.
void sort_rows(RawTrajectories& raw) {
  const auto key = [](const Fix& fix) { return std::pair(fix.frame, fix.person); };
  if (std::ranges::is_sorted(raw.fixes, {}, key)) return;
  std::vector<std::uint32_t> order(raw.fixes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return std::pair(key(raw.fixes[k]), k); });
  reorder(raw.fixes, order);
  reorder(raw.lines, order);
  reorder(raw.speeds, order);
  if (raw.lines.empty()) raw.rows = std::move(order);
}

/// Drops rows that say the same as the one before. Requires: sorted.
Status drop_repetitions(RawTrajectories& raw) {
  std::vector<Fix>& fixes = raw.fixes;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < fixes.size(); ++k) {
    if (kept > 0 && fixes[kept - 1].frame == fixes[k].frame && fixes[kept - 1].person == fixes[k].person) {
      if (fixes[kept - 1] == fixes[k]) continue;
      return invalid(raw.where(k), "person " + std::to_string(fixes[k].person) + " is at another place in frame " +
                                       std::to_string(fixes[k].frame) + " than " + raw.where(k - 1) + " says");
    }
    if (!raw.speeds.empty()) raw.speeds[kept] = raw.speeds[k];
    fixes[kept++] = fixes[k];
  }
  if (kept < fixes.size())
    raw.remarks.push_back(std::to_string(fixes.size() - kept) + " rows say what another one says and are left out");
  fixes.resize(kept);
  if (!raw.speeds.empty()) raw.speeds.resize(kept);
  return Done{};
}

/// Calls step(a, b) with the indices of neighbouring fixes of one person, in order of the later one. Requires: sorted.
template <class Step>
void for_each_step(const std::vector<Fix>& fixes, Step step) {
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::int32_t> people;
  people.reserve(fixes.size());
  for (const Fix& fix : fixes) people.push_back(fix.person);
  std::ranges::sort(people);
  people.erase(std::unique(people.begin(), people.end()), people.end());
  const bool dense = static_cast<std::int64_t>(people.back()) - people.front() + 1 == std::ssize(people);
  std::vector<std::uint32_t> last(people.size(), kNone);
  for (std::uint32_t k = 0; k < fixes.size(); ++k) {
    const std::int32_t person = fixes[k].person;
    const auto place = static_cast<std::size_t>(dense ? person - people.front()
                                                      : std::ranges::lower_bound(people, person) - people.begin());
    if (last[place] != kNone) step(last[place], k);
    last[place] = k;
  }
}

std::int64_t frames_between(const Fix& a, const Fix& b) { return static_cast<std::int64_t>(b.frame) - a.frame; }

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The commonest number of frames from one row of a person to the next; 1 when nobody has two.
std::int64_t usual_step(const std::vector<Fix>& fixes) {
  std::vector<std::pair<std::int64_t, std::size_t>> counts;
  for_each_step(fixes, [&](std::uint32_t a, std::uint32_t b) {
    const std::int64_t step = frames_between(fixes[a], fixes[b]);
    const auto found = std::ranges::find(counts, step, &std::pair<std::int64_t, std::size_t>::first);
    if (found != counts.end())
      ++found->second;
    else if (counts.size() < 64)  // so that a file of all kinds of steps costs no more
      counts.emplace_back(step, 1);
  });
  std::ranges::sort(
      counts, [](const auto& a, const auto& b) { return std::pair(b.second, a.first) < std::pair(a.second, b.first); });
  return counts.empty() ? 1 : counts.front().first;
}

/// Median way per frame in the file's unit, over steps of the usual length; NaN when there are none.
double median_way(const std::vector<Fix>& fixes, std::int64_t usual) {
  std::vector<double> ways;
  const std::size_t stride = fixes.size() / kMostMeasured + 1;
  std::size_t count = 0;
  for_each_step(fixes, [&](std::uint32_t a, std::uint32_t b) {
    if (frames_between(fixes[a], fixes[b]) != usual || count++ % stride != 0) return;
    ways.push_back(length(fixes[b].at() - fixes[a].at()) / static_cast<double>(usual));
  });
  return ways.empty() ? std::numeric_limits<double>::quiet_NaN() : median(ways);
}

/// The frame rate at which the ways between the rows agree with the speeds that the file has beside them: a whole
/// number within three percent.
std::optional<double> rate_from_speeds(const RawTrajectories& raw, double scale) {
  if (raw.speeds.empty()) return std::nullopt;
  std::vector<double> rates;
  for_each_step(raw.fixes, [&](std::uint32_t a, std::uint32_t b) {
    const double way = scale * length(raw.fixes[b].at() - raw.fixes[a].at());
    const double speed = (static_cast<double>(raw.speeds[a]) + static_cast<double>(raw.speeds[b])) / 2;
    if (way > 0.05 && speed > 0.1 && std::isfinite(speed) && rates.size() < kMostMeasured)
      rates.push_back(speed * static_cast<double>(frames_between(raw.fixes[a], raw.fixes[b])) / way);
  });
  if (rates.size() < 5) return std::nullopt;
  const double rate = median(rates), whole = std::round(rate);
  return whole >= 1 && whole <= 10000 && std::abs(rate - whole) <= 0.03 * rate ? std::optional(whole) : std::nullopt;
}

/// Three digits: 1.1, 0.011, 134.
std::string speed_text(double speed) {
  if (!(speed > 0)) return "0 m/s";
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(speed))), 0, 6);
  return fixed(speed, digits) + " m/s";
}
double metres_in(LengthUnit unit) { return unit == LengthUnit::metres ? 1 : 0.01; }
const char* name_of(LengthUnit unit) { return unit == LengthUnit::metres ? "m" : "cm"; }

/// Which flags are missing, and values for them with which people would walk.
Error question(std::optional<LengthUnit> unit, std::optional<double> rate, double way, std::int64_t usual,
               std::optional<double> custom_row_rate) {
  std::string text = !unit && !rate
                         ? "the file says neither its unit nor its frame rate: --unit cm|m and --fps N say it"
                     : !unit ? "the file does not say its unit: --unit cm|m says it"
                             : "the file does not say its frame rate: --fps N says it";
  if (!(way > 0)) return invalid("", text);
  std::vector<LengthUnit> units{LengthUnit::centimetres, LengthUnit::metres};
  if (unit) units = {*unit};
  // The two rates that most recordings of pedestrians have.
  std::vector<double> rates{16, 25};
  if (custom_row_rate) rates = {*custom_row_rate * static_cast<double>(usual)};
  if (rate) rates = {*rate};
  const auto odds = [&](LengthUnit u) { return std::abs(std::log(way * metres_in(u) * rates.front() / kWalking)); };
  const LengthUnit likely = units.size() > 1 && odds(units[1]) < odds(units[0]) ? units[1] : units[0];
  std::string proposal;
  for (const double r : rates) {
    const std::string speed = speed_text(way * metres_in(likely) * r), fps = rate ? "" : shortest(r) + " fps";
    proposal += !proposal.empty() ? ", with " + fps + " " + speed
                                  : std::string("; with ") + (unit ? "" : name_of(likely)) +
                                        (unit || rate ? "" : " and ") + fps + " the median speed would be " + speed;
  }
  return invalid("", text + proposal);
}

/// What is odd about how people move. Requires: metres.
void remark_steps(const std::vector<Fix>& fixes, double rate, std::int64_t usual, std::vector<std::string>& remarks) {
  std::size_t gaps = 0, jumps = 0;
  std::int64_t longest = 0;
  double fastest = 0;
  Fix gap, jump;
  for_each_step(fixes, [&](std::uint32_t a, std::uint32_t b) {
    const std::int64_t frames = frames_between(fixes[a], fixes[b]);
    const double speed = length(fixes[b].at() - fixes[a].at()) * rate / static_cast<double>(frames);
    if (frames > usual) {
      ++gaps;
      if (frames > longest) longest = frames, gap = fixes[a];
    }
    if (speed > kJump) {
      ++jumps;
      if (speed > fastest) fastest = speed, jump = fixes[a];
    }
  });
  if (gaps > 0)
    remarks.push_back(std::to_string(gaps) + (gaps == 1 ? " gap" : " gaps") + " in the tracks, the longest " +
                      std::to_string(longest) + " frames: person " + std::to_string(gap.person) + " after frame " +
                      std::to_string(gap.frame));
  if (jumps > 0)
    remarks.push_back(std::to_string(jumps) + (jumps == 1 ? " step" : " steps") + " faster than 3 m/s, the fastest " +
                      speed_text(fastest) + ": person " + std::to_string(jump.person) + " after frame " +
                      std::to_string(jump.frame));
}

void remark_speed(double speed, std::vector<std::string>& remarks) {
  if (!std::isfinite(speed) || (speed >= kSlowest && speed <= kFastest)) return;
  std::string text = "the median speed is " + speed_text(speed);
  if (speed > kFastest) text += ", which nobody walks";
  if (speed / 100 >= kSlowest && speed / 100 <= kFastest) text += "; centimetres? (--unit cm)";
  if (speed * 100 >= 0.3 && speed * 100 <= 3) text += "; metres, or another frame rate? (--unit, --fps)";
  remarks.push_back(std::move(text));
}

}  // namespace

Result<scene::Trajectories> checked_trajectories(RawTrajectories raw, const TrajectoryOptions& options) {
  if (raw.fixes.empty()) return invalid("", "there is no position in it");
  for (const std::optional<double>& rate : {options.frame_rate, raw.frame_rate, raw.row_rate})
    if (rate && !(*rate > 0 && *rate <= 10000))
      return invalid("", "a frame rate of " + shortest(*rate) + " is none; it is above 0 and at most 10000");
  renumber_people(raw);
  std::optional<LengthUnit> unit = options.unit ? options.unit : raw.unit;
  if (options.unit && raw.unit && *options.unit != *raw.unit)
    raw.remarks.push_back(std::string("the file says ") + name_of(*raw.unit) + ", but --unit " + name_of(*unit) +
                          " counts");
  if (!raw.times.empty()) {
    if (const Status done = frames_from_times(raw, options.frame_rate); !done) return done.error();
    if (raw.fixes.empty()) return invalid("", "nobody is there for a whole frame");
  }
  sort_rows(raw);
  if (const Status done = drop_repetitions(raw); !done) return done.error();

  const std::int64_t usual = usual_step(raw.fixes);
  std::optional<double> rate = options.frame_rate ? options.frame_rate : raw.frame_rate;
  if (options.frame_rate && raw.frame_rate && *options.frame_rate != *raw.frame_rate)
    raw.remarks.push_back("the file says " + shortest(*raw.frame_rate) + " frames per second, but --fps " +
                          shortest(*rate) + " counts");
  if (!rate && unit) rate = rate_from_speeds(raw, metres_in(*unit));
  if (!rate && raw.row_rate) rate = *raw.row_rate * static_cast<double>(usual);
  const double way = median_way(raw.fixes, usual);
  if (!unit || !rate) return question(unit, rate, way, usual, raw.custom_row_rate);

  scene::Trajectories out;
  if (*unit == LengthUnit::centimetres)
    for (Fix& fix : raw.fixes) fix.x /= 100, fix.y /= 100;
  remark_speed(way * metres_in(*unit) * *rate, raw.remarks);
  remark_steps(raw.fixes, *rate, usual, raw.remarks);
  out.fixes = std::move(raw.fixes);
  out.frame_rate = *rate;
  out.walkable = std::move(raw.walkable);
  out.name = std::move(raw.title);
  out.remarks = std::move(raw.remarks);
  return out;
}

}  // namespace inhabit::io
