#include "crowd/measures/overlaps.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "crowd/measures/test_recording.h"

using namespace inhabit;
using namespace inhabit::crowd;

TEST_CASE("discs that pass through each other are deepest where they meet") {
  // Head on at 1 m/s each along lines 0.1 m apart: least distance 0.1 m at t = 2 s.
  const auto t = walkers(2, 41, 10, [](int p, double s) { return p == 0 ? Vec2{s - 2, 0.0} : Vec2{2 - s, 0.1}; });
  const Overlaps o = overlaps(Recording(t), {0.25});
  CHECK(o.worst == doctest::Approx(0.4).epsilon(1e-12));
  CHECK(o.worst_share == doctest::Approx(0.8).epsilon(1e-12));
  CHECK(o.worst_seconds == doctest::Approx(2));
  CHECK(o.first == 0);
  CHECK(o.second == 1);
  // |2 (t - 2)|² + 0.1² < 0.5² for |t - 2| < 0.2449…: five frames.
  CHECK(o.pairs == 5);
}

TEST_CASE("touching discs do not overlap") {
  const auto t = walkers(9, 1, 10, [](int p, double) { return Vec2{0.5 * (p % 3), 0.5 * (p / 3)}; });
  CHECK(overlaps(Recording(t), {0.25}).pairs == 0);
  CHECK(overlaps(Recording(t), {0.2501}).pairs == 12);
}

TEST_CASE("radii of their own are taken") {
  const auto t = walkers(2, 1, 10, [](int p, double) { return Vec2{1.0 * p, 0}; });
  const Radii radii{0, {0.3f, 0.8f}};
  const Overlaps o = overlaps(Recording(t), radii);
  CHECK(o.worst == doctest::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("overlaps are those of all pairs") {
  Rng rng(9);
  const auto t = walkers(150, 5, 10, [&](int, double) { return Vec2{rng.uniform(0, 6), rng.uniform(0, 6)}; });
  const Recording r(t);
  const Overlaps o = overlaps(r, {0.25}, 2);
  for (std::size_t k = 0; k < r.frame_count(); ++k) {
    const std::vector<Vec2> at = r.places(k);
    int pairs = 0;
    double worst = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j) {
        const double depth = 0.5 - length(at[i] - at[j]);
        if (depth > 1e-6) ++pairs, worst = std::max(worst, depth);
      }
    CHECK(o.rows[k].pairs == pairs);
    CHECK(o.rows[k].worst == worst);
  }
}
