#pragma once
#include <filesystem>
#include <functional>

#include "crowd/measures/crossings.h"
#include "crowd/measures/fundamental.h"
#include "session/simulate_job.h"

/// People as they walk here beside people as they were recorded: the runs behind `inhabit bench realism`.
namespace inhabit::session {

/// An experiment with a recording, the scene that repeats it, and the line where people are counted. None of them
/// served to choose parameters: those come from Weidmann's curve and the bottlenecks (docs/results.md).
struct RecordedExperiment {
  std::string_view name, scene;
  std::string_view file;  ///< below pedestrians/juelich
  io::TrajectoryOptions reading;
  crowd::MeasureLine line;
};
std::span<const RecordedExperiment> recorded_experiments();

/// A corridor 5 m wide and 115 m long in which people walk at this density, per square metre, as in RiMEA's test 4.
scene::Scene realism_corridor(double density);
/// Mean density and speed at its middle, over 20 s after 15 s; classic, in an area 10 m long.
Result<crowd::FundamentalPoint> corridor_point(double density, const SimulateJob& job);

/// A crowd before a passage 1 m long and so many metres wide, in front of it 3 people per square metre.
scene::Scene realism_bottleneck(double width);
/// People per second through it while the middle three fifths pass; 0 when fewer than nine tenths pass within the time.
Result<double> bottleneck_flow(double width, const SimulateJob& job);
/// Least and most that was published for widths within 0.15 m, per metre of width; of how many.
struct PublishedFlow {
  double low = 0, high = 0;
  int count = 0;
};
Result<std::vector<crowd::FundamentalPoint>> published_flows(const std::filesystem::path& data);
PublishedFlow published_near(std::span<const crowd::FundamentalPoint> flows, double width);

/// The experiment's scene, but everybody is where and when the recording has them first.
scene::Scene entering_as_recorded(scene::Scene scene, const scene::Trajectories& recording);

/// Walks through a scene; the trajectories have 16 frames per second and the scene's floor.
Result<scene::Trajectories> walked(const scene::Scene& scene, double seconds, SimulateJob job);

/// First crossings of a line, seconds, ascending.
std::vector<double> passing_times(const scene::Trajectories& trajectories, const crowd::MeasureLine& line);

/// Voronoi points in a 2 m deep area about the line while the middle three fifths pass [Steffen10].
std::vector<crowd::FundamentalPoint> steady_diagram(const scene::Trajectories& trajectories,
                                                    const crowd::MeasureLine& line);

/// Points of people one behind the other on the lower straight of the oval of Subaih 2019 [Seyfried05].
std::vector<crowd::FundamentalPoint> ring_points(const scene::Trajectories& trajectories, bool simulated);

}  // namespace inhabit::session
