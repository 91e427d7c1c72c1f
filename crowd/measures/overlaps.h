#pragma once
#include "crowd/measures/recording.h"

namespace inhabit::crowd {

/// How large people are, metres. Recordings do not say; simulations do.
struct Radii {
  double everybody = 0.2;
  std::vector<float> of_fix;  ///< one per fix, instead of `everybody`; may be empty
  double operator()(std::size_t fix) const { return of_fix.empty() ? everybody : of_fix[fix]; }
  double largest() const;
};

/// Two discs overlap by r_i + r_j - |x_i - x_j| when that is more than `tolerance`.
struct Overlaps {
  struct Row {
    double seconds = 0;
    int pairs = 0;
    double worst = 0;  ///< deepest overlap, metres
  };
  std::vector<Row> rows;               ///< one per frame
  std::size_t pairs = 0;               ///< over all frames
  double worst = 0;                    ///< metres
  double worst_share = 0;              ///< the largest overlap as a share of r_i + r_j of its pair
  double worst_seconds = 0;            ///< when `worst` was
  std::int32_t first = 0, second = 0;  ///< who it was
};
/// `tolerance`: 1 µm, what a micrometre in the file can make of touching discs.
Overlaps overlaps(const Recording& recording, const Radii& radii, int threads = 0, double tolerance = 1e-6);

}  // namespace inhabit::crowd
