#pragma once
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vector>

namespace inhabit::core {

/// A closed list of kinds. One line in such a list is the only registration there is.
template <class... Ts>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Ts);
  /// One array per kind.
  using Arrays = std::tuple<std::vector<Ts>...>;
};

/// Calls f(std::type_identity<T>{}) for every T of the list, in order.
template <class... Ts, class F>
constexpr void for_each_type(TypeList<Ts...>, F&& f) {
  (f(std::type_identity<Ts>{}), ...);
}

}  // namespace inhabit::core
