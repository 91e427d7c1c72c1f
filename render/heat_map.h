#pragma once
#include "geometry/overlay.h"
#include "render/drawing.h"

namespace inhabit::render {

/// A quantity over the ground, as colours.
struct HeatMap {
  std::string title, subtitle;
  std::string label, unit;  ///< of the quantity
  Vec2 origin;              ///< lower left corner of the first cell, metres
  double cell = 0.2;        ///< metres
  int columns = 0, rows = 0;
  std::vector<float> values;   ///< row by row from the lowest y; NaN: no colour
  std::optional<double> most;  ///< value of the darkest colour; absent: the largest there is
  std::vector<Area> ground;    ///< its borders are drawn as walls
  std::vector<Ring> outlines;  ///< drawn as dashed frames
  std::vector<std::pair<Vec2, Vec2>> lines;
  double size = 900;  ///< long side of the page, points
};

/// The map with axes in metres and a scale of its colours.
Drawing draw_heat_map(const HeatMap& map);

/// Light to dark for 0 to 1, told apart in grey too.
Color heat_color(double share);

}  // namespace inhabit::render
