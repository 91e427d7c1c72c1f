#include "crowd/agents.h"

namespace inhabit::crowd {

void Agents::permute(std::span<const std::uint32_t> order) {
  INHABIT_ASSERT(order.size() == size());
  for_each_array([&](auto& array) {
    auto moved = array;
    for (std::size_t k = 0; k < order.size(); ++k) moved[k] = array[order[k]];
    array.swap(moved);
  });
}

void Agents::remove(std::span<const std::uint8_t> flags) {
  INHABIT_ASSERT(flags.size() == size());
  for_each_array([&](auto& array) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < flags.size(); ++k)
      if (!flags[k]) array[kept++] = array[k];
    array.resize(kept);
  });
}

void Agents::take_out(std::span<const std::uint32_t> indices) {
  for_each_array([&](auto& array) {
    for (std::size_t k = indices.size(); k-- > 0;) {
      INHABIT_ASSERT(indices[k] < array.size());
      array[indices[k]] = array.back();
      array.pop_back();
    }
  });
}

}  // namespace inhabit::crowd
