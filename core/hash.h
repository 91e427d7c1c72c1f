#pragma once
#include <bit>
#include <cstdint>
#include <string_view>

#include "core/rng.h"

namespace inhabit::core {

/// An order-dependent 64-bit digest of numbers and text, for golden results: every bit of a double counts.
class Digest {
 public:
  void add(std::uint64_t v) { state_ = mix64(state_ ^ v) + 0x9e3779b97f4a7c15ULL; }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    add(static_cast<std::uint64_t>(text.size()));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3ULL;
};

}  // namespace inhabit::core
