#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

/// The literature's measures of a layout, as their sources compute them, so that our figures can stand in the same
/// tables. All work on boxes; where the source tests meshes, the name says `boxes`. Section numbers: metrics.md.
namespace inhabit::layout {
using namespace scene;

struct PublishedMetrics {
  /// No value: the scene does not say what the measure needs (no doors, no named sides, too many pairs).
  struct Measure {
    std::string source, name;
    std::optional<double> value;
    std::string unit;
  };
  struct LeftOut {
    std::string name, why;
  };
  std::size_t asked = 0, placed = 0;  ///< objects; dropping objects improves every rate below
  std::vector<Measure> measures;
  std::vector<LeftOut> left_out;
};

/// All of them. The seed moves only SceneEval's surface samples. Seconds for 10,000 objects.
PublishedMetrics published_metrics(const Scene& scene, std::uint64_t seed);

// --- 4.1 SceneEval
// ----------------------------------------------------------------------------------------------------

/// Largest 8-connected part of the floor's pixels / all that the objects leave, 256 x 256, robot of 0.2 m; 0 for none.
double sceneeval_navigability(const Scene& scene);

/// Free share of the 0.2 m strip 0.05 m off a functional side, the best side of each object. Sides are those with a
/// clearance, or named by an accessibility constraint; objects without any are not listed.
struct ObjectScore {
  std::string id;
  double score = 0;
};
std::vector<ObjectScore> sceneeval_accessibility(const Scene& scene);

/// Share of the opening's face that is hidden by boxes standing within the door's width, or 0.5 m of the window.
/// Walls have no thickness here. A box interferes when it meets that space (the source tests sampled points).
struct OpeningOcclusion {
  std::string id;
  bool door = false;
  bool occluded = false;
  double share = 0;
};
std::vector<OpeningOcclusion> sceneeval_opening_clearance(const Scene& scene);

/// Ids of the objects less than 99 % of whose surface samples lie above the floor.
std::vector<std::string> sceneeval_out_of_bound(const Scene& scene, std::uint64_t seed);

/// Number of objects that share more than 5 mm with another in every direction. The source moves colliding meshes 5 mm
/// apart and tests again; for boxes this is the same but for the direction of the move.
std::size_t sceneeval_colliding(const Scene& scene);

/// How well a surface distance (metres) fits a relation: 1 inside its range, else exp(-gap^2 / (2 sigma^2)).
/// Satisfied from 0.5.
enum class Relation { next_to, near, across_from, far, against_wall, on_wall, on_ceiling };
double sceneeval_relation(Relation relation, double distance);

// --- 4.2 PhyScene
// -----------------------------------------------------------------------------------------------------

struct PhyScene {
  std::size_t colliding = 0;             ///< Col_obj's numerator: box IoU > 0 with another
  std::size_t out = 0;                   ///< R_out's numerator: footprint pixels off the floor
  double walkable = 0;                   ///< R_walkable, the largest part as the paper says
  double walkable_physcene_compat = 0;   ///< as the published code computes it: the first part that it labels
  std::optional<double> walkable_doors;  ///< with doors: mean over doors of the part at the door; none without doors
  double reach = 0;                      ///< R_reach
};
PhyScene physcene(const Scene& scene);

// --- 4.3 to 4.5, 4.10
// ---------------------------------------------------------------------------------------------------

/// LayoutGPT: number of objects with a corner more than 0.1 m beyond the room's bounding rectangle.
std::size_t layoutgpt_out_of_bound(const Scene& scene);

/// ReSpace, 5 cm voxels of one grid for all boxes: cubic metres outside the room, shared by pairs, and both together.
struct ReSpace {
  double oob = 0, mbl = 0, pbl = 0;
};
ReSpace respace(const Scene& scene);

/// DiffuScene on axis-parallel bounds: mean IoU over all pairs, share of pairs that intersect, number of symmetric
/// pairs (none above 5,000 objects: every pair is looked at).
struct DiffuScene {
  double mean_iou = 0, intersecting = 0;
  std::optional<std::size_t> symmetric;
};
DiffuScene diffuscene(const Scene& scene);

/// Infinigen's costs, 0 is best. Focus: a's front towards b. Alignment: a's front along the normal of b's side nearest
/// to a's centre. Accessibility: what stands in front of a, larger and nearer ones more (nothing for what covers a's
/// centre).
double infinigen_focus(const Box& a, const Box& b);
double infinigen_angle_alignment(const Box& a, const Box& b);
double infinigen_accessibility(const Box& a, std::span<const Box> others);
/// Per cent of the room's area that footprints leave; overlapping ones count twice.
double infinigen_freespace_2d(const Scene& scene);

}  // namespace inhabit::layout
