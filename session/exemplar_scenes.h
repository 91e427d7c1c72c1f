#pragma once
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// The seven scenes of "Make it Home" (Yu et al. 2011, section 5 and table 1), designed anew: five furnished rooms to
/// learn from and what is to be furnished. Counts and pairs are the paper's, rooms and things are ours.
namespace inhabit::session {
using namespace scene;

inline constexpr int kExemplars = 5;

struct ExemplarScene {
  std::string_view name, sentence;
  int objects = 0;                                                   ///< in every room
  std::vector<std::pair<std::string_view, std::string_view>> pairs;  ///< first and second, for inhabit learn --pair
  int iterations = 0;                                                ///< published
  double seconds = 0;                                                ///< published
  /// A furnished room, k from 1 to kExemplars; beyond, the rooms of the syntheses, whose things are then taken out.
  Scene (*build)(int k) = nullptr;
  int inputs = 1;  ///< rooms to be furnished
};

/// In the order of the paper's table 1.
std::span<const ExemplarScene> exemplar_scenes();
/// Null when there is none of that name.
const ExemplarScene* find_exemplar_scene(std::string_view name);

/// "exemplar/bedroom-3".
Scene exemplar_room(const ExemplarScene& scene, int k);
/// "learned-bedroom", or "learned-flower-shop-2" where there are several: the room with its things without places.
Scene exemplar_input(const ExemplarScene& scene, int k = 1);

// A room of each, furnished.
Scene plan_living_room(int k);
Scene plan_bedroom(int k);
Scene plan_restaurant(int k);
Scene plan_resort(int k);
Scene plan_factory(int k);
Scene plan_flower_shop(int k);
Scene plan_gallery(int k);

}  // namespace inhabit::session
