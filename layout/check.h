#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "layout/published_metrics.h"
#include "scene/scene.h"

/// What is wrong with a layout (`inhabit check`). Depths in metres by the separating-axis test on the oriented boxes
/// whose z ranges overlap by more than 1 mm.
namespace inhabit::layout {
using namespace scene;

/// Deeper than this counts as an overlap, or as outside: 1 mm.
constexpr double kFeasibleDepth = 1e-3;

/// A person: a disc of this radius, this tall, who steps over what is flatter than a step and asks for this depth at a
/// door.
constexpr double kPersonRadius = 0.25, kPersonHeight = 1.9, kStepHeight = 0.05, kPersonDepth = 0.6;

struct CheckOptions {
  bool all_collisions = false;  ///< list the overlaps that are excused, too
  bool published = false;       ///< fill CheckReport::published
  int threads = 0;              ///< 0: all there are; never changes the result
};

struct CheckReport {
  struct Overlap {
    std::string a, b;
    double depth = 0;
  };
  struct Outside {
    std::string id;
    double depth = 0;
  };
  struct BlockedDoor {
    std::string id;
    double share = 0;
  };
  struct BlockedClearance {
    std::string id, face;
    double blocked_share = 0;
  };
  struct BlockedView {
    std::string id;
    double blocked_share = 0;
  };
  struct Reachable {
    double share = 1;
    std::vector<std::string> unreachable;
  };
  /// |C| of all constraints of one kind: metres, or degrees for orientations. The median is the mean of the two middle
  /// values of an even count, p95 the smallest value that 95 % do not exceed.
  struct Kind {
    std::string type, unit;
    std::size_t count = 0;
    double median = 0, p95 = 0, max = 0;
  };
  /// One constraint that is not satisfied, for people: who, by how much.
  struct Violation {
    std::string type;
    std::vector<std::string> between;
    double residual = 0;
    std::string unit;
    std::string text;
  };

  bool feasible = false;
  std::vector<Overlap> overlaps;           ///< deepest first; the deepest 200,000 of `overlap_count`
  std::vector<Outside> outside;            ///< deepest first
  std::vector<BlockedDoor> blocked_doors;  ///< more than 0.1 % blocked, as are the next and the views; worst first
  std::vector<BlockedClearance> clearances;
  Reachable reachable;
  double walkable_share = 1;
  std::vector<BlockedView> views;
  std::vector<Kind> constraints;
  double energy = 0;
  std::vector<Violation> violations;  ///< residual above 5 cm or 5 degrees; in these units, largest first
  std::size_t overlap_count = 0;
  std::uint64_t exempt_pairs = 0;   ///< pairs that a `collision` constraint with mode off excuses
  std::size_t overlaps_exempt = 0;  ///< how many of those overlap; counted with `all_collisions`, too
  std::size_t overlaps_rigid = 0;   ///< overlaps inside rigid groups, whose shape the scene gives; likewise
  std::size_t overlaps_pinned = 0;  ///< overlaps between things that cannot move; likewise
  std::size_t outside_pinned = 0;   ///< things that cannot move and reach out of the room; not listed
  std::size_t missing = 0;          ///< objects without a position
  double raster_cell = 0;           ///< cell of the raster behind reachable and walkable_share, metres
  std::optional<PublishedMetrics> published;
};

/// What is wrong with the scene as it stands. An object without a position is missing: it is listed in `outside` with
/// an infinite depth, counts nowhere else, and leaves `constraints` and `energy` empty; without an angle it faces +x.
/// - overlaps: never between an object and what carries it (`on`, stacking), be it through others or through groups;
///   and, unless all_collisions is set, none that a `collision` constraint with mode off excuses or within a rigid
///   group, nor between two things that cannot move (fixed, locked in place, or rigidly grouped with such): they are
///   taken as given, as a home's stairs reach through its walls and its built-in kitchen units into each other.
/// - outside: outside_depth of the box in plan; neither height nor ceiling counts, nor does what cannot move.
/// - blocked_doors: share of (quarter disc that the leaf sweeps, for `in`) and (a person's depth in front) that is
/// covered
///   by something lower than the door and no step, or lies outside the room.
/// - clearances: share of the wanted rectangle that is covered by something between a step above the object's base and
///   the higher of its top and a person's height, or lies outside the room. Not covered by what is bound to the object
///   through a distance, focal_distance, stacking or orientation constraint, through `on`, or in the same rigid group:
///   a chair may stand in its table's clearance.
/// - views: share of that part of the cone which lies in the room that others, bound ones excepted, cover at its
/// height.
/// - reachable: a person's centre moves on a raster of 2 cm (coarser above 16 million cells); it is free where it keeps
///   kPersonRadius from walls, holes, and objects that a person can bump into. share = part of the free cells connected
///   to a place just inside a door between its jambs; without doors, to any cell of the largest connected part.
///   Unreachable is an object standing on the floor none of whose surroundings, 5 cm beyond the person's radius, is so.
/// - walkable_share: area of the free cells / area of the room.
/// Shares of areas are counted on samples at most 2 cm apart (or 100 a side). Seconds for 100,000 objects.
CheckReport check(const Scene& scene, const CheckOptions& options = {});

/// Signed residual of one constraint instance, as the solver sees it.
struct Residual {
  std::string_view type;
  bool angular = false;  ///< radians instead of metres
  double value = 0;      ///< violation, 0 when satisfied
  std::vector<Ref> between;
};
/// Every declared constraint instance at the scene's positions (defaults such as collisions are not listed), and the
/// energy of everything (TVCG eq. 1).
struct Residuals {
  std::vector<Residual> list;
  double energy = 0;
};
Residuals residuals(const Scene& scene);

}  // namespace inhabit::layout
