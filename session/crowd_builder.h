#pragma once
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// Short words for writing scenes with people in C++.
namespace inhabit::session {
using namespace scene;

/// Whole micrometres, so that files are readable.
double neat(double metres);

/// An empty room in which people are to walk for so long.
Scene room_to_walk(std::string name, Ring outline, double seconds);

/// Counter-clockwise, axis-parallel.
Ring rectangle(double x0, double y0, double x1, double y1);

/// The game's people (thesis 6.1.1): radius 0.5 m, 1.4 m/s "slightly varied", which we read as a deviation of 0.1.
Body game_body();
/// People as they are: Weidmann's 1.34 +- 0.26 m/s; what cannot be squeezed of a body, 0.3 m across, as preset
/// `pedestrian` was calibrated with. The room that people keep beyond it is the model's headway.
Body pedestrian_body();

/// The index of a choice of the model's "far".
enum class Far { off, long_range, avoidance };
PbdModel game_model(Far far);

Goal area_goal(std::string id, Ring area);
/// `degrees` counter-clockwise from +x.
Goal direction_goal(std::string id, double degrees);
Route route_to(std::vector<std::string> goals);

/// Columns times rows people, the first of them at `first`, columns along x.
Population grid_of_people(std::string id, Vec2 first, int columns, int rows, double spacing, double jitter,
                          const Body& body);
/// `count` people at random.
Population people_in(std::string id, Ring area, int count, const Body& body);
/// `count` people, one after the other at equal times from `from` to `until`.
Source inflow(std::string id, Ring area, int count, double from, double until, const Body& body);

/// Everybody that populations and sources ask for. Requires: every one has a count.
int people_asked(const Crowd& crowd);

/// A gap in the wall of a hall, x from `from` to `to`.
struct Opening {
  double from = 0, to = 0;
};
constexpr double kExitDepth = 1;
/// A hall from (0, 0) to (width, depth) with exits, each `kExitDepth` deep, in its lower and its upper wall; from left
/// to right.
Ring hall_with_exits(double width, double depth, const std::vector<Opening>& lower, const std::vector<Opening>& upper);

}  // namespace inhabit::session
