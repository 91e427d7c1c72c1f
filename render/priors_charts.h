#pragma once
#include <vector>

#include "render/drawing.h"

/// The charts on the cards of render/priors_page.h.
namespace inhabit::render {

/// The colour of the k-th mode.
Color mode_color(int mode);

/// A number of one mode, or a direction (radians).
struct Tally {
  double value = 0;
  int mode = 0;
};
/// What a mode says of it.
struct Bell {
  double mean = 0, deviation = 0;
};

/// A histogram stacked by mode, with every mode's mean as a line and one deviation to both sides as a bar above.
void draw_histogram(Drawing& drawing, Vec2 corner, Vec2 size, const std::vector<Tally>& values,
                    const std::vector<Bell>& modes, std::string_view label);

/// Directions in 24 bins round a centre, stacked by mode, 0 up, counter-clockwise; areas are in proportion to counts.
/// Every mode's mean as an arrow, one deviation to both sides as an arc.
void draw_rose(Drawing& drawing, Vec2 center, double radius, const std::vector<Tally>& angles,
               const std::vector<Bell>& modes);

}  // namespace inhabit::render
