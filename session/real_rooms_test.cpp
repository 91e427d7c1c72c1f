#include "session/real_rooms.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/test_data.h"
#include "session/exemplar_scenes.h"

using namespace inhabit::session;

TEST_CASE("the difference of two distributions is the area between them") {
  const Features human = {{"bed", {0, 0, 0, 0}}, {"chair", {1, 2, 3}}, {"once", {7}}};
  const Features moved = {{"bed", {0.5, 0.5, 0.5}}, {"chair", {1, 2, 3, 1, 2, 3}}, {"once", {9, 9, 9}}};
  // Beds are half a metre off, chairs not at all, and one example says nothing: 4 of 7 things by 0.5.
  CHECK(std::abs(difference(human, moved) - 0.5 * 4 / 7) < 1e-12);
  CHECK(difference(human, human) == 0);
  CHECK(difference({}, human) == 0);
  CHECK(std::abs(difference({{"a", {0, 1, 2}}}, {{"a", {0, 1, 2, 10}}}) - 2.25) < 1e-12);  // (0.25/3 + 0.5/3) + 8/4
}

TEST_CASE("what stands as in the examples differs by nothing from them") {
  const ExemplarScene* bedroom = find_exemplar_scene("bedroom");
  REQUIRE(bedroom != nullptr);
  inhabit::scene::Priors priors;
  priors.pairs.push_back({"tv", "armchair", {}, 1, false, 1, 1, 0, false});
  const RoomFeatures features = room_features(exemplar_room(*bedroom, 1), priors);
  CHECK(features.wall_distance.at("wardrobe").size() == 2);
  CHECK(features.wall_angle.at("wardrobe").front() < 1e-6);
  CHECK_FALSE(features.wall_distance.contains("tv"));  // it stands on something
  CHECK(features.pair_distance.at("tv & armchair").size() == 1);
  RoomQuality quality;
  quality.add(exemplar_room(*bedroom, 1), {});
  CHECK((quality.rooms == 1 && quality.feasible == 1 && quality.doors_free == 1 && quality.all_reachable == 1));
}

TEST_CASE("a home that is held out teaches nothing about itself") {
  Document a, b;
  a.name = "a", b.name = "b";
  for (int k = 1; k <= 2; ++k) a.scenes.push_back(exemplar_room(*find_exemplar_scene("bedroom"), k));
  b.scenes.push_back(exemplar_room(*find_exemplar_scene("living-room"), 1));
  const auto held = held_out_homes(std::vector{a, b});
  REQUIRE(held.ok());
  REQUIRE(held->size() == 2);
  CHECK((*held)[0].rooms.size() == 2);
  CHECK((*held)[0].priors.of("bed") == nullptr);
  CHECK((*held)[0].priors.of("sofa") != nullptr);
  CHECK((*held)[1].priors.of("bed") != nullptr);
}
