#pragma once
#include "io/formats/scene_members.h"
#include "scene/priors.h"

/// What every object of a priors file may hold: reading, writing, messages and docs/priors.md come from these tables.
namespace inhabit::io {

constexpr double kManyExamples = 1e9;

template <>
struct Table<CostWeights> {
  static constexpr std::tuple members{
      Member{"accessibility", &CostWeights::accessibility, {"free space in front of faces", "", 0, 1e6}},
      Member{"visibility", &CostWeights::visibility, {"free view", "", 0, 1e6}},
      Member{"pathway", &CostWeights::pathway, {"free ways between doors", "", 0, 1e6}},
      Member{"wall_distance", &CostWeights::wall_distance, {"distance to the nearest wall", "", 0, 1e6}},
      Member{"wall_angle", &CostWeights::wall_angle, {"heading to the nearest wall", "", 0, 1e6}},
      Member{"pair_distance", &CostWeights::pair_distance, {"distance within pairs", "", 0, 1e6}},
      Member{"pair_angle", &CostWeights::pair_angle, {"headings within pairs", "", 0, 1e6}}};
};

template <>
struct Table<WallMode> {
  static constexpr std::tuple members{
      Member{
          "distance", &WallMode::distance, {"from the back face's centre to the nearest wall", "m", -100, 1e4, true}},
      Member{"angle",
             &WallMode::angle,
             {"heading, from the wall's inward normal: 0 = back to the wall", "rad", -kTurn, kTurn}},
      Member{"distance_deviation", &WallMode::distance_deviation, {"standard deviation", "m", 0, 1e4}},
      Member{"angle_deviation", &WallMode::angle_deviation, {"circular standard deviation", "rad", 0, kTurn}},
      Member{"count", &WallMode::count, {"examples in it; 1 when absent", "", 1, kManyExamples}}};
};

template <>
struct Table<Support> {
  static constexpr std::tuple members{
      Member{"mount", &Support::mount, {"what holds it", "", 0, 0, false, "floor|wall|ceiling"}},
      Member{"on", &Support::on, {"the kind that carries it; absent: nothing does"}},
      Member{"count", &Support::count, {"examples; 1 when absent", "", 1, kManyExamples}}};
};

template <>
struct Table<KindPrior> {
  static constexpr std::tuple members{
      Member{"kind", &KindPrior::kind, {"as the scenes call it, in lower-case words", "", 0, 0, true}},
      Member{"count", &KindPrior::count, {"examples seen", "", 0, kManyExamples}},
      Member{"rooms", &KindPrior::rooms, {"in so many rooms", "", 0, kManyExamples}},
      Member{"back", &KindPrior::back, {"the face that stands to the wall", "", 0, 0, false, "back|left|front|right"}},
      Member{"back_share", &KindPrior::back_share, {"share of the examples near a wall in which it did", "", 0, 1}},
      Member{"wall", &KindPrior::wall, {"how it stands to the nearest wall, the most frequent way first"}},
      Member{"support", &KindPrior::support, {"what carries it, the most frequent first"}},
      Member{"access", &KindPrior::access, {"free depth in front of each face that people must reach", "m", 0, 100}},
      Member{"view", &KindPrior::view, {"its front must be seen from so far"}},
      Member{"elevation", &KindPrior::elevation, {"height of the base of what hangs on a wall", "m", 0, 1e4}},
      Member{"by_hand", &KindPrior::by_hand, {"written by a person, not learned"}}};
};

template <>
struct Table<PairMode> {
  static constexpr std::tuple members{
      Member{"distance", &PairMode::distance, {"between the centres", "m", 0, 1e4, true}},
      Member{"bearing",
             &PairMode::bearing,
             {"where the second's centre is, from the first's heading", "rad", -kTurn, kTurn}},
      Member{"facing",
             &PairMode::facing,
             {"the second's heading, from the direction to the first: 0 = looks at it", "rad", -kTurn, kTurn}},
      Member{"distance_deviation", &PairMode::distance_deviation, {"standard deviation", "m", 0, 1e4}},
      Member{"bearing_deviation", &PairMode::bearing_deviation, {"circular standard deviation", "rad", 0, kTurn}},
      Member{"facing_deviation", &PairMode::facing_deviation, {"circular standard deviation", "rad", 0, kTurn}},
      Member{"count", &PairMode::count, {"examples in it; 1 when absent", "", 1, kManyExamples}}};
};

template <>
struct Table<PairPrior> {
  static constexpr std::tuple members{
      Member{"first", &PairPrior::first, {"the kind that others belong to", "", 0, 0, true}},
      Member{"second", &PairPrior::second, {"the kind whose things belong each to the nearest first", "", 0, 0, true}},
      Member{"modes",
             &PairPrior::modes,
             {"how a second stands to its first, the most frequent way first", "", 0, 0, true}},
      Member{"per_first", &PairPrior::per_first, {"so many seconds to one first, on average", "", 0, 1e6}},
      Member{"concentric",
             &PairPrior::concentric,
             {"they stand round it at any bearing, evenly spaced; the bearings then mean nothing"}},
      Member{"count", &PairPrior::count, {"examples seen", "", 0, kManyExamples}},
      Member{"rooms", &PairPrior::rooms, {"in so many rooms", "", 0, kManyExamples}},
      Member{"spread",
             &PairPrior::spread,
             {"deviation of the distance within the modes over its mean: the smaller, the steadier", "", 0, 1e6}},
      Member{"by_hand", &PairPrior::by_hand, {"named by a person; otherwise proposed from the examples"}}};
};

template <>
struct Table<Priors> {
  static constexpr std::tuple members{Member{"rooms", &Priors::rooms, {"the rooms that were learned from"}},
                                      Member{"weights", &Priors::weights, {"weights of the cost's terms"}},
                                      Member{"kinds", &Priors::kinds, {"what is known of each kind"}},
                                      Member{"pairs", &Priors::pairs, {"what is known of two kinds together"}}};
};

constexpr std::string_view kPriorsName = "inhabit-priors";
constexpr int kPriorsVersion = 1;

}  // namespace inhabit::io
