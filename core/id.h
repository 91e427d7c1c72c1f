#pragma once
#include <compare>
#include <cstdint>

namespace inhabit::core {

/// The index of a T in its array, as a value of its own type; none by default.
template <class T>
struct Id {
  std::uint32_t index = 0xffffffffu;

  constexpr bool none() const { return index == 0xffffffffu; }
  constexpr auto operator<=>(const Id&) const = default;
};

}  // namespace inhabit::core
