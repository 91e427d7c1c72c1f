#pragma once
#include <cstdint>

namespace inhabit::core {

/// A bijective mix of 64 bits (the finaliser of SplitMix64, Steele et al. 2014).
constexpr std::uint64_t mix64(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Counter-based random numbers: the n-th number of (seed, stream) is a pure function of the three, so results depend
/// neither on threads nor on the standard library. Copies are cheap and continue on their own.
class Rng {
 public:
  explicit Rng(std::uint64_t seed, std::uint64_t stream = 0)
      : key_(mix64(seed + 0x9e3779b97f4a7c15ULL * (mix64(stream + 0x632be59bd9b4e019ULL) | 1))) {}

  std::uint64_t next() { return mix64(key_ + 0x9e3779b97f4a7c15ULL * ++counter_); }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 … n-1. Requires: n > 0. Bias below n / 2^32.
  std::uint32_t index(std::uint32_t n) { return static_cast<std::uint32_t>(((next() >> 32) * n) >> 32); }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace inhabit::core
