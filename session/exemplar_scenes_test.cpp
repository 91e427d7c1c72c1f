#include "session/exemplar_scenes.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "exemplar/learn.h"
#include "io/file.h"
#include "io/formats/scene_json.h"
#include "layout/check.h"
#include "session/document.h"

using namespace inhabit::session;

namespace {

int count_kind(const Scene& scene, std::string_view kind) {
  int n = 0;
  for (const Object& o : scene.objects) n += o.kind == kind;
  return n;
}

/// What is wrong with a furnished room, for messages; empty when nothing is.
std::string complaints(const Scene& scene) {
  const inhabit::layout::CheckReport report = inhabit::layout::check(scene, {.threads = 1});
  std::string text;
  for (const auto& o : report.overlaps) text += o.a + " overlaps " + o.b + "; ";
  for (const auto& o : report.outside) text += o.id + " is outside; ";
  for (const auto& d : report.blocked_doors) text += d.id + " is blocked; ";
  for (const auto& v : report.views) text += "the view of " + v.id + " is blocked; ";
  for (const std::string& id : report.reachable.unreachable) text += id + " is out of reach; ";
  return text;
}

void check_file(const Scene& scene, const std::string& file) {
  const std::string path = std::string(INHABIT_SOURCE_DIR) + "/scenes/" + file + ".json";
  const std::string text = inhabit::io::write_scene(scene);
  CAPTURE(path);
  if (std::getenv("INHABIT_UPDATE_DOCS") != nullptr) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  const auto bytes = inhabit::io::read_file(path);
  REQUIRE(bytes.ok());
  CHECK_MESSAGE(*bytes == text, "out of date; run the tests once with INHABIT_UPDATE_DOCS=1");
}

}  // namespace

TEST_CASE("the seven scenes have the paper's numbers of objects in every room") {
  CHECK(exemplar_scenes().size() == 7);
  for (const ExemplarScene& scene : exemplar_scenes()) {
    CAPTURE(scene.name);
    for (int k = 1; k <= kExemplars + scene.inputs; ++k) {
      CAPTURE(k);
      CHECK(static_cast<int>(scene.build(k).objects.size()) == scene.objects);
    }
  }
}

TEST_CASE("every exemplar room is feasible with free doors and everything within reach") {
  for (const ExemplarScene& scene : exemplar_scenes()) {
    for (int k = 1; k <= kExemplars + scene.inputs; ++k) {
      CAPTURE(scene.name);
      CAPTURE(k);
      CHECK(complaints(scene.build(k)) == "");
    }
  }
}

TEST_CASE("the files of the seven scenes are what is built") {
  for (const ExemplarScene& scene : exemplar_scenes()) {
    for (int k = 1; k <= kExemplars; ++k)
      check_file(exemplar_room(scene, k), "exemplar/" + std::string(scene.name) + "-" + std::to_string(k));
    for (int k = 1; k <= scene.inputs; ++k) {
      const Scene input = exemplar_input(scene, k);
      for (const Object& o : input.objects) CHECK((!o.position && !o.angle));
      check_file(input, input.name);
    }
  }
}

TEST_CASE("from every scene its pairs are learned in all five rooms") {
  for (const ExemplarScene& scene : exemplar_scenes()) {
    CAPTURE(scene.name);
    std::vector<Scene> rooms;
    for (int k = 1; k <= kExemplars; ++k) rooms.push_back(exemplar_room(scene, k));
    inhabit::exemplar::LearnOptions options;
    for (const auto& [first, second] : scene.pairs) options.pairs.emplace_back(first, second);
    options.propose = false;
    const auto learned = inhabit::exemplar::learn(rooms, options);
    REQUIRE_MESSAGE(learned.ok(), learned.error().text());
    CHECK(learned->notes.empty());
    CHECK(learned->priors.pairs.size() == scene.pairs.size());
    for (const PairPrior& pair : learned->priors.pairs) CHECK(pair.rooms == kExemplars);
    const Scene input = exemplar_input(scene);
    for (const Object& o : input.objects) CHECK(learned->priors.of(prior_kind(o)) != nullptr);
  }
}

TEST_CASE("a set of exemplars opens by its name") {
  const auto set = open_document("exemplar/bedroom");
  REQUIRE(set.ok());
  CHECK(set->scenes.size() == 5);
  CHECK(open_document("exemplar/bedroom-2")->scenes.size() == 1);
  CHECK(open_document("exemplar/bedrom").error().text().find("did you mean") != std::string::npos);
  CHECK(count_kind(plan_restaurant(1), "dish set") == 20);
}
