#include "io/formats/trajectories/sqlite.h"

#include "io/formats/trajectories/sqlite_handle.h"
#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

namespace {

/// The bytes of a database made by these statements.
std::string made(const std::string& sql) {
  const TestFolder folder;
  sqlite3* opened = nullptr;
  REQUIRE(sqlite3_open((folder / "a.sqlite").c_str(), &opened) == SQLITE_OK);
  Database database(opened);
  char* problem = nullptr;
  sqlite3_exec(opened, sql.c_str(), nullptr, nullptr, &problem);
  REQUIRE_MESSAGE(problem == nullptr, std::string(problem == nullptr ? "" : problem));
  database.reset();
  return *read_file(folder / "a.sqlite");
}

const std::string kMetadata =
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "INSERT INTO metadata VALUES('version', 'VERSION'), ('fps', '25.0');";
const std::string kPositions =
    "CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y REAL NOT "
    "NULL);"
    "INSERT INTO trajectory_data VALUES(1, 7, 0.5, 2), (0, 7, 0.45, 2.0);";

}  // namespace

TEST_CASE("databases of JuPedSim are read in their three versions") {
  const std::string first =
      kMetadata + kPositions +
      "CREATE TABLE geometry(wkt TEXT NOT NULL); INSERT INTO geometry VALUES('POLYGON((0 0, 4 0, 0 4, 0 0))');";
  const std::string later = kMetadata + kPositions +
                            "CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL); CREATE UNIQUE INDEX "
                            "geometry_hash on geometry(hash);"
                            "INSERT INTO geometry VALUES(-5, 'POLYGON((0 0, 4 0, 0 4, 0 0))');"
                            "CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);";
  for (const std::string& sql : {first, later}) {
    const Trajectories t = read_text(made(sql));
    CHECK(t.frame_rate == 25);
    CHECK(t.fixes == std::vector<Fix>{{0, 7, 0.45, 2}, {1, 7, 0.5, 2}});
    REQUIRE(t.walkable.size() == 1);
    CHECK(t.walkable[0].size() == 8);
  }
  const Trajectories changing =
      read_text(made(later + "INSERT INTO geometry VALUES(6, 'POLYGON((4 0, 4 4, 0 4, 4 0))');"));
  REQUIRE(changing.walkable.size() == 1);
  CHECK(changing.walkable[0].size() == doctest::Approx(16));
  CHECK(has_remark(changing, "what 2 geometries cover together"));
}

TEST_CASE("a database has what JuPedSim and PedPy look for") {
  const TestFolder folder;
  REQUIRE(write_trajectories(example(), folder / "a.sqlite").ok());
  sqlite3* opened = nullptr;
  REQUIRE(sqlite3_open_v2((folder / "a.sqlite").c_str(), &opened, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK);
  const Database database(opened);
  const auto ask = [&](const char* sql) {
    const Statement query = prepare(opened, sql);
    REQUIRE(query);
    REQUIRE(sqlite3_step(query.get()) == SQLITE_ROW);
    return std::string(reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0)));
  };
  CHECK(ask("SELECT value FROM metadata WHERE key = 'version'") == "2");
  CHECK(ask("SELECT value FROM metadata WHERE key = 'fps'") == "16");
  CHECK(ask("SELECT value FROM metadata WHERE key = 'xmax'") == "9");
  CHECK(ask("SELECT count(*) FROM trajectory_data WHERE ori_x = 0 AND ori_y = 0") == "6");
  CHECK(ask("SELECT count(*) FROM frame_data JOIN geometry ON geometry_hash = hash") == "3");
  CHECK(ask("SELECT sql FROM sqlite_master WHERE name = 'frame_id_idx'") ==
        "CREATE INDEX frame_id_idx ON trajectory_data(frame, id)");
  CHECK(ask("PRAGMA integrity_check") == "ok");
  CHECK(ask("PRAGMA journal_mode") == "delete");
}

TEST_CASE("a database without what is needed is refused by name") {
  CHECK(refusal(made(kMetadata)) == "SQLite: there is no table trajectory_data");
  CHECK(refusal(made(kPositions)).starts_with("the file does not say its frame rate"));
  CHECK(refusal(made(kMetadata + "CREATE TABLE trajectory_data(frame, id, x);")) ==
        "SQLite: trajectory_data has not the columns frame, id, pos_x and pos_y");
  const std::string loose = kMetadata + "CREATE TABLE trajectory_data(frame, id, pos_x, pos_y);";
  CHECK(refusal(made(loose + "INSERT INTO trajectory_data VALUES(1, 1, 0, 0), ('a', 1, 0, 0)")) ==
        "row 2 of trajectory_data: frame and id must be whole numbers");
  CHECK(refusal(made(loose + "INSERT INTO trajectory_data VALUES(1, 1, 0, NULL)")) ==
        "row 1 of trajectory_data: pos_x and pos_y must be numbers");
  CHECK(refusal(made(loose + "INSERT INTO trajectory_data VALUES(1, 1, 0, 9e999)")) ==
        "row 1 of trajectory_data: a position must be a finite number");
  CHECK(refusal(made(loose)) == "there is no position in it");
}

TEST_CASE("nothing that a database holds is run") {
  CHECK(refusal(made(kMetadata +
                     "CREATE VIEW trajectory_data AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n) "
                     "SELECT i AS frame, 1 AS id, 0.0 AS pos_x, 0.0 AS pos_y FROM n;")) ==
        "SQLite: there is no table trajectory_data");
}

TEST_CASE("a database that is cut off or damaged is one clear error") {
  std::string rows = kMetadata + kPositions + "BEGIN;";
  for (int frame = 2; frame < 2000; ++frame) {
    rows += "INSERT INTO trajectory_data VALUES(" + std::to_string(frame) + ", 7, 0." + std::to_string(1000 + frame) +
            ", 2);";
  }
  const std::string bytes = made(rows + "COMMIT;");
  CHECK(read_text(bytes).fixes.size() == 2000);
  std::size_t read = 0;
  for (std::size_t size = 16; size < bytes.size(); size += 1 + size / 20) {
    const auto result = read_trajectories(std::string_view(bytes).substr(0, size), "a.sqlite");
    read += result.ok();
    if (!result.ok()) CHECK(result.error().text().starts_with("SQLite: "));
  }
  CHECK(read == 0);
  CHECK(refusal("nonsense", {}, "a.sqlite").starts_with("SQLite: "));
}

TEST_CASE("a database with a write-ahead log is read as far as it was merged") {
  std::string bytes = made(kMetadata + kPositions);
  bytes[18] = bytes[19] = 2;
  const std::string before = bytes;
  CHECK(has_remark(read_text(bytes), "write-ahead log"));
  CHECK((bytes == before));
}
