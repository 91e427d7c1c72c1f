#include "io/formats/scene_schema.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "core/test_data.h"
#include "io/formats/scene_json.h"
#include "io/scene_examples.h"

using namespace inhabit::io;

namespace {

void check_document(const std::string& name, const std::string& text) {
  const std::string path = std::string(INHABIT_SOURCE_DIR) + "/docs/" + name;
  if (std::getenv("INHABIT_UPDATE_DOCS") != nullptr) std::ofstream(path, std::ios::binary) << text;
  std::ostringstream file;
  file << std::ifstream(path, std::ios::binary).rdbuf();
  CHECK_MESSAGE(file.str() == text, "docs/", name, " is out of date; run the tests once with INHABIT_UPDATE_DOCS=1");
}

/// What the schema alone says.
class SchemaCheck {
 public:
  SchemaCheck() {
    const auto document = nlohmann::json::parse(scene_schema());
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }
  bool accepts(const nlohmann::json& scene) const { return why_not(scene).empty(); }
  std::string why_not(const nlohmann::json& scene) const {
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    valijson::ValidationResults results;
    if (validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(scene), &results)) return "";
    std::string text = "refused";
    for (const auto& error : results) {
      text += "\n";
      for (const std::string& part : error.context) text += part;
      text += ": " + error.description;
    }
    return text;
  }

 private:
  valijson::Schema schema_;
};

using Json = nlohmann::json;

/// Calls f with every value of the document, from the root down.
template <class F>
void for_each_value(const Json& at, const Json::json_pointer& where, F&& f) {
  f(where);
  if (at.is_object()) {
    for (const auto& [key, value] : at.items()) for_each_value(value, where / key, f);
  } else if (at.is_array()) {
    for (std::size_t i = 0; i < at.size(); ++i) for_each_value(at[i], where / i, f);
  }
}

}  // namespace

TEST_CASE("the schema in docs is the one that the tables give") { check_document("scene.schema.json", scene_schema()); }

TEST_CASE("the page of constraints in docs is the one that the tables give") {
  check_document("constraints.md", constraints_page());
}

TEST_CASE("the page of crowd models in docs is the one that the tables give") {
  check_document("crowd-models.md", crowd_models_page());
}

TEST_CASE("what the reader accepts the schema accepts and what the schema refuses the reader refuses") {
  const SchemaCheck schema;
  Json full = Json::parse(kFullScene);
  full["seed"] = 7;  // the validator holds integers in 63 bits, the reader in 64
  CHECK(schema.why_not(full) == "");
  CHECK(schema.why_not(Json::parse(write_scene(*read_scene(full.dump())))) == "");
  // Every value of a good document, replaced by values that do not belong there, or taken away, or joined by an unknown
  // one.
  const std::vector<Json> foreign = {nullptr,       true,           -1,     1.5,         20000000, "x", "",
                                     Json::array(), Json::object(), {1, 2}, {{"x-a", 1}}};
  std::size_t refused = 0, stricter = 0, accepted = 0, met = 0;
  // Under a sanitizer the validator takes minutes: then every seventh, so that every place still meets something
  // foreign and every foreign value some place.
  constexpr std::size_t kEvery = inhabit::core::kSlowBuild ? 7 : 1;
  const auto compare = [&](const Json& scene, const std::string& where) {
    if (met++ % kEvery != 0) return;
    const bool by_schema = schema.accepts(scene), by_reader = read_scene(scene.dump()).ok();
    CHECK_MESSAGE((by_schema || !by_reader), where, ": only the schema refuses ", scene.dump());
    ++(by_schema ? (by_reader ? accepted : stricter) : refused);
  };
  for_each_value(full, Json::json_pointer(), [&](const Json::json_pointer& where) {
    if (where.to_string().find("/x-") != std::string::npos || where.to_string().starts_with("/x-")) return;
    for (const Json& value : foreign) {
      Json scene = full;
      scene[where] = value;
      compare(scene, where.to_string());
    }
    Json scene = full;
    if (scene[where].is_object()) scene[where]["surprise"] = 1, compare(scene, where.to_string());
    if (where.empty()) return;
    scene = full;
    Json& parent = scene[where.parent_pointer()];
    parent.is_object() ? parent.erase(where.back()) : (parent.erase(std::stoul(where.back())), 0);
    compare(scene, where.to_string() + " taken away");
  });
  MESSAGE(refused, " refused by both, ", stricter, " by the reader alone (names, geometry), ", accepted, " accepted");
  CHECK(refused > 2000 / kEvery);
}

TEST_CASE("the reader alone refuses only names and geometry") {
  const SchemaCheck schema;
  // Form: both refuse.
  for (
      const char* bad :
      {R"({})", R"({"space": {"outline": [[0, 0], [1, 0]]}})", R"({"space": 1})",
       R"({"space": {"outline": [[0, 0], [1, 0], [0, 1]], "height": -1}})",
       R"({"space": {"outline": [[0, 0], [1, 0], [0, 1]]}, "seed": 1.5})",
       R"({"space": {"outline": [[0, 0], [1, 0], [0, 1]]}, "constraints": [{"type": "distance", "between": ["a", "b"]}]})",
       R"({"space": {"outline": [[0, 0], [1, 0], [0, 1]]}, "objects": [{"id": "a", "angle": 361}]})"}) {
    CHECK_FALSE(schema.accepts(Json::parse(bad)));
    CHECK_FALSE(read_scene(bad).ok());
  }
  // Names and geometry: the reader's part.
  for (const char* bad : {R"({"space": {"outline": [[0, 0], [1, 1], [1, 0], [0, 1]]}})",
                          R"({"space": {"outline": [[0, 0], [1, 0], [0, 1]]}, "objects": [{"id": "a", "on": "b"}]})"}) {
    CHECK(schema.accepts(Json::parse(bad)));
    CHECK_FALSE(read_scene(bad).ok());
  }
}
