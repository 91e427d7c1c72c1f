#pragma once
#include "layout/problem.h"

/// The two halves of compile(): particles first, then what is asked of them.
namespace inhabit::layout {

/// No particle, no group.
constexpr std::uint32_t kNone = 0xffffffffu;

/// Heights of all bases, particles and their boxes, which particle each object and each rigid group is.
/// Errors: stacks that contain themselves, a rigid group whose members' positions or angles are missing.
Status build_bodies(const Scene& scene, Problem& problem);

/// The document's constraints, and those that every scene has (clearances, what stands on something, curves, doors), as
/// terms and zones. Requires: build_bodies.
void expand_constraints(const Scene& scene, Problem& problem, Origins* origins);

}  // namespace inhabit::layout
