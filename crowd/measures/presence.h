#pragma once

#include "crowd/measures/area_density.h"

namespace inhabit::crowd {

/// How many people are there, and when the last one has gone.
struct Presence {
  struct Row {
    double seconds = 0;
    int people = 0;
  };
  std::vector<Row> rows;  ///< N(t), one per frame of the recording
  int most = 0;
  int people = 0;     ///< different people in all
  int remaining = 0;  ///< people in the last frame
  /// Evacuation time, seconds: from the first frame until the last moment that somebody is there, or in the area. When
  /// the recording ends with people in it (`remaining`), it says only how long the recording is.
  double evacuation = 0;
};
/// Everywhere, or in an area (its border included).
Presence presence(const Recording& recording, const MeasureArea* area = nullptr);

}  // namespace inhabit::crowd
