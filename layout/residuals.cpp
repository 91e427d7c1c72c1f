#include <algorithm>

#include "layout/check.h"
#include "layout/contacts.h"

namespace inhabit::layout {

Residuals residuals(const Scene& scene) {
  Residuals out;
  Origins origins;
  const Result<Problem> compiled = compile(scene, &origins);
  if (!compiled) return out;
  const Problem& p = *compiled;
  if (!std::ranges::all_of(p.has_start, [](bool b) { return b; })) return out;
  State x(p.data, p.room);
  for (std::uint32_t b = 0; b < p.data.bodies.size(); ++b) x.place(b, p.start[b].p, p.start[b].angle);
  double squares = 0;
  p.for_each_term([&]<class T>(const T& term, TermId id) {
    const Origin& origin = origins[id.type()][id.index()];
    if constexpr (std::is_same_v<T, CurveTerm>) {
      for_each_residual(term, x, [&](std::string_view type, double e, std::uint32_t i, std::uint32_t j) {
        const auto& members = scene.groups[term.group].members;
        out.list.push_back(
            {type, false, e, i == j ? std::vector{members[i], origin.a} : std::vector{members[i], members[j]}});
        squares += p.gamma(term) * e * e;
      });
    } else {
      const double e = error(term, x);
      squares += p.gamma(term) * e * e;
      std::vector<Ref> between = {origin.a};
      if (!origin.b.none()) between.push_back(origin.b);
      out.list.push_back({origin.type, T::kTraits.angular, e, std::move(between)});
    }
  });
  Contacts contacts(p);
  contacts.refresh(x);
  Score s;
  contacts.score_collisions(x, s, squares);
  contacts.score_zones(x, s, squares);
  p.for_each_movable_box([&](std::uint32_t i, std::uint32_t) {  // what is pinned is taken as given
    double deepest = 0;
    p.room.for_each_violation(x.boxes[i], [&](Vec2, double depth) { deepest = std::max(deepest, depth); });
    squares += p.boundary_gamma * deepest * deepest;
  });
  out.energy = std::sqrt(squares);
  return out;
}

}  // namespace inhabit::layout
