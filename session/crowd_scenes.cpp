#include "session/crowd_scenes.h"

#include <array>

namespace inhabit::session {
namespace {

using enum BottleneckOf;
using enum Rimea15;

/// Published milliseconds: thesis table 6.1.
constexpr std::array kScenes = {
    CrowdScene{"sparse-passing", sparse_passing, "Two groups of 800 pass each other, 4.5 m apart", 11.27, 11.61},
    CrowdScene{"dense-passing", dense_passing, "The same, 2.5 m apart", 12.03, 11.34},
    CrowdScene{"dense-passing-10k", dense_passing_10k, "Two groups of 5,016, 3.5 m apart", 14.06, 13.63},
    CrowdScene{"bears-and-rabbits", bears_and_rabbits, "1,024 small and light pass 128 large and heavy", 0, 11.86},
    CrowdScene{"dense-ellipsoid", dense_ellipsoid, "An ellipse of 320 keeps its shape through a rectangle of 1,600", 0,
               10.06},
    CrowdScene{"proximal", proximal, "Two groups of 50 meet in a narrow hallway", 10.12, 10.13},
    CrowdScene{"target-locomotion", target_locomotion, "192 walk to a place each, and all arrive", 10.42},
    CrowdScene{"bottleneck-480", [] { return bottleneck(thesis, 480); }, "480 before a corridor 6 m wide", 0, 0, 11.99},
    CrowdScene{"bottleneck-3600", [] { return bottleneck(thesis, 3600); }, "3,600 before a corridor 12 m wide", 0, 0,
               17.76},
    CrowdScene{"bottleneck-100048", [] { return bottleneck(thesis, 100048); }, "100,048 before a corridor 48 m wide", 0,
               0, 43.66},
    CrowdScene{"power-law-sparse", power_law_sparse, "The power law's model, two groups of 672, 4.5 m apart"},
    CrowdScene{"power-law-dense", power_law_dense, "The same, 3.3 m apart, where it fails"},
    CrowdScene{"peers-passing-1600", [] { return peers_passing(1600); }, "Two blocks of 800, as other programs ran it"},
    CrowdScene{"peers-passing-10032", [] { return peers_passing(10032); }, "Two blocks of 5,016"},
    CrowdScene{"peers-passing-100000", [] { return peers_passing(100000); }, "Two blocks of 50,000"},
    CrowdScene{"peers-bottleneck-480", [] { return bottleneck(peers, 480); },
               "480 through 6 m, with all contacts ahead"},
    CrowdScene{"peers-bottleneck-3600", [] { return bottleneck(peers, 3600); }, "3,600 through 12 m"},
    CrowdScene{"peers-bottleneck-100048", [] { return bottleneck(peers, 100048); }, "100,048 through 48 m"},
    CrowdScene{"peers-crush", peers_crush, "100,048 in a dense lattice head for its centre"},
    CrowdScene{"rimea-01", rimea_01, "A person walks 40 m at 1.33 m/s in 26 to 34 s"},
    CrowdScene{"rimea-04-density-05", [] { return rimea_04(0.5); },
               "Speed in a corridor at 0.5 people per square metre"},
    CrowdScene{"rimea-04-density-10", [] { return rimea_04(1); }, "The same at 1"},
    CrowdScene{"rimea-04-density-20", [] { return rimea_04(2); }, "The same at 2"},
    CrowdScene{"rimea-04-density-30", [] { return rimea_04(3); }, "The same at 3"},
    CrowdScene{"rimea-04-density-40", [] { return rimea_04(4); }, "The same at 4"},
    CrowdScene{"rimea-04-density-50", [] { return rimea_04(5); }, "The same at 5"},
    CrowdScene{"rimea-04-density-60", [] { return rimea_04(6); }, "The same at 6"},
    CrowdScene{"rimea-05", rimea_05, "Ten people set off after 10 to 100 s"},
    CrowdScene{"rimea-06", rimea_06, "Twenty people round a corner, through no wall"},
    CrowdScene{"rimea-07", rimea_07, "Fifty adults have the speeds of the distribution"},
    CrowdScene{"rimea-09-four-exits", [] { return rimea_09(true); }, "1,000 leave a hall by four exits"},
    CrowdScene{"rimea-09-two-exits", [] { return rimea_09(false); }, "By two of them, in about twice the time"},
    CrowdScene{"rimea-10", rimea_10, "23 people from twelve rooms, each to his exit"},
    CrowdScene{"rimea-11", rimea_11, "1,000 people and two exits, one nearer"},
    CrowdScene{"rimea-12", rimea_12, "A corridor between two rooms: the jam is before it"},
    CrowdScene{"rimea-15-long", [] { return rimea_15(straight_long); }, "500 along a corner's outer wall, unbent"},
    CrowdScene{"rimea-15-short", [] { return rimea_15(straight_short); }, "500 along its inner wall, unbent"},
    CrowdScene{"rimea-15-corner", [] { return rimea_15(corner); }, "500 round the corner: a time between the two"},
    CrowdScene{"experiment-bottleneck-040", experiment_bottleneck_040, "75 people before an entrance of 0.5 m"},
    CrowdScene{"experiment-unidirectional-050-180-180", [] { return experiment_unidirectional(50); },
               "61 people in a one-way corridor, entrance 0.5 m"},
    CrowdScene{"experiment-unidirectional-100-180-180", [] { return experiment_unidirectional(100); },
               "121 people, entrance 1 m"},
    CrowdScene{"experiment-unidirectional-145-180-180", [] { return experiment_unidirectional(145); },
               "175 people, entrance 1.45 m"},
    CrowdScene{"experiment-unidirectional-180-180-120", [] { return experiment_unidirectional(180); },
               "170 people, exit 1.2 m"},
    CrowdScene{"experiment-unidirectional-500", experiment_unidirectional_500, "148 people in a corridor 5 m wide"},
    CrowdScene{"experiment-bidirectional-050", [] { return experiment_bidirectional(50); },
               "118 people both ways through a corridor 3.6 m wide"},
    CrowdScene{"experiment-bidirectional-090", [] { return experiment_bidirectional(90); }, "214 people: lanes"},
    CrowdScene{"experiment-corner", experiment_corner, "137 people round a corner of a corridor 3 m wide"},
    CrowdScene{"experiment-t-junction", experiment_t_junction, "Two streams of 67 become one"},
    CrowdScene{"experiment-single-file-04", [] { return experiment_single_file(4); }, "Four people in a ring of 15 m"},
    CrowdScene{"experiment-single-file-14", [] { return experiment_single_file(14); }, "14 people in a ring of 18 m"},
    CrowdScene{"experiment-single-file-20", [] { return experiment_single_file(20); }, "20 people in it"},
    CrowdScene{"experiment-single-file-30", [] { return experiment_single_file(30); }, "30 people in it"},
};

}  // namespace

std::span<const CrowdScene> crowd_scenes() { return kScenes; }

const CrowdScene* find_crowd_scene(std::string_view name) {
  for (const CrowdScene& scene : kScenes)
    if (scene.name == name) return &scene;
  return nullptr;
}

}  // namespace inhabit::session
