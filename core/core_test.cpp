#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/angle.h"
#include "core/parallel.h"
#include "core/rng.h"
#include "core/text.h"

using namespace inhabit::core;

TEST_CASE("sin_cos stays within 2.3e-16 of the C library's long double answer") {
  Rng rng(7);
  for (int i = 0; i < 200000; ++i) {
    const double a = rng.uniform(-kPi, kPi) * (i % 2 ? 1 : 1e-6);
    const SinCos r = sin_cos(a);
    CHECK(std::abs(r.sin - static_cast<double>(sinl(a))) < 2.3e-16);
    CHECK(std::abs(r.cos - static_cast<double>(cosl(a))) < 2.3e-16);
  }
}

TEST_CASE("direction_angle inverts sin_cos and gives 0 for no direction") {
  Rng rng(8);
  for (int i = 0; i < 100000; ++i) {
    const double a = rng.uniform(-kPi, kPi), r = std::pow(10, rng.uniform(-8, 8));
    CHECK(std::abs(direction_angle(r * std::cos(a), r * std::sin(a)) - a) < 1.5e-15);
  }
  CHECK(direction_angle(0, 0) == 0);
  CHECK(direction_angle(-1, 0) == kPi);
}

TEST_CASE("wrap_angle gives the same direction between -pi and pi") {
  Rng rng(9);
  for (int i = 0; i < 100000; ++i) {
    const double a = rng.uniform(-100, 100), w = wrap_angle(a);
    CHECK(w > -kPi);
    CHECK(w <= kPi);
    CHECK(std::abs(std::sin((w - a) / 2)) < 1e-13);
  }
}

TEST_CASE("random numbers depend on seed and stream alone and fill the interval") {
  Rng a(1, 2), b(1, 2), c(1, 3);
  CHECK(a.next() == b.next());
  CHECK(a.next() != c.next());
  double sum = 0, squares = 0;
  constexpr int kCount = 1000000;
  for (int i = 0; i < kCount; ++i) {
    const double u = a.uniform();
    sum += u, squares += u * u;
  }
  // Five standard deviations of the mean (0.289 / sqrt(n)) and of the second moment (0.298 / sqrt(n)).
  CHECK(std::abs(sum / kCount - 0.5) < 5 * 0.289 / std::sqrt(kCount));
  CHECK(std::abs(squares / kCount - 1.0 / 3) < 5 * 0.298 / std::sqrt(kCount));
}

TEST_CASE("parallel_for visits every index once at any number of threads") {
  for (const int threads : {1, 2, 8}) {
    std::vector<int> visits(1000);
    parallel_for(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    CHECK(std::ranges::all_of(visits, [](int v) { return v == 1; }));
  }
}

TEST_CASE("a misspelt name finds its neighbour, a foreign one finds nothing") {
  const std::array<std::string_view, 3> names = {"distance", "heat_point", "region"};
  CHECK(nearest_name("distence", names) == "distance");
  CHECK(did_you_mean("heatpoint", names) == "; did you mean \"heat_point\"?");
  CHECK(did_you_mean("xyzzy", names).empty());
}

TEST_CASE("UTF-8 is told from noise") {
  CHECK(is_utf8("Küche"));
  CHECK_FALSE(
      is_utf8("K\xfc"
              "che"));
  CHECK_FALSE(is_utf8("\xed\xa0\x80"));
  CHECK_FALSE(is_utf8("\xc3"));
}

TEST_CASE("parallel loops call every index once whatever the number of threads and however short they are") {
  for (const int threads : {0, 1, 2, 8})
    for (int round = 0; round < 2000; ++round) {
      const std::size_t count = static_cast<std::size_t>(round % 23);
      std::vector<int> calls(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++calls[i]; });
      REQUIRE(std::ranges::count(calls, 1) == static_cast<std::ptrdiff_t>(count));
    }
}

TEST_CASE("parallel loops within others and beside others are done and an exception comes out") {
  std::atomic<int> sum = 0;
  const auto both = [&] {
    for (int round = 0; round < 200; ++round)
      parallel_for(4, 4, [&](std::size_t) { parallel_for(5, 2, [&](std::size_t i) { sum += static_cast<int>(i); }); });
  };
  std::thread other(both);
  both();
  other.join();
  CHECK(sum == 2 * 200 * 4 * 10);
  CHECK_THROWS_AS(parallel_for(100, 2,
                               [](std::size_t i) {
                                 if (i == 40) throw std::runtime_error("forty");
                               }),
                  std::runtime_error);
  parallel_for(10, 2, [&](std::size_t) { ++sum; });
  CHECK(sum == 2 * 200 * 4 * 10 + 10);
}
