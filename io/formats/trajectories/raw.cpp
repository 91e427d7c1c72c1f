#include "io/formats/trajectories/raw.h"

#include <cmath>
#include <limits>

#include "core/text.h"

namespace inhabit::io {
namespace {

/// Farther than any two points of the earth; what is larger is a mistake, and its square must not overflow.
constexpr double kFarthest = 1e9;
/// More than thirty thousand years, or a clock in microseconds.
constexpr double kLatest = 1e12;

bool fits(std::int64_t value) {
  return value >= std::numeric_limits<std::int32_t>::min() && value <= std::numeric_limits<std::int32_t>::max();
}

}  // namespace

bool RawRows::add(std::int64_t person, std::int64_t frame, double x, double y, std::uint32_t line) {
  if (!std::isfinite(x) || !std::isfinite(y)) return problem = "a position must be a finite number", false;
  if (std::abs(x) > kFarthest || std::abs(y) > kFarthest)
    return problem = "(" + shortest(x) + ", " + shortest(y) + ") is no position on a plan", false;
  if (!fits(frame)) return problem = "frame " + std::to_string(frame) + " does not fit 32 bits", false;
  if (raw_.fixes.size() >= kMostRows)
    return problem = "more than " + std::to_string(kMostRows / 1'000'000) + " million positions", false;
  if (!fits(person) && raw_.wide.empty()) {
    raw_.wide.reserve(raw_.fixes.capacity());
    for (const scene::Fix& fix : raw_.fixes) raw_.wide.push_back(fix.person);
    raw_.wide.push_back(person);
  } else if (!raw_.wide.empty()) {
    raw_.wide.push_back(person);
  }
  raw_.fixes.push_back({static_cast<std::int32_t>(frame), fits(person) ? static_cast<std::int32_t>(person) : 0, x, y});
  if (line != 0) raw_.lines.push_back(line);
  return true;
}

bool RawRows::add_at(std::int64_t person, double time, double x, double y, std::uint32_t line) {
  if (!std::isfinite(time) || std::abs(time) > kLatest) return problem = "the time must be a finite number", false;
  if (!add(person, 0, x, y, line)) return false;
  raw_.times.push_back(time);
  return true;
}

}  // namespace inhabit::io
