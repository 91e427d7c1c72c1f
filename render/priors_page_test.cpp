#include "render/priors_page.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace inhabit::render;
using namespace inhabit::scene;

namespace {

std::string words(const Drawing& drawing) {
  std::string all;
  for (const auto& item : drawing.items)
    if (const Text* text = std::get_if<Text>(&item)) all += text->text + "\n";
  return all;
}

/// How many circles of a sample's size there are: a closed path whose bounds are a square of this side.
int circles(const Drawing& drawing, double diameter) {
  int n = 0;
  for (const auto& item : drawing.items) {
    const Shape* shape = std::get_if<Shape>(&item);
    if (shape == nullptr || !shape->style.fill) continue;
    Bounds b;
    for (const Vec2 p : shape->path.points) b.add(p);
    n += std::abs(b.size().x - diameter) < 0.01 && std::abs(b.size().y - diameter) < 0.01;
  }
  return n;
}

bool on_page(const Drawing& drawing) {
  for (const auto& item : drawing.items)
    if (const Shape* shape = std::get_if<Shape>(&item))
      for (const Vec2 p : shape->path.points)
        if (!(p.x >= -1 && p.y >= -1 && p.x <= drawing.size.x + 1 && p.y <= drawing.size.y + 1)) return false;
  return true;
}

}  // namespace

TEST_CASE("a kind's card says what was learned and stays on its page") {
  KindPrior prior;
  prior.kind = "armchair", prior.count = 4, prior.rooms = 3;
  prior.wall = {{0.5, 0.3, 0.1, 0.2, 3}, {-0.2, 3.1, 0, 0, 1}};
  prior.support = {{Mount::floor, "", 3}, {Mount::floor, "rug", 1}};
  prior.access = {0, 0, 0.6, 0};
  KindEvidence evidence;
  evidence.wall = {{0.4, 0.2, 0, 0}, {0.5, 0.3, 1, 0}, {0.6, 0.4, 2, 0}, {-0.2, 3.1, 2, 1}};
  const Drawing card = draw_kind_card(prior, evidence);
  CHECK(on_page(card));
  const std::string text = words(card);
  CHECK(text.find("4 examples in 3 rooms · on the floor (3), on a rug (1) · reached at front 0.60 m") != text.npos);
  CHECK(text.find("3: 0.50 m, 17°") != text.npos);
}

TEST_CASE("what a person wrote has a card without examples") {
  KindPrior prior;
  prior.kind = "throne", prior.by_hand = true, prior.wall = {{1, 0, 0, 0, 1}};
  CHECK(on_page(draw_kind_card(prior, {})));
  PairPrior pair;
  pair.first = pair.second = "throne", pair.modes = {{1, 0, 0, 0, 0, 0, 1}}, pair.by_hand = true;
  CHECK(on_page(draw_pair_card(pair, {})));
}

TEST_CASE("a pair's card has a dot for every example") {
  PairPrior pair;
  pair.first = "table", pair.second = "chair", pair.modes = {{0.8, 0, 0, 0.1, 3.14159, 0, 12}}, pair.concentric = true;
  pair.count = 12, pair.rooms = 1, pair.per_first = 4;
  PairEvidence evidence{{}, {1, 1}, {0.5, 0.5}};
  for (int k = 0; k < 12; ++k) evidence.samples.push_back({0.8, 0.5 * k, 0, 0, 0, k / 4});
  const Drawing card = draw_pair_card(pair, evidence);
  CHECK(on_page(card));
  CHECK(circles(card, 6.4) == 12);
  CHECK(words(card).find("concentric, proposed") != std::string::npos);
}

TEST_CASE("one page has a card for everything") {
  Priors priors;
  std::vector<KindEvidence> kinds(5);
  for (int i = 0; i < 5; ++i) {
    KindPrior prior;
    prior.kind = "kind " + std::string(1, static_cast<char>('a' + i));
    prior.count = i;
    priors.kinds.push_back(prior);
  }
  const Drawing page = draw_priors(priors, kinds, {}, "What was learned");
  CHECK(on_page(page));
  const std::string text = words(page);
  CHECK(text.find("kind e") < text.find("kind a"));  // the most frequent first
}
