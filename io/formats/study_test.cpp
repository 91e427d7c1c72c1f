#include "io/formats/study.h"

#include <doctest/doctest.h>

using namespace inhabit::io;
using namespace inhabit::scene;

namespace {

std::string trouble(std::string_view text) {
  const auto data = read_study_data(text);
  return data ? "" : data.error().text();
}
std::string plan_trouble(std::string_view text) {
  const auto plan = read_study_plan(text);
  return plan ? "" : plan.error().text();
}

}  // namespace

TEST_CASE("answers are read as the page writes them and survive writing") {
  const auto data = read_study_data(
      R"({"format": "inhabit-answers", "version": 1, "study": "0f", "title": "Which?", "participants": [
        {"id": "00ab", "answers": [{"scene": "bedroom", "synthesis": "A1", "human": "left", "chosen": "right", "seconds": 2.5}]}]})");
  REQUIRE(data.ok());
  REQUIRE(data->participants.size() == 1);
  CHECK(data->participants[0].answers[0] == StudyAnswer{"bedroom", "A1", Side::left, Side::right, 2.5});
  CHECK_FALSE(data->participants[0].answers[0].chose_human());
  const auto again = read_study_data(write_study_data(*data));
  REQUIRE(again.ok());
  CHECK(*again == *data);
}

TEST_CASE("counts are read from JSON and from CSV with columns in any order") {
  const auto json = read_study_data(R"({"counts": [{"scene": "a, b", "synthesis": "A1", "human": 31, "of": 50}]})");
  const auto csv = read_study_data("\xef\xbb\xbfof,note,human,synthesis,scene\r\n50,,31,A1,\"a, b\"\r\n\r\n");
  REQUIRE(json.ok());
  REQUIRE(csv.ok());
  CHECK(json->counts == std::vector<StudyCount>{{"a, b", "A1", 31, 50}});
  CHECK(csv->counts == json->counts);
  CHECK(read_study_data("scene,synthesis,human,of\n" + csv_field("q\"x") + ",A,0,1")->counts[0].scene == "q\"x");
}

TEST_CASE("wrong answers and counts say where") {
  CHECK(trouble("") == "is empty");
  CHECK(trouble("scene,human,of\n").starts_with("line 1: no column \"synthesis\""));
  CHECK(trouble("scene,synthesis,human,of\n") == "has no counts below its head");
  CHECK(trouble("scene,synthesis,human,of\na,b,3,2\n").starts_with("line 2: chosen 3 times of 2"));
  CHECK(trouble("scene,synthesis,human,of\na,b,-1,2\n").starts_with("line 2: \"-1\" is no count"));
  CHECK(trouble("scene,synthesis,human,of\na,b,0,0\n").starts_with("line 2: \"0\" is no count for \"of\""));
  CHECK(trouble("scene,synthesis,human,of\na,b,1\n").starts_with("line 2: has 3 fields instead of 4"));
  CHECK(trouble("scene,synthesis,human,of\na,b,1,2\na,b,1,2\n").starts_with("line 3: "));
  CHECK(trouble("scene,synthesis,human,of\n\"a,b,1,2\n").starts_with("line 2: a quotation mark"));
  CHECK(trouble("{\"counts\": [{\"scene\": \"a\", \"synthesis\": \"b\", \"human\": 3, \"of\": 2}]}")
            .starts_with("/counts/0/human: "));
  CHECK(trouble("{\"counts\": [{\"scene\": \"a\", \"synthesis\": \"b\", \"human\": 0.5, \"of\": 2}]}")
            .starts_with("/counts/0/human: 0.5 is no whole number"));
  CHECK(trouble("{}").find("needs exactly one of: participants, counts") != std::string::npos);
  CHECK(trouble("{\"scenes\": []}").find("plan") != std::string::npos);
  CHECK(trouble("{\"participants\": [{\"id\": \"a\", \"answers\": []}, {\"id\": \"a\", \"answers\": []}]}")
            .starts_with("/participants/1/id: "));
  CHECK(trouble("{\"participants\": [{\"id\": \"a\", \"answers\": [{\"scene\": \"s\", \"synthesis\": \"A\", \"human\": "
                "\"left\", \"chosen\": \"lef\"}]}]}")
            .find("/participants/0/answers/0/chosen: ") == 0);
}

TEST_CASE("a plan names one or several views a plate and its faults have places") {
  const auto plan = read_study_plan(
      R"({"title": "t", "scenes": [{"name": "bedroom", "human": "h.png", "syntheses": {"A2": ["a.png"], "A1": "b.json"}}]})");
  REQUIRE(plan.ok());
  CHECK(plan->scenes[0].human == std::vector<std::string>{"h.png"});
  CHECK(plan->scenes[0].syntheses[0].name == "A2");
  CHECK(plan->scenes[0].syntheses[1].pictures == std::vector<std::string>{"b.json"});
  CHECK(plan_trouble(R"({"scenes": []})").starts_with("/scenes: "));
  CHECK(plan_trouble(R"({"scenes": [{"name": "a", "human": [], "syntheses": {"A": "x"}}]})")
            .starts_with("/scenes/0/human: "));
  CHECK(plan_trouble(R"({"scenes": [{"name": "a", "human": "x", "syntheses": {}}]})")
            .starts_with("/scenes/0/syntheses: "));
  CHECK(plan_trouble(R"({"scenes": [{"name": "a", "human": "x"}]})").find("\"syntheses\" is missing") !=
        std::string::npos);
  CHECK(plan_trouble(R"({"scenes": [{"name": "a", "humans": "x"}]})").find("did you mean \"human\"") !=
        std::string::npos);
  CHECK(plan_trouble(R"({"space": {}})").find("scene") != std::string::npos);
}
