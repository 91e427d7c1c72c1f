#pragma once
#include "annealing/moves/carrier.h"
#include "annealing/moves/path_point.h"
#include "annealing/moves/rotate.h"
#include "annealing/moves/slide.h"
#include "annealing/moves/swap.h"
#include "annealing/moves/to_prior.h"
#include "annealing/moves/translate.h"
#include "core/type_list.h"

namespace inhabit::annealing {

/// Every kind of move. This line is the only registration there is. A move has a name, its share of all moves, whether
/// the furniture has anything for it, and make(x, scale, rng, before), which touches what it will change, calls
/// before(), changes it and returns true; or does nothing and returns false.
using Moves = TypeList<Translate, Rotate, Swap, PathPoint, ChangeCarrier, Slide, ToPrior>;

}  // namespace inhabit::annealing
