#pragma once
#include "annealing/terms/intrusion.h"

namespace inhabit::annealing {

/// C_a: others stay out of the accessible space before each face that must be reached, and out of what a door needs
/// [Yu11 eq. 4].
struct AccessibilityCost {
  static constexpr std::string_view kName = "accessibility";
  static double weight(const Weights& w) { return w.learned.accessibility; }
  static double of_space(const Arrangement& x, std::uint32_t i, std::uint32_t s) {
    return x.furniture().spaces[s].kind == Space::Kind::access ? intrusion(x, i, s) : 0;
  }
};

}  // namespace inhabit::annealing
