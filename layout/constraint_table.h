#pragma once
#include "core/type_list.h"
#include "layout/constraints/align.h"
#include "layout/constraints/center_of_mass.h"
#include "layout/constraints/curve.h"
#include "layout/constraints/distance.h"
#include "layout/constraints/orientation.h"
#include "layout/constraints/region.h"
#include "layout/constraints/stacking.h"
#include "layout/constraints/traffic_lane.h"
#include "layout/constraints/wall.h"
#include "layout/constraints/zone.h"

namespace inhabit::layout {

/// Every term type, in the order in which a pass projects them. This line is the only registration there is. Zones and
/// collisions, whose pairs change as objects move, are found by Contacts.
using TermTypes = TypeList<DistanceTerm, TrafficLaneTerm, CenterTerm, AlignTerm, CurveTerm, RegionTerm, StackingTerm,
                           WallDistanceTerm, WallOrientationTerm, OrientationTerm>;

struct NullSink {
  void shift(const Anchor&, Vec2) {}
  void turn(const Anchor&, double) {}
};

/// What layout/constraint.h asks of a term type, so that a forgotten function is named by the compiler.
template <class T>
concept ConstraintTerm = std::derived_from<T, Term> && requires(const T& c, const State& x, NullSink& sink) {
  { T::kTraits } -> std::convertible_to<TermTraits>;
  { error(c, x) } -> std::convertible_to<double>;
  project(c, x, 1.0, sink);
  anchors(c, [](const Anchor&) {});
};

template <class... T>
constexpr bool all_terms(TypeList<T...>) {
  return (ConstraintTerm<T> && ...);
}
static_assert(all_terms(TermTypes{}));

}  // namespace inhabit::layout
