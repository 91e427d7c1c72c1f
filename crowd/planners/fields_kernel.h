#pragma once
#include <cstddef>
#include <cstdint>

/// The look-up of crowd/planners/fields.h for many agents at once.
namespace inhabit::crowd::fields_kernel {

struct Lookup {
  const std::uint32_t* direction = nullptr;  ///< [field][cell]: x and y as signed 16-bit fractions, x in the low half
  float origin_x = 0, origin_y = 0, inverse_cell = 1;
  float last_column = 0, last_row = 0;  ///< the largest coordinates in cells, a little below the last cell's centre
  std::int32_t columns = 0, cells = 0;
  const std::uint32_t* field = nullptr;  ///< per agent; 0xffffffff: leave its wish alone
  const float *x = nullptr, *y = nullptr, *speed = nullptr;
  float *wish_x = nullptr, *wish_y = nullptr;
};

constexpr float kUnit = 32767;  ///< a direction's 1 in 16 bits
/// Opposite directions of neighbouring cells cancel; below this square the nearest cell alone decides.
constexpr float kCancelled = 0.05f * kUnit * kUnit;

/// For agents begin … end - 1, with as many lanes as the processor has. No fused operations: the same bytes everywhere.
void look_up(const Lookup& lookup, std::size_t begin, std::size_t end);
/// The same, one by one: what the lanes are tested against.
void look_up_scalar(const Lookup& lookup, std::size_t begin, std::size_t end);

}  // namespace inhabit::crowd::fields_kernel
