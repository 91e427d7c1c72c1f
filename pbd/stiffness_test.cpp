#include "pbd/stiffness.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace inhabit::pbd;

namespace {

constexpr double kStep = 0x1p-31;  ///< half of what the result is rounded to

}  // namespace

TEST_CASE("stiffness: the decreasing schedule is TVCG's formula") {
  // 1 - (1 - k0)^(M / l)
  CHECK(std::abs(stiffness(Schedule::decreasing, 0.75, 1, 1) - 0.75) <= kStep);
  CHECK(std::abs(stiffness(Schedule::decreasing, 0.75, 1, 2) - 0.5) <= kStep);
  CHECK(std::abs(stiffness(Schedule::decreasing, 0.75, 2, 1) - 0.9375) <= kStep);
  CHECK(std::abs(stiffness(Schedule::decreasing, 0.75, 2, 4) - 0.5) <= kStep);
}

TEST_CASE("stiffness: the increasing one mirrors it and the constant one stays") {
  CHECK(std::abs(stiffness(Schedule::increasing, 0.75, 1, 1) - 0.75) <= kStep);
  CHECK(std::abs(stiffness(Schedule::increasing, 0.75, 2, 1) - 0.5) <= kStep);
  CHECK(std::abs(stiffness(Schedule::increasing, 0.75, 1, 2) - 0.9375) <= kStep);
  for (const int l : {1, 2, 10, 1000000}) CHECK(stiffness(Schedule::constant, 0.25, 3, l) == 0.25);
}

TEST_CASE("stiffness: they fall to nothing and rise to one") {
  CHECK(stiffness(Schedule::decreasing, 0.8, 10, 1000000) < 2e-5);
  CHECK(stiffness(Schedule::increasing, 0.1, 1, 1000) == 1);
}

TEST_CASE("stiffness: nought and one stay what they are") {
  for (const Schedule s : {Schedule::decreasing, Schedule::constant, Schedule::increasing}) {
    for (const int l : {1, 7, 100000}) {
      CHECK(stiffness(s, 0, 10, l) == 0);
      CHECK(stiffness(s, 1, 10, l) == 1);
    }
  }
}

TEST_CASE("stiffness: monotone in the iteration and in k0 and never outside nought and one") {
  for (const double rate : {1.0, 2.5, 10.0}) {
    for (double k0 = 0; k0 <= 1; k0 += 0.0625) {
      for (int l = 1; l < 300; ++l) {
        const double down = stiffness(Schedule::decreasing, k0, rate, l),
                     up = stiffness(Schedule::increasing, k0, rate, l);
        CHECK((down >= 0 && down <= 1 && up >= 0 && up <= 1));
        CHECK(stiffness(Schedule::decreasing, k0, rate, l + 1) <= down);
        CHECK(stiffness(Schedule::increasing, k0, rate, l + 1) >= up);
        if (k0 < 1) CHECK(stiffness(Schedule::decreasing, k0 + 0.0625, rate, l) >= down);
      }
    }
  }
}

TEST_CASE("stiffness: results are multiples of a power of two so that the C library's last bit cannot show") {
  for (int l = 1; l < 1000; ++l) {
    const double k = stiffness(Schedule::decreasing, 0.8, 10, l) * 0x1p30;
    CHECK(k == std::floor(k));
  }
}

TEST_CASE("stiffness: nobody moves when everybody is pinned") {
  CHECK(share(0, 0) == 0);
  CHECK(share(1, 4) == 0.25);
}
