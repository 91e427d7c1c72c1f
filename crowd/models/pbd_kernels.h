#pragma once
#include <cmath>

#include "crowd/models/pbd_work.h"

/// The inner loops of the position-based model, each over one chunk: they read the state of everybody and write that of
/// their own agents, so chunks may be handled in any order. Written for every instruction set at once (Highway) without
/// fused operations: each gives the same bits as the readable version of crowd/models/pbd_reference.h.
namespace inhabit::crowd::pbd_model {

/// Closer than its root is the same place, square metres.
constexpr float kCoincident = 1e-12f;
/// Share of the near ones from which on contacts are added row by row.
constexpr float kCrowded = 0.45f;
/// The thesis's factor on averaged corrections, for collisions to come.
constexpr float kFarRelaxation = 1.2f;
/// Two who want to walk against each other touch up to this share of the square of their distance.
constexpr float kTouching = 2e-3f;
/// People are no billiard balls: what pushing somebody away gives him as a velocity (over-relaxed, it throws) falls off
/// by e in this time, seconds: 6 % in a sub-step of 1/384 s. Without that nobody in a jam stands still and hardly any
/// arch holds; so it has the arches of the thesis's own scheme (docs/results.md) and overlaps half as deep.
constexpr double kReboundTime = 0.042;
/// The share that is left after a sub-step of so many seconds.
inline float rebound(float part) { return static_cast<float>(std::exp(-part / kReboundTime)); }

/// next = velocities, moved a share of the way towards the neighbours' mean, weighted by the poly6 kernel. [thesis eq.
/// 4.3 with the sign of XSPH, normalised so that a crowd cannot overshoot]
void cohere(Work& work, const Constants& constants, std::size_t chunk);
/// corrected = the velocities that people would take up if they were alone. [eq. 4.1]
void intend(Work& work, const Constants& constants, std::size_t chunk);
/// Velocities, changed for collisions to come of what `intend` has left. [thesis 4.2.4, 4.2.5]
void foresee(Work& work, const Constants& constants, std::size_t chunk);

/// Finds who may touch somebody before the step is over: fills `near` and `busy`. What follows does nothing else for
/// the others but let them glide; the result is the same to rounding.
void narrow(Work& work, const Constants& constants, std::size_t chunk);
/// The whole step of everybody who is not busy: no contacts, so v only turns into the wish.
void glide(Work& work, const Constants& constants, std::size_t chunk);

// Of the busy alone:
/// Pushes apart what overlaps at the start of a step: corrected = at + corrections. [thesis algorithm 2, line 9 to 15]
void stabilise(Work& work, const Constants& constants, std::size_t chunk);
/// at = corrected; the chunk's `thrown`: how far that has moved somebody.
void settle(Work& work, const Constants& constants, std::size_t chunk);
/// predicted = at + part * ((1 - blend) v + blend * wish). [eq. 4.1]
void predict(Work& work, const Constants& constants, std::size_t chunk);
/// One Jacobi iteration of contacts with friction: corrected = predicted + averaged corrections. [eq. 4.2]
void project(Work& work, const Constants& constants, std::size_t chunk);
/// Velocities from corrected positions, clamped; next = at + part * v; then corrected = what is predicted for the
/// sub-step after this one: what others still read is left alone.
void finish(Work& work, const Constants& constants, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model
