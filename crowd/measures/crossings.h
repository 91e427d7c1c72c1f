#pragma once
#include <optional>
#include <utility>

#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// A line to count at. Forward is from its right to its left, looking from a to b.
struct MeasureLine {
  Vec2 a, b;
  double length() const { return geometry::length(b - a); }
  Vec2 forward() const { return perp(unit(b - a)); }
};

struct Crossing {
  double seconds = 0;  ///< interpolated between the fixes before and after
  std::int32_t person = 0;
  int direction = 1;  ///< 1 forward, -1 backward
  Vec2 at;
  double speed = 0;  ///< metres per second along the line's normal, between the two fixes; > 0
};

/// Every passage of a person from one side of the line to the other between two of their fixes, in order of time, then
/// person. A fix on the line counts as left of it, so that touching is no crossing and nobody is counted twice. Fixes
/// more than `longest_gap` seconds apart are not joined.
std::vector<Crossing> crossings(const Recording& recording, const MeasureLine& line, double longest_gap = 1);

/// What passed a line. Each person counts once, when they cross for the first time [PedPy compute_n_t].
struct Flow {
  int forward = 0, backward = 0;  ///< people
  std::vector<double> times;      ///< of first crossings, ascending: N(t) steps up by one at each
  double from = 0, until = 0;     ///< first and last of them
  double flow = kUnknown;         ///< people per second: (N - 1) / (until - from), one over the mean headway
  double specific = kUnknown;     ///< people per second and metre of the line
  std::vector<double> headways;   ///< seconds between one and the next
  double speed = kUnknown;        ///< mean speed of those crossings along the normal, metres per second
};
Flow flow(std::span<const Crossing> crossings, double width);

/// The steady part of a run: while the middle three fifths of the people cross, seconds. Fundamental diagrams are those
/// of steady flow; literature chooses the span by eye. Nothing for fewer than 20 people.
std::optional<std::pair<double, double>> steady_span(const Flow& flow);

/// People who crossed for the first time in each interval of `step` seconds, divided by step: the flow over time.
std::vector<Vec2> flow_over_time(const Flow& flow, double step);

}  // namespace inhabit::crowd
