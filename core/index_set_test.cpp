#include "core/index_set.h"

#include <doctest/doctest.h>

#include <set>

#include "core/rng.h"

using namespace inhabit::core;

TEST_CASE("an index set holds what a set holds and in the same order") {
  Rng rng(3);
  for (const std::size_t n : {1, 63, 64, 65, 1000}) {
    IndexSet bits(n, false);
    std::set<std::uint32_t> reference;
    for (int i = 0; i < 500; ++i) {
      const std::uint32_t k = rng.index(static_cast<std::uint32_t>(n));
      if (rng.uniform() < 0.6) {
        bits.insert(k), reference.insert(k);
      } else {
        bits.erase(k), reference.erase(k);
      }
      CHECK(bits.contains(k) == reference.contains(k));
    }
    std::vector<std::uint32_t> met;
    bits.for_each([&](std::uint32_t k) { met.push_back(k); });
    CHECK(met == std::vector<std::uint32_t>(reference.begin(), reference.end()));
  }
}

TEST_CASE("a full index set ends where its numbers do") {
  for (const std::size_t n : {0, 1, 63, 64, 65, 128}) {
    std::size_t met = 0;
    IndexSet(n, true).for_each([&](std::uint32_t k) { met += k < n ? 1 : 1000; });
    CHECK(met == n);
  }
}

TEST_CASE("a walk over an index set meets what is inserted behind it and leaves the rest") {
  IndexSet bits(200, false);
  for (const std::uint32_t k : {5, 63, 130}) bits.insert(k);
  std::vector<std::uint32_t> met;
  bits.for_each([&](std::uint32_t k) {
    met.push_back(k);
    bits.erase(k);
    if (k == 63) bits.insert(4), bits.insert(63), bits.insert(64), bits.insert(199);
  });
  CHECK(met == std::vector<std::uint32_t>{5, 63, 64, 130, 199});
  CHECK((bits.contains(4) && bits.contains(63) && !bits.contains(64)));
}
