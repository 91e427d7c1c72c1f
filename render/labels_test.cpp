#include "render/labels.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace inhabit;
using namespace inhabit::render;

namespace {

struct Case {
  std::vector<LabelRequest> requests;
  LabelField field;
};

Case random_case(std::uint64_t seed) {
  core::Rng rng(seed);
  Case c;
  c.field.page.add({0, 0});
  c.field.page.add({rng.uniform(300, 1200), rng.uniform(300, 1200)});
  const int n = 1 + static_cast<int>(rng.index(40));
  for (int i = 0; i < n; ++i) {
    const auto size = [&] { return std::exp(rng.uniform(0.5, 4.5)); };
    const Vec2 p{rng.uniform(0, c.field.page.max.x), rng.uniform(0, c.field.page.max.y)};
    const double angle = rng.index(2) ? rng.uniform(-3.1, 3.1) : core::kPi / 2 * rng.index(4);
    const Box box{p, direction(angle), size(), size()};
    c.field.obstacles.push_back({box, rng.index(5) == 0});
    LabelRequest r{box, {{rng.uniform(10, 90), 14}}, i};
    if (rng.index(2)) r.shapes.push_back({r.shapes[0].x * 0.6, 28});
    r.round = rng.index(3) == 0;
    c.requests.push_back(r);
  }
  for (int i = 0; i < 3; ++i) c.field.taken.push_back({{rng.uniform(0, 300), rng.uniform(0, 300)}, {1, 0}, 20, 8});
  return c;
}

bool holds(const Box& outer, const Box& inner) {
  for (const Vec2 p : inner.corners())
    if (!Box{outer.center, outer.front, outer.half_depth + 1e-6, outer.half_width + 1e-6}.contains(p)) return false;
  return true;
}

}  // namespace

TEST_CASE("labels of random boxes keep off each other and off every outline") {
  int placed = 0, wanted = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    CAPTURE(seed);
    const Case c = random_case(seed);
    const auto spots = place_labels(c.requests, c.field);
    REQUIRE(spots.size() == c.requests.size());
    for (std::size_t i = 0; i < spots.size(); ++i) {
      ++wanted;
      if (!spots[i].placed) continue;
      ++placed;
      const Box& label = spots[i].box;
      for (const Vec2 p : label.corners()) {
        CHECK((p.x >= -1e-9 && p.y >= -1e-9));
        CHECK((p.x <= c.field.page.max.x + 1e-9 && p.y <= c.field.page.max.y + 1e-9));
      }
      CHECK(label.front.x >= -1e-9);  // never upside down
      for (const Box& taken : c.field.taken) CHECK(separation(label, taken).depth <= 1e-9);
      for (std::size_t j = 0; j < spots.size(); ++j) {
        if (j == i || !spots[j].placed) continue;
        CHECK(separation(label, spots[j].box).depth <= 1e-9);
        if (!spots[j].inside)
          CHECK(separation(label, leader_box(spots[j].leader_from, spots[j].leader_to)).depth <= 1e-9);
      }
      if (spots[i].inside)
        CHECK(holds(c.requests[i].box, label));
      else
        CHECK(separation(label, c.requests[i].box).depth <= 1e-9);
      for (std::size_t j = 0; j < c.field.obstacles.size(); ++j) {
        const Obstacle& o = c.field.obstacles[j];
        if (j == i || (spots[i].inside && j < i)) continue;
        CHECK((separation(label, o.box).depth <= 1e-9 || (o.ground && holds(o.box, label))));
      }
    }
  }
  // Random clutter is far worse than any room; most labels still find a place.
  CHECK(placed > wanted / 2);
}

TEST_CASE("a label that fits lies in the middle of its box and upright") {
  LabelField field;
  field.page.add({0, 0});
  field.page.add({400, 400});
  const Box box{{200, 150}, direction(core::kPi / 2), 30, 60};
  field.obstacles.push_back({box});
  const LabelRequest request{box, {{50, 14}}, 0};
  const auto spots = place_labels(std::span(&request, 1), field);
  REQUIRE(spots[0].placed);
  CHECK(spots[0].inside);
  CHECK(spots[0].box.center == box.center);
  CHECK(spots[0].box.front == Vec2{1, 0});
}

TEST_CASE("a label too wide is turned along its box and one too large goes beside it") {
  LabelField field;
  field.page.add({0, 0});
  field.page.add({400, 400});
  const Box box{{200, 200}, {1, 0}, 12, 60};  // narrow and tall
  field.obstacles.push_back({box});
  LabelRequest request{box, {{80, 14}}, 0};
  auto spots = place_labels(std::span(&request, 1), field);
  REQUIRE(spots[0].inside);
  CHECK(std::abs(spots[0].box.front.y) == doctest::Approx(1));
  request.shapes = {{200, 14}};
  spots = place_labels(std::span(&request, 1), field);
  REQUIRE(spots[0].placed);
  CHECK_FALSE(spots[0].inside);
  CHECK(box.contains(spots[0].leader_to));
}

TEST_CASE("where there is no room nothing is placed") {
  LabelField field;
  field.page.add({0, 0});
  field.page.add({50, 50});
  const LabelRequest request{{{25, 25}, {1, 0}, 5, 5}, {{80, 14}}, -1};
  CHECK_FALSE(place_labels(std::span(&request, 1), field)[0].placed);
  CHECK(place_labels({}, field).empty());
}
