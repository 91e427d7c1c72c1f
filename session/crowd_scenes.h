#pragma once
#include <span>
#include <string_view>

#include "scene/scene.h"

/// Scenes with people: the thesis's scenarios, those that we compare with other programs, the field's tests and its
/// experiments. What the sources do not print is ours and stands, with the reason, beside each builder.
/// docs/scenes.md says what each is for; scenes/*.json are written from here.
namespace inhabit::session {
using namespace scene;

// The thesis's own (6.1.2, 6.1.3).
Scene sparse_passing();
Scene dense_passing();
Scene dense_passing_10k();
Scene bears_and_rabbits();
Scene dense_ellipsoid();
Scene proximal();
Scene target_locomotion();
Scene power_law_sparse();
Scene power_law_dense();

// One narrow place, for the thesis's figures and for the peers'.
enum class BottleneckOf { thesis, peers };
/// 480, 3,600 or 100,048 people before a corridor 20 m long.
Scene bottleneck(BottleneckOf whose, int people);

// What RVO2, JuPedSim and others were measured with.
/// 1,600, 10,032 or 100,000 people in two blocks.
Scene peers_passing(int people);
Scene peers_crush();

// RiMEA's tests, where people move in the plane.
Scene rimea_01();
/// A corridor of 1,000 m filled with so many people per square metre.
Scene rimea_04(double density);
Scene rimea_05();
Scene rimea_06();
Scene rimea_07();
/// All four exits, or those of the lower wall alone.
Scene rimea_09(bool four_exits);
Scene rimea_10();
Scene rimea_11();
Scene rimea_12();
enum class Rimea15 { straight_long, straight_short, corner };
Scene rimea_15(Rimea15 geometry);

// Experiments with recordings.
Scene experiment_bottleneck_040();
/// By the widths in the recording's name, centimetres: 50, 100, 145 with a free exit, or 180 with an exit of 120.
Scene experiment_unidirectional(int entrance);
Scene experiment_unidirectional_500();
/// Entrances of 50 or 90 cm at both ends.
Scene experiment_bidirectional(int entrance);
Scene experiment_corner();
Scene experiment_t_junction();
/// 4, 14, 20 or 30 people in a ring.
Scene experiment_single_file(int people);

struct CrowdScene {
  std::string_view name;
  Scene (*build)();
  std::string_view sentence;
  /// Published milliseconds for a frame of two steps (thesis table 6.1): with long range, with avoidance, with neither.
  double long_range_ms = 0, avoidance_ms = 0, contact_ms = 0;
};

/// Every scene with people there is, in the order above.
std::span<const CrowdScene> crowd_scenes();
/// Null when there is none of that name.
const CrowdScene* find_crowd_scene(std::string_view name);

}  // namespace inhabit::session
