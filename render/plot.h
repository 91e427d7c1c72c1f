#pragma once
#include "layout/furnish.h"
#include "render/drawing.h"

namespace inhabit::render {

struct Axis {
  std::string label, unit;  ///< written as "label [unit]"
  bool log = false;
  std::optional<double> min, max;  ///< absent: from the data
};

enum class Marker { none, circle, square, triangle };

struct Series {
  std::string label;         ///< absent: not in the legend
  std::vector<Vec2> points;  ///< numbers that are not finite, or not positive on a log axis, interrupt the line
  std::vector<std::pair<double, double>> band;  ///< low and high at each point; may be empty
  std::optional<Color> color;                   ///< absent: the next of the palette
  Marker marker = Marker::none;
  double width = 1.8;  ///< 0: markers only
  bool dashed = false;
};

/// A point with a word beside it.
struct Annotation {
  Vec2 at;
  std::string text;
  std::optional<Color> color;
};

struct Plot {
  std::string title, subtitle;
  Axis x, y;
  std::vector<Series> series;
  std::vector<Annotation> annotations;
  std::optional<double>
      guide_slope;  ///< on two log axes: a faint line of this power through the first series' first point
  std::string guide_label;
  Vec2 size{900, 560};
};

Drawing draw_plot(const Plot& plot);

/// Energy per iteration (TVCG fig. 13's axes): one line per start, the best one dark, its first feasible iteration
/// marked. The best start is the one whose least energy among feasible rows, or else among all, is least. Log axis when
/// it spans decades.
Drawing draw_energy(std::span<const layout::TraceRow> trace);

/// Ticks at 1, 2 or 5 times powers of ten that cover [low, high] with about `wanted` steps. Requires: low < high,
/// finite.
std::vector<double> nice_ticks(double low, double high, int wanted);
/// Powers of ten within [low, high]; with 2 and 5 between them below two decades. Requires: 0 < low < high.
std::vector<double> log_ticks(double low, double high);

}  // namespace inhabit::render
