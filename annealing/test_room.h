#pragma once
#include <string>

#include "annealing/arrange.h"

/// A furnished flat for tests, with priors written by hand.
namespace inhabit::annealing::testing {

inline Object thing(std::string id, std::string kind, Vec3 size) {
  Object o;
  o.id = std::move(id), o.kind = std::move(kind), o.size = size;
  return o;
}
inline KindPrior at_wall(std::string kind, double distance, double angle = 0) {
  KindPrior prior;
  prior.kind = std::move(kind), prior.count = 5, prior.rooms = 5, prior.by_hand = true;
  prior.wall.push_back({distance, angle, 0.01, 0.02, 5});
  return prior;
}

/// Rectangular, `width` by `depth`, a door in the front wall and one in the back wall.
inline Scene empty_room(double width = 6, double depth = 5) {
  Scene scene;
  scene.space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  Door door;
  door.id = "front", door.wall = 0, door.from = 0.5;
  scene.space.doors.push_back(door);
  door.id = "back", door.wall = 2, door.from = 0.5;
  scene.space.doors.push_back(door);
  return scene;
}

inline Priors some_priors() {
  Priors p;
  p.kinds = {at_wall("bookcase", 0.02), at_wall("chair", 1.5), at_wall("lamp", 0.1),  at_wall("picture", 0),
             at_wall("plate", 1.5),     at_wall("sofa", 0.05), at_wall("table", 1.2), at_wall("tv", 0.1)};
  p.kinds[0].access = {0, 0, 0.5, 0};
  p.kinds[3].support.push_back({Mount::wall, "", 5});
  p.kinds[4].wall.clear();
  p.kinds[4].support.push_back({Mount::floor, "table", 5});
  p.kinds[5].access = {0, 0, 0.5, 0};
  p.kinds[6].wall.clear();
  p.kinds[7].view = View{2.0, radians(50)};
  PairPrior seats{"table", "chair", {{0.8, 0, 0, 0.02, 2, 0.05, 20}}, 4, true, 20, 5, 0.02, true};
  PairPrior watch{"tv", "sofa", {{2.5, 0, 0, 0.1, 0.05, 0.05, 5}}, 1, false, 5, 5, 0.04, true};
  PairPrior plates{"chair", "plate", {{0.45, 0, 0, 0.02, 0.05, 0.05, 20}}, 1, false, 20, 5, 0.02, true};
  p.pairs = {plates, seats, watch};
  return p;
}

/// `sets` of a table, four chairs and two plates, and what else a flat has, in a room that grows with them.
inline Scene flat(int sets = 1) {
  const double side = std::sqrt(static_cast<double>(sets));
  Scene scene = empty_room(6 * side, 5 * side);
  const auto numbered = [](const char* kind, int k) { return std::string(kind) + "-" + std::to_string(k); };
  for (int s = 0; s < sets; ++s) {
    scene.objects.push_back(thing(numbered("table", s), "table", {1.2, 0.8, 0.75}));
    for (int k = 0; k < 4; ++k)
      scene.objects.push_back(thing(numbered("chair", 4 * s + k), "chair", {0.45, 0.45, 0.9}));
    for (int k = 0; k < 2; ++k)
      scene.objects.push_back(thing(numbered("plate", 2 * s + k), "plate", {0.25, 0.25, 0.03}));
    scene.objects.push_back(thing(numbered("bookcase", s), "bookcase", {1.0, 0.35, 1.9}));
    scene.objects.push_back(thing(numbered("lamp", s), "lamp", {0.35, 0.35, 1.6}));
    scene.objects.push_back(thing(numbered("sofa", s), "sofa", {1.9, 0.9, 0.85}));
    scene.objects.push_back(thing(numbered("tv", s), "tv", {1.2, 0.4, 1.0}));
    scene.objects.push_back(thing(numbered("picture", s), "picture", {0.8, 0.04, 0.6}));
  }
  return scene;
}

}  // namespace inhabit::annealing::testing
