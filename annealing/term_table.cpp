#include "annealing/term_table.h"

namespace inhabit::annealing {
namespace {

void add_space(const Arrangement& x, std::uint32_t i, std::uint32_t s, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasSpace<T>) cost += T::of_space(x, i, s);
  });
}
void add_items(const Arrangement& x, std::uint32_t i, std::uint32_t j, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasItems<T>) cost += T::of_items(x, i, j);
  });
}
void add_relation(const Arrangement& x, std::uint32_t r, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasRelation<T>) cost += T::of_relation(x, r);
  });
}
void add_circle(const Arrangement& x, std::uint32_t k, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasCircle<T>) cost += T::of_circle(x, k);
  });
}
void add_alone(const Arrangement& x, std::uint32_t i, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasItem<T>) cost += T::of_item(x, i);
  });
}
void add_path(const Arrangement& x, std::uint32_t p, Costs& costs) {
  for_each_term(costs, [&]<class T>(std::type_identity<T>, double& cost) {
    if constexpr (HasPath<T>) cost += T::of_path(x, p);
  });
}

void add_shared(const Arrangement& x, Costs& costs) {
  const Furniture& f = x.furniture();
  for (std::uint32_t r = 0; r < f.relations.size(); ++r) add_relation(x, r, costs);
  for (std::uint32_t k = 0; k < f.circles.size(); ++k) add_circle(x, k, costs);
  for (std::uint32_t p = 0; p < f.paths.size(); ++p) add_path(x, p, costs);
}

}  // namespace

double weighted(const Costs& costs, const Weights& weights) {
  double sum = 0;
  std::size_t k = 0;
  for_each_type(Terms{}, [&]<class T>(std::type_identity<T>) { sum += T::weight(weights) * costs[k++]; });
  return sum;
}

Costs full_cost(const Arrangement& x) {
  const Furniture& f = x.furniture();
  Costs costs{};
  const auto n = static_cast<std::uint32_t>(f.items.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    add_alone(x, i, costs);
    for (std::uint32_t j = i + 1; j < n; ++j) add_items(x, i, j, costs);
    for (std::uint32_t s = 0; s < f.spaces.size(); ++s) add_space(x, i, s, costs);
  }
  add_shared(x, costs);
  return costs;
}

Costs grid_cost(const Arrangement& x) {
  const Furniture& f = x.furniture();
  Costs costs{};
  for (std::uint32_t i = 0; i < f.items.size(); ++i) {
    add_alone(x, i, costs);
    x.for_bodies_near(x.body(i).box, [&](std::uint32_t j) {
      if (i < j) add_items(x, i, j, costs);
    });
    x.for_spaces_near(x.body(i).box, [&](std::uint32_t s) { add_space(x, i, s, costs); });
  }
  add_shared(x, costs);
  return costs;
}

LocalCost::LocalCost(const Furniture& f) : relations_(f.relations.size()), circles_(f.circles.size()) {}

void LocalCost::add_item(const Arrangement& x, std::uint32_t i, Costs& costs) {
  const Furniture& f = x.furniture();
  add_alone(x, i, costs);
  for (const std::uint32_t r : f.relations_of[i])
    if (relations_.insert(r)) add_relation(x, r, costs);
  for (const std::uint32_t k : f.circles_of[i])
    if (circles_.insert(k)) add_circle(x, k, costs);
  const Box& box = x.body(i).box;
  x.for_bodies_near(box, [&](std::uint32_t j) { add_items(x, i, j, costs); });
  x.for_spaces_near(box, [&](std::uint32_t s) { add_space(x, i, s, costs); });
  for (const std::uint32_t s : f.spaces_of[i])
    x.for_bodies_near(x.space(s).box, [&](std::uint32_t j) { add_space(x, j, s, costs); });
}

/// Between the members of two families that change places; within one nothing changes.
void LocalCost::add_families(const Arrangement& x, Costs& costs) const {
  const auto items = x.touched_items();
  for (std::size_t a = 0; a < x.first_family(); ++a) {
    for (std::size_t b = x.first_family(); b < items.size(); ++b) {
      add_items(x, items[a], items[b], costs);
      for (const std::uint32_t s : x.furniture().spaces_of[items[a]]) add_space(x, items[b], s, costs);
      for (const std::uint32_t s : x.furniture().spaces_of[items[b]]) add_space(x, items[a], s, costs);
    }
  }
}

Costs LocalCost::operator()(const Arrangement& x) {
  Costs costs{};
  relations_.clear(), circles_.clear();
  for (const std::uint32_t i : x.touched_items()) add_item(x, i, costs);
  add_families(x, costs);
  if (x.touched_path() == kNobody) return costs;
  const std::uint32_t first = x.furniture().paths[x.touched_path()].first_space;
  for (std::uint32_t s = first; s < first + kPathParts; ++s)
    x.for_bodies_near(x.space(s).box, [&](std::uint32_t j) { add_space(x, j, s, costs); });
  add_path(x, x.touched_path(), costs);
  return costs;
}

std::array<std::string_view, Terms::size> term_names() {
  std::array<std::string_view, Terms::size> names;
  std::size_t k = 0;
  for_each_type(Terms{}, [&]<class T>(std::type_identity<T>) { names[k++] = T::kName; });
  return names;
}

}  // namespace inhabit::annealing
