#pragma once
#include <filesystem>

#include "session/measure_job.h"

/// Our measures of real recordings beside what others published for these experiments.
namespace inhabit::session {

/// One fundamental diagram measured by us and published by others.
struct CurveAgreement {
  std::string experiment, against;
  bool same_run = false;  ///< theirs is of the very recording; else of others in the same series
  std::vector<crowd::FundamentalPoint> ours, theirs;
  crowd::CurveComparison speed;  ///< median speeds by density, slices of 0.25 with at least 5 points each
  crowd::FundamentalPoint our_median, their_median;  ///< medians of density and of speed
};

/// One bottleneck's flow and the flows published for bottlenecks of its width.
struct FlowAgreement {
  std::string experiment;
  double width = 0;          ///< metres
  double flow = 0;           ///< people per second: (N - 1) over the time between the first and the last of them
  double low = 0, high = 0;  ///< published at that width
  int published = 0;         ///< how many
};

/// From the folder that holds `pedestrians/`. Density and speed are Voronoi's in areas 2 m deep over the steady part of
/// each run, as theirs are (crowd/measures/crossings.h, steady_span). Errors: a file that is missing.
Result<std::vector<CurveAgreement>> curve_agreements(const std::filesystem::path& data);
Result<std::vector<FlowAgreement>> flow_agreements(const std::filesystem::path& data);

}  // namespace inhabit::session
