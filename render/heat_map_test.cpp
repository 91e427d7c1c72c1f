#include "render/heat_map.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace inhabit::render;

namespace {

std::size_t shapes(const Drawing& drawing, Color color) {
  std::size_t count = 0;
  for (const auto& item : drawing.items)
    if (const auto* shape = std::get_if<Shape>(&item))
      count += shape->style.fill && *shape->style.fill == color ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("a heat map has a colour for each value and none for what is unknown") {
  HeatMap map;
  map.columns = 3, map.rows = 2, map.cell = 1;
  map.values = {0, 0, 8, std::nanf(""), 4, 8};
  const Drawing drawing = draw_heat_map(map);
  // Each of these colours twice: on the map and in the scale.
  CHECK(shapes(drawing, heat_color(0.5 / 32)) == 2);
  CHECK(shapes(drawing, heat_color(31.5 / 32)) == 2);
  CHECK(shapes(drawing, heat_color(16.5 / 32)) == 2);
  CHECK(shapes(drawing, heat_color(10.5 / 32)) == 1);
  CHECK(encode(drawing, Format::svg).ok());
}

TEST_CASE("darker means more") {
  double before = 1e9;
  for (double share = 0; share <= 1; share += 0.05) {
    const Color c = heat_color(share);
    const double light = 0.299 * c.r + 0.587 * c.g + 0.114 * c.b;
    CHECK(light < before);
    before = light;
  }
}

TEST_CASE("a map of nothing is a page all the same") { CHECK(encode(draw_heat_map({}), Format::svg).ok()); }
