#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/rng.h"
#include "io/formats/priors_json.h"
#include "io/formats/priors_members.h"

using namespace inhabit::io;

namespace {

/// Random priors in which every member occurs; angles are such as a file can hold.
class RandomPriors {
 public:
  explicit RandomPriors(std::uint64_t seed) : rng_(seed) {}

  Priors make() {
    Priors p;
    p.weights = {.visibility = rng_.uniform(), .pair_angle = rng_.uniform(0, 100)};
    for (int i = 0; i < 3; ++i) p.rooms.push_back("room \"" + std::to_string(i));
    for (int i = 0; i < 4; ++i) p.kinds.push_back(kind(i));
    for (int i = 0; i < 3; ++i) p.pairs.push_back(pair(i));
    p.extras = {{"x-note", "{\"a\": [1, 2]}"}};
    return p;
  }

 private:
  double angle() { return radians(std::round(rng_.uniform(-180, 180) * 1e9) / 1e9); }
  double turn() { return std::abs(angle()); }

  KindPrior kind(int i) {
    KindPrior k;
    k.kind = "kind " + std::string(1, static_cast<char>('a' + i));
    k.count = static_cast<int>(rng_.index(9)), k.rooms = k.count / 2;
    k.back = static_cast<Face>(rng_.index(4)), k.back_share = rng_.uniform();
    for (int n = 9; n > 6 && rng_.index(2) == 0; --n) k.wall.push_back({rng_.uniform(0, 4), angle(), 0.1, turn(), n});
    if (i > 0) k.support.push_back({Mount::floor, "kind a", 2});
    if (i < 3) k.support.push_back({static_cast<Mount>(rng_.index(3)), "", 1});
    k.access = {rng_.uniform(), 0, rng_.uniform(), 0.6};
    if (rng_.index(2) == 0) k.view = View{rng_.uniform(1, 3), turn()};
    k.elevation = rng_.uniform(0, 2), k.by_hand = rng_.index(2) == 0;
    return k;
  }

  PairPrior pair(int i) {
    PairPrior p;
    p.first = "kind a", p.second = "kind " + std::string(1, static_cast<char>('a' + i));
    p.modes.push_back({rng_.uniform(0, 4), angle(), angle(), 0.1, turn(), turn(), 5});
    p.modes.push_back({rng_.uniform(0, 4), angle(), angle(), 0.1, turn(), turn(), 1});
    p.per_first = rng_.uniform(0, 5), p.concentric = rng_.index(2) == 0;
    p.count = 6, p.rooms = 3, p.spread = rng_.uniform(), p.by_hand = rng_.index(2) == 0;
    return p;
  }

  Rng rng_;
};

std::string error_of(std::string_view text) {
  const Result<Priors> priors = read_priors(text);
  return priors.ok() ? "no error" : priors.error().text();
}

}  // namespace

TEST_CASE("priors: writing then reading is the identity and the bytes stay the same") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    const Priors priors = RandomPriors(seed).make();
    const std::string text = write_priors(priors);
    const Result<Priors> again = read_priors(text);
    REQUIRE_MESSAGE(again.ok(), again.error().text());
    CHECK(*again == priors);
    CHECK(write_priors(*again) == text);
  }
}

TEST_CASE("priors: what a person writes is little") {
  const Result<Priors> priors = read_priors(R"({"kinds": [
    {"kind": "bed", "by_hand": true, "wall": [{"distance": 0.02}], "access": {"left": 0.5}},
    {"kind": "armchair", "wall": [{"distance": 0.5, "angle": 30}, {"distance": 1, "count": 3}]}]})");
  REQUIRE(priors.ok());
  CHECK(priors->weights == CostWeights{});
  REQUIRE(priors->kinds.size() == 2);
  CHECK(priors->kinds[0].kind == "armchair");
  CHECK(priors->kinds[0].wall[0].distance == 1);  // the most frequent first
  CHECK(priors->kinds[0].wall[1].angle == doctest::Approx(radians(30)).epsilon(1e-12));
  CHECK(priors->of("bed")->access == std::array{0.0, 0.5, 0.0, 0.0});
  CHECK(priors->of("bed")->wall[0].count == 1);
  CHECK(write_priors(*priors).find("\"wall_angle\": 10") != std::string::npos);
}

TEST_CASE("priors: errors name the place and the nearest known key") {
  CHECK(error_of("[]").find("a priors file is an object") != std::string::npos);
  CHECK(error_of(R"({"format": "inhabit-scene"})").starts_with("/format: is not \"inhabit-priors\""));
  CHECK(error_of(R"({"space": {}})").find("this is a scene") != std::string::npos);
  CHECK(error_of(R"({"version": 2})").find("newer inhabit") != std::string::npos);
  CHECK(error_of(R"({"knids": []})") == "/knids: unknown key; did you mean \"kinds\"?");
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "acess": {}}]})")
            .starts_with("/kinds/0/acess: unknown key; did you mean \"access\""));
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "access": {"top": 1}}]})")
            .starts_with("/kinds/0/access/top: unknown key"));
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "wall": [{"distance": "near"}]}]})")
            .starts_with("/kinds/0/wall/0/distance: is a text"));
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "wall": [{"distance": 1, "angle": 400}]}]})").find("degrees") !=
        std::string::npos);
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "wall": [{"distance": 1, "count": 0}]}]})").find("outside [1") !=
        std::string::npos);
  CHECK(error_of(R"({"kinds": [{"kind": ""}]})") == "/kinds/0/kind: is empty");
  CHECK(error_of(R"({"kinds": [{"kind": "bed", "back": "bottom"}]})").find("none of: back, left, front, right") !=
        std::string::npos);
  CHECK(error_of(R"({"weights": {"wall_angle": -1}})").starts_with("/weights/wall_angle"));
}

TEST_CASE("priors that contradict themselves are errors") {
  CHECK(error_of(R"({"kinds": [{"kind": "bed"}, {"kind": "bed"}]})").find("there already, in /kinds/0") !=
        std::string::npos);
  CHECK(error_of(R"({"kinds": [{"kind": "tv", "support": [{"on": "tv"}]}]})").find("cannot carry itself") !=
        std::string::npos);
  CHECK(error_of(R"({"kinds": [{"kind": "a", "support": [{"on": "b"}]}, {"kind": "b", "support": [{"on": "a"}]}]})")
            .find("which stands on a a") != std::string::npos);
  CHECK(error_of(
            R"({"kinds": [{"kind": "a", "support": [{"on": "b"}]}, {"kind": "b", "support": [{"on": "a"}, {}]}]})") ==
        "no error");
  CHECK(error_of(R"({"kinds": [{"kind": "a", "support": [{"on": "b", "mount": "wall"}]}]})").find("both hangs") !=
        std::string::npos);
  CHECK(error_of(R"({"pairs": [{"first": "a", "second": "b", "modes": []}]})").starts_with("/pairs/0/modes"));
  constexpr std::string_view kTwice =
      R"({"pairs": [{"first": "a", "second": "b", "modes": [{"distance": 1}]}, {"first": "a", "second": "b", "modes": [{"distance": 2}]}]})";
  CHECK(error_of(kTwice).find("there already, in /pairs/0") != std::string::npos);
  constexpr std::string_view kTurned =
      R"({"pairs": [{"first": "a", "second": "b", "modes": [{"distance": 1}]}, {"first": "b", "second": "a", "modes": [{"distance": 2}]}]})";
  CHECK(error_of(kTurned).find("the other way round") != std::string::npos);
}

TEST_CASE("priors: the reference page names every member") {
  std::ifstream file(std::string(INHABIT_SOURCE_DIR) + "/docs/priors.md");
  std::ostringstream page;
  page << file.rdbuf();
  const auto named = [&]<class T>(std::type_identity<T>) {
    for_each_member<T>([&](std::string_view name, auto, const Spec&) {
      CAPTURE(std::string(name));
      CHECK(page.str().find("`" + std::string(name) + "`") != std::string::npos);
    });
  };
  named(std::type_identity<Priors>{});
  named(std::type_identity<KindPrior>{});
  named(std::type_identity<WallMode>{});
  named(std::type_identity<Support>{});
  named(std::type_identity<PairPrior>{});
  named(std::type_identity<PairMode>{});
  named(std::type_identity<CostWeights>{});
}
