#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "core/rng.h"
#include "io/formats/sweethome3d.h"
#include "io/formats/sweethome3d_archive.h"

using namespace inhabit;
using namespace inhabit::io;

namespace {

const std::string kSmallHome =
    "<?xml version='1.0'?>\n<home version='6400'>\n"
    "  <pieceOfFurniture name='Bed' x='300' y='100' width='90' depth='200' height='50'/>\n"
    "  <room><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/></room>\n</home>\n";

std::string zipped(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string archive;
  for (const auto& [name, content] : entries) {
    auto next = sh3d::with_entry(archive, name, content, {});
    REQUIRE_MESSAGE(next.ok(), next.error().text());
    archive = *next;
  }
  return archive;
}

std::string error_of(std::string bytes) {
  const auto home = open_sh3d(std::move(bytes));
  return home.ok() ? std::string() : home.error().text();
}

std::string with(const std::string& what, const std::string& by) {
  std::string text = kSmallHome;
  text.replace(text.find(what), what.size(), by);
  return text;
}

}  // namespace

TEST_CASE("a zip cut anywhere is one error and never a crash") {
  const std::string whole = zipped({{"Home.xml", kSmallHome}, {"0/bed.obj", std::string(3000, 'v')}});
  CHECK(error_of(whole).empty());
  for (std::size_t n = 0; n < whole.size(); n += 7) CHECK_FALSE(error_of(whole.substr(0, n)).empty());
}

TEST_CASE("a zip with any byte changed is read or refused") {
  const std::string whole = zipped({{"Home.xml", kSmallHome}, {"0", "x"}});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    const auto home = open_sh3d(changed);
    if (home) CHECK(read_rooms(*home).ok());
  }
}

TEST_CASE("zip bombs are refused before they unpack") {
  const std::string bomb = zipped({{"Home.xml", kSmallHome}, {"0", std::string(40 << 20, '\0')}});
  CHECK(error_of(bomb).find("zip bomb") != std::string::npos);
  // A megabyte that compresses three hundred times, seventy of them: no bomb by its ratio.
  core::Rng rng(3);
  std::string block(1 << 20, ' ');
  for (std::size_t i = 0; i < 4096; ++i) block[i] = static_cast<char>('a' + rng.index(26));
  std::string large = kSmallHome;
  for (int i = 0; i < 70; ++i) large.append("<!--").append(block).append("-->");
  CHECK(error_of(zipped({{"Home.xml", large}})).find("64 MiB") != std::string::npos);
}

TEST_CASE("entries with hostile names are harmless and kept") {
  const std::string evil = zipped({{"../../etc/passwd", "a"}, {"/root/x", "b"}, {"Home.xml", kSmallHome}});
  const auto home = open_sh3d(evil);
  REQUIRE(home.ok());
  CHECK(home->entries.size() == 3);
}

TEST_CASE("an old archive with only a Java home is named as such") {
  CHECK(error_of(zipped({{"Home", "\xac\xed"}})).find("Java") != std::string::npos);
  CHECK(error_of(zipped({{"readme", "?"}})).find("no Home.xml") != std::string::npos);
}

TEST_CASE("a stale Java home and its digests are dropped and other entries kept") {
  const std::string archive =
      zipped({{"Home", "java"}, {"ContentDigests", "old"}, {"Home.xml", kSmallHome}, {"7/bed.obj", "mesh"}});
  const auto home = open_sh3d(archive);
  auto scenes = rooms(*home);
  REQUIRE(scenes.ok());
  (*scenes)[0].objects.at(0).position->x += 0.5;
  const auto file = write_sh3d(*home, *scenes);
  REQUIRE_MESSAGE(file.ok(), file.error().text());
  const auto again = open_sh3d(file->bytes);
  REQUIRE(again.ok());
  CHECK(again->entries == std::vector<std::string>{"Home.xml", "7/bed.obj"});
  CHECK(*sh3d::read_entry(file->bytes, "7/bed.obj") == "mesh");
}

TEST_CASE("document types and entities of their own are refused and character references are read") {
  CHECK(error_of("<!DOCTYPE home [<!ENTITY a 'aaaa'>]>" + kSmallHome.substr(22)).find("DOCTYPE") != std::string::npos);
  CHECK(error_of(with("'Bed'", "'&lol;'")).find("entity") != std::string::npos);
  const auto home = open_sh3d(with("'Bed'", "'&amp;&#x42;'"));
  REQUIRE(home.ok());
  CHECK(rooms(*home)->at(0).objects.at(0).name == "&B");
}

TEST_CASE("wrong numbers are named with element and line and column") {
  CHECK(error_of(with("x='300'", "x='ten'")) == "Home.xml, line 3, column 4: <pieceOfFurniture> x='ten' is no number");
  CHECK(error_of(with("x='300'", "x='NaN'")).find("is no number") != std::string::npos);
  CHECK(error_of(with("x='300'", "x='Infinity'")).find("is no number") != std::string::npos);
  CHECK(error_of(with("x='300'", "x='1e400'")).find("is no number") != std::string::npos);
  CHECK(error_of(with("x='300'", "x='1e12'")).find("is outside") != std::string::npos);
  CHECK(error_of(with("width='90'", "width='-90'")).find("is outside") != std::string::npos);
  CHECK(error_of(with(" width='90'", "")).find("has no width") != std::string::npos);
  CHECK(error_of(with("<point x='400' y='0'/>", "<point x='400'/>")).find("<point> has no y") != std::string::npos);
}

TEST_CASE("what is no home is one clear error") {
  CHECK(error_of("").find("neither") != std::string::npos);
  CHECK(error_of("hello").find("neither") != std::string::npos);
  CHECK(error_of("<house/>").find("<home>") != std::string::npos);
  CHECK(error_of("<home>\n  <room").find("line 2") != std::string::npos);
  CHECK(error_of("<home name='\xff'/>").find("UTF-8") != std::string::npos);
  CHECK(error_of("<?xml version='1.0' encoding='ISO-8859-1'?><home/>").find("UTF-8") != std::string::npos);
  std::string deep = "<home>";
  for (int i = 0; i < 100; ++i) deep += "<furnitureGroup>";
  for (int i = 0; i < 100; ++i) deep += "</furnitureGroup>";
  CHECK(error_of(deep + "</home>").find("deeply") != std::string::npos);
}

TEST_CASE("rooms that are no polygons are repaired or left out with a warning") {
  const std::string bow = with("<point x='400' y='300'/>", "<point x='0' y='300'/><point x='400' y='300'/>");
  const auto home = open_sh3d(bow);
  REQUIRE(home.ok());
  const auto read = read_rooms(*home);
  REQUIRE(read.ok());
  CHECK(read->warnings.size() == 1);
  const auto flat = open_sh3d(with("<point x='400' y='300'/>", "<point x='200' y='0'/>"));
  const auto none = read_rooms(*flat);
  CHECK(none->scenes.empty());
  CHECK(none->warnings.size() == 1);
  CHECK(none->outside.size() == 1);
}
