#include "session/jobs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "session/paper_scenes.h"

using namespace inhabit;
using namespace inhabit::session;

namespace {

Document document_of(Scene scene) {
  Document document;
  document.scenes.push_back(std::move(scene));
  return document;
}

}  // namespace

TEST_CASE("a furnish job places everything and says how well") {
  FurnishJob job;
  job.layout.starts = 2;
  job.layout.trace = true;
  const Document document = document_of(living_room());
  const Result<Furnished> furnished = furnish_job(document, job);
  REQUIRE(furnished.ok());
  REQUIRE(furnished->rooms.size() == 1);
  const Document placed = furnished->document(document);
  for (const Object& object : placed.scenes[0].objects) CHECK(object.position.has_value());
  CHECK(furnished->feasible() == furnished->rooms[0].suggestions[0].report.feasible);
  CHECK(furnish_text(*furnished).find("living-room") != std::string::npos);
  const auto json = nlohmann::json::parse(furnish_json(*furnished, true));
  CHECK(json["rooms"][0]["suggestions"][0]["scene"]["objects"].size() == 10);
  const std::string csv = trace_csv(furnished->rooms[0].trace);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == static_cast<long>(furnished->rooms[0].trace.size()) + 1);
}

TEST_CASE("a room that cannot be furnished is an error alone and a note among others") {
  Scene hopeless = bedroom();
  hopeless.objects[0].on = {Ref::Kind::object, 0};  // it stands on itself
  CHECK_FALSE(furnish_job(document_of(hopeless), {}).ok());
  Document two = document_of(hopeless);
  two.scenes.push_back(living_room());
  const Result<Furnished> furnished = furnish_job(two, {});
  REQUIRE(furnished.ok());
  CHECK(furnished->rooms[0].error.has_value());
  CHECK_FALSE(furnished->feasible());
  CHECK(furnished->document(two).scenes[0].objects[0].position.has_value() == false);
  CHECK(furnished->document(two).scenes[1].objects[0].position.has_value());
}

TEST_CASE("checks of one scene and of several differ in form alone") {
  const Document one = document_of(bedroom());
  Document two = one;
  two.scenes.push_back(living_room());
  CHECK(nlohmann::json::parse(check_json(check_job(one, {}))).contains("overlaps"));
  const auto json = nlohmann::json::parse(check_json(check_job(two, {})));
  CHECK(json["rooms"].size() == 2);
  CHECK(json["rooms"][1]["name"] == "living-room");
}
