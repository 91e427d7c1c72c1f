#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

/// What is wrong with a layout (scene.md, `inhabit check`). Depths in metres by the separating-axis test on the oriented
/// boxes whose z ranges overlap.
namespace inhabit::layout {
using namespace scene;

/// Deeper than this counts as an overlap, or as outside: 1 mm.
constexpr double kFeasibleDepth = 1e-3;

struct CheckReport {
  struct Overlap { std::string a, b; double depth = 0; };
  struct Outside { std::string id; double depth = 0; };
  struct BlockedDoor { std::string id; double share = 0; };
  struct BlockedClearance { std::string id, face; double blocked_share = 0; };
  struct BlockedView { std::string id; double blocked_share = 0; };
  struct Reachable { double share = 1; std::vector<std::string> unreachable; };
  /// |C| of all constraints of one kind: metres, or degrees for orientations.
  struct Kind { std::string type, unit; std::size_t count = 0; double median = 0, p95 = 0, max = 0; };
  /// One constraint that is not satisfied, for people: who, by how much.
  struct Violation { std::string type; std::vector<std::string> between; double residual = 0; std::string unit; std::string text; };

  bool feasible = false;
  std::vector<Overlap> overlaps;
  std::vector<Outside> outside;
  std::vector<BlockedDoor> blocked_doors;
  std::vector<BlockedClearance> clearances;
  Reachable reachable;
  double walkable_share = 1;
  std::vector<BlockedView> views;
  std::vector<Kind> constraints;
  double energy = 0;
  std::vector<Violation> violations;  ///< residual above 5 cm or 5 degrees, largest first
};

/// Objects without a position count as missing: they are listed in `outside` with an infinite depth.
CheckReport check(const Scene& scene);

/// Signed residual of one constraint instance, as the solver sees it.
struct Residual {
  std::string_view type;
  bool angular = false;     ///< radians instead of metres
  double value = 0;         ///< violation, 0 when satisfied
  std::vector<Ref> between;
};
/// Every declared constraint instance at the scene's positions (defaults such as collisions are not listed), and the energy
/// of everything (TVCG eq. 1).
struct Residuals {
  std::vector<Residual> list;
  double energy = 0;
};
Residuals residuals(const Scene& scene);

}  // namespace inhabit::layout
