#pragma once
#include "crowd/grid.h"
#include "crowd/models/pbd_lists.h"

/// The position-based model without vectors: one agent, one neighbour after the other, in the words of the thesis. The
/// tests hold the fast loops (crowd/models/pbd_kernels.h, pbd_lists.h) to the same bits.
namespace inhabit::crowd::pbd_model::plainly {

void find_neighbours(Work& work, const Reach& reach, std::size_t chunk);
void heed(Work& work, const Constants& constants, std::size_t chunk);
void cohere(const Work& work, const Constants& constants, std::size_t chunk, float* out_vx, float* out_vy);
void foresee(const Work& work, const Constants& constants, std::size_t chunk, float* out_vx, float* out_vy);
void stabilise(const Work& work, const Constants& constants, std::size_t chunk, float* out_x, float* out_y);
void predict(Work& work, const Constants& constants, std::size_t chunk);
void project(const Work& work, const Constants& constants, std::size_t chunk, float* out_x, float* out_y);
void finish(Work& work, const Constants& constants, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model::plainly
