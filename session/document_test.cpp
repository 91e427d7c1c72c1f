#include "session/document.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "io/file.h"
#include "io/formats/scene_json.h"
#include "session/paper_scenes.h"

using namespace inhabit;
using namespace inhabit::session;

TEST_CASE("every file in scenes equals its builder, and travels inside the program") {
  for (const PaperScene& paper : paper_scenes()) {
    CAPTURE(paper.name);
    const std::filesystem::path path =
        std::filesystem::path(INHABIT_SOURCE_DIR) / "scenes" / (std::string(paper.name) + ".json");
    const Result<std::string> bytes = io::read_file(path);
    REQUIRE(bytes.ok());
    CHECK(*bytes == io::write_scene(paper.build()));
    const Result<Document> builtin = open_document(std::string(paper.name));
    REQUIRE(builtin.ok());
    CHECK(io::write_scene(builtin->scenes.front()) == *bytes);
  }
  CHECK(builtin_scenes().size() >= paper_scenes().size());
}

TEST_CASE("an unknown name is answered with the nearest one") {
  const Result<Document> document = open_document("living-rom");
  REQUIRE_FALSE(document.ok());
  CHECK(document.error().message.find("living-room") != std::string::npos);
}

TEST_CASE("a format that holds one room refuses several") {
  Document document;
  document.scenes = {bedroom(), living_room()};
  const Result<std::string> bytes = write_document(document, "rooms.json");
  REQUIRE_FALSE(bytes.ok());
  CHECK(bytes.error().message.find("--room: bedroom, living-room") != std::string::npos);
  const std::vector<std::string> names = {"bedroom"};
  const Result<Document> one = only_rooms(document, names);
  REQUIRE(one.ok());
  CHECK(one->scenes.size() == 1);
  CHECK(write_document(*one, "room.JSON").ok());
  CHECK_FALSE(write_document(*one, "room.doc").ok());
  const std::vector<std::string> nobody = {"kitchen"};
  CHECK_FALSE(only_rooms(document, nobody).ok());
}
