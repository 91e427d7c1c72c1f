#include "layout/contacts.h"

#include <doctest/doctest.h>

#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

TEST_CASE("a long row of small things takes no more cells than things") {
  Scene scene = empty_room(1e6, 4);
  for (int i = 0; i < 100; ++i) add(scene, std::to_string(i), {1e-3, 1e-3, 0.1}, {i * 1e4 + 1, 2});
  const Ref last = add(scene, "last", {1e-3, 1e-3, 0.1}, {99e4 + 1 + 5e-4, 2});
  Ready ready(scene);
  ready.project_collisions();
  // With cells as small as the things there would be 1e9 of them, and no memory for that.
  CHECK(separation(ready.box(last), ready.x.boxes[99]).depth < 1e-9);
}
