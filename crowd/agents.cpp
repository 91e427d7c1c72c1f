#include "crowd/agents.h"

#include <functional>

#include "core/parallel.h"

namespace inhabit::crowd {

void Agents::permute(std::span<const std::uint32_t> order, int threads) {
  INHABIT_ASSERT(order.size() == size());
  std::vector<std::function<void()>> arrays;  // each array is one thread's work
  for_each_array([&](auto& array) {
    arrays.emplace_back([&array, order] {
      std::remove_reference_t<decltype(array)> moved(order.size());
      for (std::size_t k = 0; k < order.size(); ++k) moved[k] = array[order[k]];
      array.swap(moved);
    });
  });
  core::parallel_for(arrays.size(), order.size() < 4096 ? 1 : threads, [&](std::size_t k) { arrays[k](); });
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
