#include "layout/contacts.h"

#include <doctest/doctest.h>

#include <chrono>

#include "layout/test_scene.h"

using namespace inhabit::layout;
using namespace inhabit::layout::testing;

TEST_CASE("a long row of small things takes no more cells than things") {
  Scene scene = empty_room(1e6, 4);
  for (int i = 0; i < 100; ++i) add(scene, std::to_string(i), {1e-3, 1e-3, 1}, {i * 1e4 + 1, 2});
  add(scene, "last", {1e-3, 1e-3, 1}, {99e4 + 1 + 5e-4, 2});
  const Ready ready(scene);
  Contacts contacts(ready.problem);
  const auto start = std::chrono::steady_clock::now();
  contacts.refresh(ready.x);
  // With cells as small as the things, gigabytes of them.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::milliseconds(500));
  CHECK(contacts.pairs().size() == 1);
}
