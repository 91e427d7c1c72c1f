#pragma once
#include "crowd/models/pbd_work.h"

/// The inner loops of the position-based model, each over one chunk: they read the state of everybody and write that of
/// their own agents, so chunks may be handled in any order. Written for every instruction set at once (Highway) without
/// fused operations: each gives the same bits as the readable version of crowd/models/pbd_reference.h.
namespace inhabit::crowd::pbd_model {

/// Collisions to come, headway and cohesion: changes `corrected` (used as scratch for velocities) from `v`.
/// [thesis 4.2.3 to 4.2.5]
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
