#include "session/exemplar_scenes.h"

#include <array>

#include "layout/furnish.h"

namespace inhabit::session {

std::span<const ExemplarScene> exemplar_scenes() {
  static const std::array kScenes = {
      ExemplarScene{
          "living-room", "Sofa and armchairs round a television", 20, {{"tv", "sofa"}}, 20000, 22, plan_living_room},
      ExemplarScene{"bedroom",
                    "A bed, a television before an armchair, a place to work",
                    24,
                    {{"tv", "armchair"}, {"desk", "work chair"}},
                    20000,
                    48,
                    plan_bedroom},
      ExemplarScene{"restaurant",
                    "Five tables laid for four",
                    54,
                    {{"chair", "dish set"}, {"table", "chair"}},
                    25000,
                    219,
                    plan_restaurant},
      ExemplarScene{"resort",
                    "An L-shaped hall to paint, to make music and to sit in",
                    30,
                    {{"easel", "stool"}, {"drum", "chair"}, {"guitar", "chair"}, {"couch", "tea table"}},
                    42000,
                    126,
                    plan_resort},
      ExemplarScene{"factory",
                    "Sixteen work desks and the supervisor's",
                    51,
                    {{"work desk", "work chair"}, {"supervisor desk", "supervisor chair"}},
                    42000,
                    262,
                    plan_factory},
      ExemplarScene{
          "flower-shop", "Racks and tables of flowers between two doors", 64, {}, 22000, 376, plan_flower_shop, 3},
      ExemplarScene{"gallery",
                    "Paintings, sculptures and chairs among pillars",
                    35,
                    {{"chair", "chair"}},
                    18000,
                    88,
                    plan_gallery},
  };
  return kScenes;
}

const ExemplarScene* find_exemplar_scene(std::string_view name) {
  for (const ExemplarScene& scene : exemplar_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

Scene exemplar_room(const ExemplarScene& scene, int k) {
  Scene room = scene.build(k);
  room.name = std::string(scene.name) + "-" + std::to_string(k);
  return room;
}

Scene exemplar_input(const ExemplarScene& scene, int k) {
  Scene room = layout::without_positions(scene.build(kExemplars + k));
  room.name = "learned-" + std::string(scene.name) + (scene.inputs > 1 ? "-" + std::to_string(k) : "");
  return room;
}

}  // namespace inhabit::session
