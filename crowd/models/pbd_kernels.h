#pragma once
#include "crowd/models/pbd_work.h"

/// The inner loops of the position-based model, each over one chunk: they read the state of everybody and write that of
/// their own agents, so chunks may be handled in any order. Written for every instruction set at once (Highway) without
/// fused operations: each gives the same bits as the readable version of crowd/models/pbd_reference.h.
namespace inhabit::crowd::pbd_model {

/// Nobody wishes to walk faster than what closes the gap ahead within the headway: the free length of the way that the
/// agent's disc would sweep. Shortens `wish`. Ours; off in the thesis's preset.
void heed(Work& work, const Constants& constants, std::size_t chunk);
/// Velocities, moved a share of the way towards the neighbours' mean, weighted by the poly6 kernel. [thesis eq. 4.3
/// with the sign of XSPH, normalised so that a crowd cannot overshoot]
void cohere(const Work& work, const Constants& constants, std::size_t chunk, float* out_vx, float* out_vy);
/// Velocities, changed for collisions to come. [thesis 4.2.4, 4.2.5]
void foresee(const Work& work, const Constants& constants, std::size_t chunk, float* out_vx, float* out_vy);
/// Pushes apart what overlaps at the start of a step: next = x + corrections. [thesis algorithm 2, line 9 to 15]
void stabilise(const Work& work, const Constants& constants, std::size_t chunk, float* out_x, float* out_y);
/// predicted = x + part * ((1 - blend) v + blend * wish). [eq. 4.1]
void predict(Work& work, const Constants& constants, std::size_t chunk);
/// One Jacobi iteration of contacts with friction: corrected = predicted + averaged corrections. [eq. 4.2]
void project(const Work& work, const Constants& constants, std::size_t chunk, float* out_x, float* out_y);
/// Velocities from corrected positions, clamped; next = x + part * v; predicted for the sub-step after this one.
void finish(Work& work, const Constants& constants, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model
