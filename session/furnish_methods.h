#pragma once
#include "session/jobs.h"

/// The ways of furnishing one room, behind furnish_job.
namespace inhabit::session {

/// What came of one room: suggestions, best first, and how they were found.
struct Found {
  std::vector<Suggestion> list;
  std::vector<layout::TraceRow> trace;
  std::vector<annealing::TraceRow> anneal_trace;
  std::vector<std::string> notes;
  bool cancelled = false;
};

/// By position-based projection; with priors, from the constraints that they become.
Result<Found> furnish_by_projection(const Scene& scene, const FurnishJob& job);
/// By simulated annealing, and for Method::both settled by projection. Requires: priors.
Result<Found> furnish_by_annealing(const Scene& scene, const FurnishJob& job);

/// How many things are wrong that should not be: intersecting or outside, doors blocked, what must be reached and
/// cannot be, views covered. An object must be reached when it wants free space (its clearance) and stands on the
/// floor.
struct Faults {
  std::size_t bodies = 0, doors = 0, unreachable = 0, views = 0, spaces = 0;
  bool none() const { return bodies + doors + unreachable + views == 0; }
  friend auto operator<=>(const Faults&, const Faults&) = default;
};
Faults faults_of(const Scene& scene, const layout::CheckReport& report);

}  // namespace inhabit::session
