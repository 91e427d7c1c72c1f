#pragma once
#include "crowd/grid.h"
#include "crowd/models/pbd_lists.h"

/// The position-based model without vectors: one agent, one neighbour after the other, in the words of the thesis. The
/// tests hold the fast loops (crowd/models/pbd_kernels.h, pbd_lists.h) to the same bits.
namespace inhabit::crowd::pbd_model::plainly {

void find_neighbours(Work& work, const Reach& reach, std::size_t chunk);
void cohere(Work& work, const Constants& constants, std::size_t chunk);
void intend(Work& work, const Constants& constants, std::size_t chunk);
void foresee(Work& work, const Constants& constants, std::size_t chunk);
void narrow(Work& work, const Constants& constants, std::size_t chunk);
void glide(Work& work, const Constants& constants, std::size_t chunk);
void stabilise(Work& work, const Constants& constants, std::size_t chunk);
void settle(Work& work, const Constants& constants, std::size_t chunk);
void predict(Work& work, const Constants& constants, std::size_t chunk);
void project(Work& work, const Constants& constants, std::size_t chunk);
void finish(Work& work, const Constants& constants, std::size_t chunk);

}  // namespace inhabit::crowd::pbd_model::plainly
