#pragma once
#include "annealing/terms/intrusion.h"

namespace inhabit::annealing {

/// C_v: others stay out of the rectangles that a view is made of [Yu11 eq. 5].
struct VisibilityCost {
  static constexpr std::string_view kName = "visibility";
  static double weight(const Weights& w) { return w.learned.visibility; }
  static double of_space(const Arrangement& x, std::uint32_t i, std::uint32_t s) {
    return x.furniture().spaces[s].kind == Space::Kind::view ? intrusion(x, i, s) : 0;
  }
};

}  // namespace inhabit::annealing
