#include "crowd/measures/lanes.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/measures/test_recording.h"
#include "crowd/measures/velocity.h"

using namespace inhabit;
using namespace inhabit::crowd;

namespace {

/// Mean order of people who stand across the flow at y = spacing * (p % rows) and go the way that `way` says.
template <class F>
double order_of(int people, int rows, double spacing, F way, double band) {
  const auto t = walkers(people, 3, 10, [&](int p, double s) {
    return Vec2{1.0 * (p / rows) + way(p) * s, spacing * (p % rows)};
  });
  const Recording r(t);
  return mean_order(lanes(r, velocities(r, {1, SpeedWindow::Ends::one_sided}), {{1, 0}, band, 3}));
}

}  // namespace

TEST_CASE("perfect lanes have order one") {
  CHECK(order_of(
            60, 6, 0.6, [](int p) { return p % 2 ? 1.0 : -1.0; }, 0.5) == doctest::Approx(1).epsilon(1e-12));
  CHECK(order_of(
            60, 6, 0.6, [](int p) { return p % 6 < 3 ? 1.0 : -1.0; }, 0.5) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("lanes that are wider apart than the band do not mix") {
  // Rows 0.6 m apart of alternating ways and a band that takes in one neighbour on each side: inner people see one row
  // of theirs and two of the others, (10 - 20)² / 30² = 1/9; the two outer rows see one each, 0.
  CHECK(order_of(
            60, 6, 0.6, [](int p) { return p % 2 ? 1.0 : -1.0; }, 0.7) == doctest::Approx(4.0 / 6 / 9).epsilon(1e-12));
}

TEST_CASE("a band of people who go either way by chance has the order of chance") {
  Rng rng(21);
  std::vector<double> ways;
  for (int p = 0; p < 6000; ++p) ways.push_back(rng.uniform() < 0.5 ? 1.0 : -1.0);
  // 300 rows of 20 people: the mean of the order is 1/20, its deviation sqrt(2)/20/sqrt(300) = 0.004.
  const double order = order_of(
      6000, 300, 1, [&](int p) { return ways[static_cast<std::size_t>(p)]; }, 0.5);
  CHECK(std::abs(order - 0.05) < 0.016);
}

TEST_CASE("one-way flow has no order") {
  CHECK(!known(order_of(
      60, 6, 0.6, [](int) { return 1.0; }, 0.5)));
}

TEST_CASE("a crowd that sways on the spot is no two-way flow") {
  CHECK(!known(order_of(
      60, 6, 0.6, [](int p) { return p % 2 ? 0.19 : -0.19; }, 0.5)));
  CHECK(known(order_of(
      60, 6, 0.6, [](int p) { return p % 2 ? 0.21 : -0.21; }, 0.5)));
}
