#include "crowd/measures/density_field.h"

#include <doctest/doctest.h>

#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("the field of a room sums up to the people in it") {
  // One standing person in the left half of a room, two walking ones in the right half.
  auto t = walkers(3, 20, 10, [](int p, double) { return p == 0 ? Vec2{1, 1} : Vec2{3, p == 1 ? 0.5 : 1.5}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 4, 2), {}}});
  std::vector<double> speed;
  for (const scene::Fix& fix : t.fixes) speed.push_back(fix.person == 0 ? 0 : 1.5);
  const DensityField field = density_field(r, ground, speed, {.cell = 0.1});
  double people = 0;
  for (const float d : field.density) people += known(d) ? d * field.cell * field.cell : 0;
  // The raster meets the cells' borders to within one row of its own cells.
  CHECK(std::abs(people - 3) < 0.15);
  CHECK(field.density[0] == doctest::Approx(0.25).epsilon(0.05));
  CHECK(field.speed[0] == 0);
  CHECK(field.most() == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("threads change no byte of a field") {
  auto t = walkers(12, 50, 10, [](int p, double s) { return Vec2{0.3 * p + 0.1 * s, 1 + 0.5 * (p % 3)}; });
  const Recording r(t);
  const VoronoiGround ground({{rectangle(0, 0, 5, 4), {}}}, 0.8);
  const std::vector<double> speed(t.fixes.size(), 0.1);
  const DensityField one = density_field(r, ground, speed, {.threads = 1});
  const DensityField four = density_field(r, ground, speed, {.threads = 4});
  CHECK(one.density == four.density);
}
