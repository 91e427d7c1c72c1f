#pragma once
#include "scene/crowd_models.h"

/// The people of a scene document: who they are, where they start, where they want to be.
namespace inhabit::scene {

/// How fast people want to walk: normally distributed, cut off at three deviations and at a tenth of the mean.
struct Speed {
  double mean = 1.34, deviation = 0.26;
  std::optional<double> maximum;  ///< nobody walks faster; absent: 1.3 times a person's own wish
  friend bool operator==(const Speed&, const Speed&) = default;
};

/// A number, or evenly spread between two: `0.5` or `[1.25, 2]` in a file.
struct Span {
  double low = 0, high = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// Goals one after the other; where a leg has several, the one that is nearest on foot counts. In a file `"east"`, or
/// `["shop", ["exit-1", "exit-2"]]`.
struct Route {
  std::vector<std::vector<std::string>> legs;
  bool empty() const { return legs.empty(); }
  friend bool operator==(const Route&, const Route&) = default;
};

/// What people of one kind have in common.
struct Body {
  Span radius{0.25, 0.25};
  double mass = 1;
  Speed speed;
  Route goal;
  friend bool operator==(const Body&, const Body&) = default;
};

/// People who are there at first: on a square grid when there is a spacing, else at random without touching.
struct Population : Body {
  std::string id;
  std::optional<int> count;  ///< absent: one on every point of the grid
  Ring area;
  std::optional<double> spacing;
  double jitter = 0;     ///< each coordinate is moved by up to this much either way
  bool walking = false;  ///< start with the velocity that they like, towards their goal, instead of at rest
  Extras extras;
  friend bool operator==(const Population&, const Population&) = default;
};

/// A place where people appear as long as there is room.
struct Source : Body {
  std::string id;
  Ring area;
  double rate = 1;  ///< people per second
  enum class Arrivals { even, poisson } arrivals = Arrivals::even;
  double from = 0;              ///< seconds
  std::optional<double> until;  ///< seconds
  std::optional<int> count;     ///< not more than so many in all
  Extras extras;
  friend bool operator==(const Source&, const Source&) = default;
};

/// Where people want to be: an area, or a direction (for ever), or a way from where each one started.
struct Goal {
  std::string id;
  Ring area;                        ///< reached on entering it
  Ring aim;                         ///< what they head for while they are not there; empty: the area
  std::optional<double> direction;  ///< radians
  std::optional<Vec2> offset;
  double jitter = 0;   ///< of an offset: each coordinate moved by up to this much either way
  double wait = 0;     ///< seconds spent there before going on
  bool absorb = true;  ///< who arrives at the end of a route leaves the scene; otherwise stays
  Extras extras;
  friend bool operator==(const Goal&, const Goal&) = default;
};

enum class Planner { automatic, straight, paths, field };

struct Crowd {
  std::vector<Population> populations;
  std::vector<Source> sources;
  std::vector<Goal> goals;
  CrowdModel model = PbdModel::of_preset(PbdModel::Preset::pedestrian);
  Planner planner = Planner::automatic;
  double step = 1.0 / 48;  ///< seconds
  double seconds = 60;     ///< how long a simulation runs when nobody says
  Extras extras;
  bool empty() const { return populations.empty() && sources.empty() && goals.empty() && extras.empty(); }
  friend bool operator==(const Crowd&, const Crowd&) = default;
};

}  // namespace inhabit::scene
