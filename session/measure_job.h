#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "crowd/measures/crossings.h"
#include "crowd/measures/density_field.h"
#include "crowd/measures/fundamental.h"
#include "crowd/measures/lanes.h"
#include "crowd/measures/main_flow.h"
#include "crowd/measures/path_length.h"
#include "crowd/measures/presence.h"
#include "crowd/measures/time_to_collision.h"
#include "crowd/measures/wall_contacts.h"
#include "io/trajectory_table.h"
#include "session/document.h"
#include "session/table.h"

/// What can be said about where people walked: the measures of crowd/measures/ at one place over one span of time.
namespace inhabit::session {

/// A file of trajectories in any format; errors name the file.
Result<scene::Trajectories> open_trajectories(const std::string& path, const io::TrajectoryOptions& options);

struct MeasureOptions {
  std::vector<Area> walkable;              ///< instead of the trajectories' own; empty: those
  std::optional<Ring> area;                ///< where density and speed are measured; absent: round the line
  std::optional<crowd::MeasureLine> line;  ///< where people are counted; absent: across the main flow
  double radius = 0.2;                     ///< of everybody, metres
  std::optional<double> from, until;       ///< seconds; absent: all there is
  double cut_off = 0;                      ///< of Voronoi cells, metres; 0: none, but 1 m where no walls are known
  int window = 0;                          ///< frames either way for speeds; 0: the number nearest to 5/16 s
  bool field = false;                      ///< also the density field
  int threads = 0;
};

/// Where it was measured, and who chose the place.
struct MeasurePlace {
  crowd::MeasureArea area;
  crowd::MeasureLine line;
  double width = 0;  ///< metres of the line that can be walked on
  bool area_given = false, line_given = false, walls = false;
  double cut_off = 0;
};

struct MeasureReport {
  std::string name;
  double frame_rate = 0, from = 0, until = 0;  ///< seconds of the first and the last frame measured
  std::size_t fixes = 0, frames = 0;
  std::vector<std::string> remarks;  ///< what reading and measuring found odd
  MeasurePlace place;
  crowd::MainFlow main_flow;
  crowd::Presence presence;
  std::vector<double> speeds;  ///< of all fixes whose speed is known, ascending, m/s
  std::vector<crowd::AreaRow> classic, voronoi;
  std::size_t off_ground = 0;
  std::optional<std::pair<double, double>> steady;  ///< seconds; the diagram is of this span, or of all when absent
  std::vector<crowd::FundamentalPoint> points;      ///< Voronoi, one per frame with people
  std::vector<crowd::DensityBin> bins;              ///< of 0.25 people per square metre
  std::vector<crowd::Crossing> crossings;
  crowd::Flow flow;
  std::vector<crowd::LaneRow> lanes;
  crowd::TimesToCollision times_to_collision;
  std::size_t collision_frames = 1;  ///< times to collision are of one in so many frames
  std::vector<crowd::PathRow> paths;
  crowd::Overlaps overlaps;
  crowd::WallContacts walls;
  double radius = 0;
  crowd::DensityField field;
  std::vector<Area> ground;
};

/// Errors: nothing within the span of time, an area or a line that is none.
Result<MeasureReport> measure_job(const scene::Trajectories& trajectories, const MeasureOptions& options);

/// "x0,y0,x1,y1", two corners of a rectangle, or a POLYGON of well-known text without holes.
Result<Ring> parse_area(const std::string& text);
/// "x0,y0,x1,y1".
Result<crowd::MeasureLine> parse_line(const std::string& text);
/// The floor of every scene of a document, as people walk on it.
Result<std::vector<Area>> walkable_of(const Document& document);

/// A table for people: what was measured where, and every measure in one line.
std::string measure_text(const MeasureReport& report);
/// One object; docs/measures.md lists its keys.
std::string measure_json(const MeasureReport& report);
/// Files of the rows behind the figures, as (name, bytes).
std::vector<std::pair<std::string, std::string>> measure_csv(const MeasureReport& report);
/// Plots as (name without extension, drawing as bytes of `format`: svg, png or pdf). `reference`: published points of
/// the fundamental diagram, drawn beside ours.
Result<std::vector<std::pair<std::string, std::string>>> measure_plots(
    const scene::Trajectories& trajectories, const MeasureReport& report, const std::string& format,
    const std::vector<crowd::FundamentalPoint>& reference = {});

/// Lines of two numbers, density and speed, # before comments. Errors: the line that is something else.
Result<std::vector<crowd::FundamentalPoint>> read_curve(const std::string& path);
/// Our median speeds beside those of a published curve, slice by slice of the density.
Table curve_table(const std::vector<crowd::FundamentalPoint>& ours, const std::vector<crowd::FundamentalPoint>& theirs,
                  double width = 0.25);

}  // namespace inhabit::session
