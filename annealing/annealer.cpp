#include "annealing/annealer.h"

namespace inhabit::annealing {

Cooling::Cooling(const Schedule& s) {
  constexpr double kCount = kStages;
  // (cold / hot)^(1 / 1024): ten square roots. The last stage is a ratio short of `cold`.
  double ratio = s.hot > 0 ? s.cold / s.hot : 1;
  for (std::size_t k = kStages; k > 1; k /= 2) ratio = std::sqrt(ratio);
  double t = s.hot;
  for (std::size_t k = 0; k < kStages; ++k) {
    stage_[k] =
        s.shape == Schedule::Shape::geometric ? t : s.hot + (s.cold - s.hot) * (static_cast<double>(k) / kCount);
    t *= ratio;
  }
}

}  // namespace inhabit::annealing
