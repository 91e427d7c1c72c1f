#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace inhabit::core {

/// A set of the numbers 0 … n - 1, a bit each.
class IndexSet {
 public:
  IndexSet() = default;
  /// None of n, or all of them.
  IndexSet(std::size_t n, bool all) : words_((n + 63) / 64, all ? ~std::uint64_t{0} : 0) {
    if (all && n % 64 != 0) words_.back() >>= 64 - n % 64;
  }
  /// Makes place for the numbers up to n - 1.
  void grow(std::size_t n) { words_.resize((n + 63) / 64); }
  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void erase(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }

  /// Calls f(i) for every member, in order. What f inserts behind i is met as well; what it inserts at i or before is
  /// left in the set.
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      // Read anew after each call: f may have changed the word.
      for (std::uint64_t from = ~std::uint64_t{0}; (words_[w] & from) != 0;) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(words_[w] & from));
        from = bit == 63 ? 0 : ~std::uint64_t{0} << (bit + 1);
        f(static_cast<std::uint32_t>(64 * w + bit));
      }
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace inhabit::core
