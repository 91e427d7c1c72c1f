#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace inhabit::core {

/// A list of Ts for each of n owners, in two arrays instead of n vectors.
template <class T>
class Lists {
 public:
  Lists() = default;
  /// From (owner, item) pairs in any order; the items of one owner keep theirs. Requires: every owner < owners.
  Lists(std::size_t owners, const std::vector<std::pair<std::uint32_t, T>>& pairs)
      : first_(owners + 1), items_(pairs.size()) {
    for (const auto& [owner, item] : pairs) ++first_[owner + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - (first_.empty() ? 0 : 1));
    for (const auto& [owner, item] : pairs) items_[next[owner]++] = item;
  }
  std::span<const T> operator[](std::size_t owner) const {
    return {items_.data() + first_[owner], items_.data() + first_[owner + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<T> items_;
};

}  // namespace inhabit::core
