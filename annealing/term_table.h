#pragma once
#include <array>

#include "annealing/terms/accessibility.h"
#include "annealing/terms/bodies.h"
#include "annealing/terms/pair.h"
#include "annealing/terms/pathway.h"
#include "annealing/terms/visibility.h"
#include "annealing/terms/wall.h"
#include "core/type_list.h"

namespace inhabit::annealing {

/// Every cost term, in the order of Yu et al. eq. 8; the last two are our own. This line is the only registration there
/// is. A term has a name, a weight, and one or more of: of_item(x, item), of_items(x, item, item), of_space(x, item,
/// space), of_relation(x, relation), of_circle(x, circle), of_path(x, path). Each is a sum over all of these.
using Terms = TypeList<AccessibilityCost, VisibilityCost, PathwayCost, PriorDistance, PriorAngle, PairDistance,
                       PairAngle, Overlap, Inside>;

/// What each term comes to, without its weight.
using Costs = std::array<double, Terms::size>;

template <class T>
concept HasItem = requires(const Arrangement& x) {
  T::of_item(x, 0u);
};
template <class T>
concept HasItems = requires(const Arrangement& x) {
  T::of_items(x, 0u, 0u);
};
template <class T>
concept HasSpace = requires(const Arrangement& x) {
  T::of_space(x, 0u, 0u);
};
template <class T>
concept HasRelation = requires(const Arrangement& x) {
  T::of_relation(x, 0u);
};
template <class T>
concept HasCircle = requires(const Arrangement& x) {
  T::of_circle(x, 0u);
};
template <class T>
concept HasPath = requires(const Arrangement& x) {
  T::of_path(x, 0u);
};

template <class... T>
constexpr bool all_cost_something(TypeList<T...>) {
  return ((HasItem<T> || HasItems<T> || HasSpace<T> || HasRelation<T> || HasCircle<T> || HasPath<T>)&&...);
}
static_assert(all_cost_something(Terms{}));

/// Calls f(std::type_identity<Term>{}, cost) for each term.
template <class F>
void for_each_term(Costs& costs, F&& f) {
  std::size_t k = 0;
  for_each_type(Terms{}, [&]<class T>(std::type_identity<T> t) { f(t, costs[k++]); });
}

/// C of Yu et al. eq. 8.
double weighted(const Costs& costs, const Weights& weights);

/// Every term over everything, without a grid: what the increments must add up to.
Costs full_cost(const Arrangement& x);

/// The same by way of the grid.
Costs grid_cost(const Arrangement& x);

/// Every term over what the touched items or the touched pathway take part in.
class LocalCost {
 public:
  explicit LocalCost(const Furniture& furniture);
  Costs operator()(const Arrangement& x);

 private:
  void add_item(const Arrangement& x, std::uint32_t i, Costs& costs);
  void add_families(const Arrangement& x, Costs& costs) const;

  Stamps relations_, circles_;
};

/// Names in order.
std::array<std::string_view, Terms::size> term_names();

}  // namespace inhabit::annealing
