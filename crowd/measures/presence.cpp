#include "crowd/measures/presence.h"

#include <algorithm>

namespace inhabit::crowd {

Presence presence(const Recording& recording, const MeasureArea* area) {
  Presence result;
  const auto there = [&](std::size_t i) { return area == nullptr || area->contains(recording.fix(i).at()); };
  for (std::size_t k = 0; k < recording.frame_count(); ++k) {
    Presence::Row row{recording.seconds(recording.frames.frames[k]), 0};
    for (std::size_t i = recording.first(k); i < recording.first(k) + recording.count(k); ++i)
      row.people += there(i) ? 1 : 0;
    if (row.people > 0) result.evacuation = row.seconds - recording.seconds(recording.frames.frames.front());
    result.most = std::max(result.most, row.people);
    result.remaining = row.people;
    result.rows.push_back(row);
  }
  for (std::size_t t = 0; t < recording.tracks.size(); ++t)
    result.people += std::ranges::any_of(recording.tracks[t], there) ? 1 : 0;
  return result;
}

}  // namespace inhabit::crowd
