#include "session/table.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

using namespace inhabit::session;

TEST_CASE("a table aligns numbers to the right and text to the left") {
  const Table table{"t", "Times", {{"scene"}, {"ms", 1}}, {{"a", 1.25}, {"longer", 100.0}, {"b", {}}}, {"a note"}};
  CHECK(table_text(table) ==
        "Times\n"
        "scene      ms\n"
        "a         1.2\n"
        "longer  100.0\n"
        "b           -\n"
        "a note\n");
}

TEST_CASE("a table as JSON keeps every digit and null for nothing") {
  const Table table{
      "t", "", {{"scene"}, {"ms", 1}, {"ok"}}, {{"a", 1.25, Cell::truth(true)}, {"b", {}, Cell::truth(false)}}, {}};
  const auto json = nlohmann::json::parse(table_json(table));
  CHECK(json["rows"][0]["ms"] == 1.25);
  CHECK(json["rows"][0]["ok"] == true);
  CHECK(json["rows"][1]["ms"].is_null());
}

TEST_CASE("quantiles are those of the sorted values") {
  CHECK(median({}) == 0);
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 2, 3}) == 2.5);
  CHECK(quantile({5, 1, 2, 3, 4}, 0.95) == 5);
  std::vector<double> hundred;
  for (int i = 1; i <= 100; ++i) hundred.push_back(i);
  CHECK(quantile(hundred, 0.95) == 95);
}
