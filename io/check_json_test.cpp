#include "io/check_json.h"

#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>

using namespace inhabit;
using layout::CheckReport;

namespace {

CheckReport sample() {
  CheckReport r;
  r.overlaps = {{"bed", "table", 0.12}, {"chair-1", "Küchentisch", 0.004}};
  r.overlap_count = 2;
  r.outside = {{"lamp", std::numeric_limits<double>::infinity()}, {"bed", 0.05}};
  r.missing = 1;
  r.blocked_doors = {{"door", 0.25}};
  r.clearances = {{"bed", "left", 0.5}};
  r.views = {{"tv", 0.1}};
  r.reachable = {0.75, {"plant"}};
  r.constraints = {{"distance", "m", 3, 0.01, 0.4, 0.4}, {"orientation", "deg", 1, 12, 12, 12}};
  r.violations = {{"distance", {"bed", "lamp"}, 0.4, "m", "distance bed – lamp: 0.40 m too far"}};
  r.energy = 1.5;
  return r;
}

}  // namespace

TEST_CASE("the JSON of a check has the documented keys in the documented order") {
  const auto json = nlohmann::ordered_json::parse(io::check_json(sample()));
  const std::vector<std::string> expected = {"feasible",  "overlaps",       "outside", "blocked_doors", "clearances",
                                             "reachable", "walkable_share", "views",   "constraints",   "energy"};
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  REQUIRE(keys.size() >= expected.size());
  keys.resize(expected.size());
  CHECK(keys == expected);
  CHECK(json["overlaps"][0]["a"] == "bed");
  CHECK(json["overlaps"][0]["depth"] == 0.12);
  CHECK(json["outside"][0]["depth"].is_null());
  CHECK(json["blocked_doors"][0]["share"] == 0.25);
  CHECK(json["clearances"][0]["face"] == "left");
  CHECK(json["reachable"]["unreachable"][0] == "plant");
  CHECK(json["constraints"][1]["unit"] == "deg");
  CHECK(json["violations"][0]["between"].size() == 2);
  CHECK_FALSE(json.contains("published"));
}

TEST_CASE("published measures stand under their sources beside the objects asked and placed") {
  CheckReport r;
  r.published = layout::PublishedMetrics{
      4, 3, {{"ReSpace", "oob", 0.5, "m3"}, {"PhyScene", "walkable_doors", {}, ""}}, {{"x", "y"}}};
  const auto json = nlohmann::json::parse(io::check_json(r));
  CHECK(json["published"]["asked"] == 4);
  CHECK(json["published"]["placed"] == 3);
  CHECK(json["published"]["ReSpace"]["oob [m3]"] == 0.5);
  CHECK(json["published"]["PhyScene"]["walkable_doors"].is_null());
  CHECK(json["published"]["left_out"][0]["why"] == "y");
}

TEST_CASE("an id that is no UTF-8 still gives JSON") {
  CheckReport r;
  r.reachable.unreachable = {
      "K\xfc"
      "che"};
  CHECK(nlohmann::json::accept(io::check_json(r)));
}

TEST_CASE("the table aligns names with umlauts and says what is wrong") {
  const std::string text = io::check_table(sample());
  CHECK(text.find("✗  feasible") != std::string::npos);
  CHECK(text.find("  bed      table        0.120 m\n") != std::string::npos);
  CHECK(text.find("  chair-1  Küchentisch  0.004 m\n") != std::string::npos);
  CHECK(text.find("lamp  missing") != std::string::npos);
  CHECK(text.find("distance bed – lamp: 0.40 m too far") != std::string::npos);
}

TEST_CASE("the table of a good room has no cross and long lists are cut") {
  CheckReport good;
  good.feasible = true;
  CHECK(io::check_table(good).find("✗") == std::string::npos);
  CheckReport bad;
  bad.reachable.unreachable.assign(25, "chair");
  CHECK(io::check_table(bad).find("… and 15 more") != std::string::npos);
  bad.reachable.share = 0.9997;
  CHECK(io::check_table(bad).find("all but 25 objects") != std::string::npos);
  CHECK(io::check_table(bad).find("100.0 %  ") == std::string::npos);
}
