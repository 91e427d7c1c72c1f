#include "core/hash.h"
#include "core/text.h"
#include "geometry/polygon.h"
#include "io/formats/trajectories/areas.h"
#include "io/formats/trajectories/sqlite.h"
#include "io/formats/trajectories/sqlite_handle.h"

namespace inhabit::io {
namespace {

/// What JuPedSim's version 2 writes. Without spilling, the file changes at commits alone: it is whole without its
/// journal.
constexpr const char* kSetUp =
    "PRAGMA page_size = 4096; PRAGMA journal_mode = DELETE; PRAGMA synchronous = OFF; PRAGMA auto_vacuum = NONE;"
    "PRAGMA cache_spill = OFF;"
    "PRAGMA encoding = 'UTF-8';"
    "BEGIN;"
    "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL,"
    " pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL);"
    "CREATE UNIQUE INDEX geometry_hash ON geometry(hash);"
    "CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);"
    "CREATE INDEX frame_id_idx ON trajectory_data(frame, id);";

bool run(sqlite3* database, const char* sql) {
  return sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

bool set_metadata(sqlite3* database, const char* key, const std::string& value) {
  const Statement insert = prepare(database, "INSERT OR REPLACE INTO metadata VALUES(?1, ?2)");
  if (!insert) return false;
  sqlite3_bind_text(insert.get(), 1, key, -1, SQLITE_STATIC);
  sqlite3_bind_text(insert.get(), 2, value.data(), static_cast<int>(value.size()), SQLITE_STATIC);
  return sqlite3_step(insert.get()) == SQLITE_DONE;
}

bool set_bounds(sqlite3* database, const geometry::Bounds& bounds) {
  if (bounds.min.x > bounds.max.x) return true;
  return set_metadata(database, "xmin", shortest(bounds.min.x)) &&
         set_metadata(database, "xmax", shortest(bounds.max.x)) &&
         set_metadata(database, "ymin", shortest(bounds.min.y)) &&
         set_metadata(database, "ymax", shortest(bounds.max.y));
}

}  // namespace

struct SqliteWriter::State {
  std::filesystem::path path;
  Database database;
  Statement position, frame;
  std::int64_t area = 0;  ///< the hash that frame_data refers to; 0: no area is known
  geometry::Bounds seen;

  Error error() const {
    return {ErrorCode::io, std::string("SQLite: cannot be written: ") + sqlite3_errmsg(database.get()), path.string()};
  }
};

SqliteWriter::SqliteWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
SqliteWriter::SqliteWriter(SqliteWriter&&) noexcept = default;
SqliteWriter& SqliteWriter::operator=(SqliteWriter&&) noexcept = default;
SqliteWriter::~SqliteWriter() = default;

Result<SqliteWriter> SqliteWriter::create(const std::filesystem::path& path, const TrajectoryHeader& header) {
  auto state = std::make_unique<State>();
  state->path = path;
  sqlite3* opened = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int opening = sqlite3_open_v2(path.c_str(), &opened, flags, nullptr);
  state->database.reset(opened);
  if (opening != SQLITE_OK || !run(opened, kSetUp)) return state->error();
  bool good = set_metadata(opened, "version", "2") && set_metadata(opened, "fps", shortest(header.frame_rate));
  if (!header.title.empty()) good = good && set_metadata(opened, "title", one_line(header.title));
  if (!header.producer_notes.empty()) good = good && set_metadata(opened, "producer", one_line(header.producer_notes));
  if (!header.walkable.empty()) {
    const std::string wkt = walkable_text(header.walkable);
    Digest digest;
    digest.add(wkt);
    // JuPedSim's hash is Python's, which differs from run to run: any number will do, this one is the same always.
    state->area = static_cast<std::int64_t>(digest.value() >> 1);
    const Statement insert = prepare(opened, "INSERT INTO geometry VALUES(?1, ?2)");
    if (!insert) return state->error();
    sqlite3_bind_int64(insert.get(), 1, state->area);
    sqlite3_bind_text(insert.get(), 2, wkt.data(), static_cast<int>(wkt.size()), SQLITE_STATIC);
    good = good && sqlite3_step(insert.get()) == SQLITE_DONE;
    for (const scene::Area& area : header.walkable)
      for (const geometry::Vec2 p : area.outline) state->seen.add(p);
    good = good && set_bounds(opened, state->seen);
  }
  state->position = prepare(opened, "INSERT INTO trajectory_data VALUES(?1, ?2, ?3, ?4, 0.0, 0.0)");
  state->frame = prepare(opened, "INSERT INTO frame_data VALUES(?1, ?2)");
  if (!good || !state->position || !state->frame || !run(opened, "COMMIT; BEGIN")) return state->error();
  return SqliteWriter(std::move(state));
}

Status SqliteWriter::add(std::int32_t frame, std::span<const Spot> people) {
  State& s = *state_;
  const auto done = [](sqlite3_stmt* statement) {
    return sqlite3_step(statement) == SQLITE_DONE && sqlite3_reset(statement) == SQLITE_OK;
  };
  for (const Spot& spot : people) {
    sqlite3_bind_int64(s.position.get(), 1, frame);
    sqlite3_bind_int64(s.position.get(), 2, spot.person);
    sqlite3_bind_double(s.position.get(), 3, spot.x);
    sqlite3_bind_double(s.position.get(), 4, spot.y);
    if (!done(s.position.get())) return s.error();
    if (s.area == 0) s.seen.add({spot.x, spot.y});
  }
  if (s.area == 0) return Done{};
  sqlite3_bind_int64(s.frame.get(), 1, frame);
  sqlite3_bind_int64(s.frame.get(), 2, s.area);
  return done(s.frame.get()) ? Status(Done{}) : Status(s.error());
}

Status SqliteWriter::flush() {
  return run(state_->database.get(), "COMMIT; BEGIN") ? Status(Done{}) : Status(state_->error());
}

Status SqliteWriter::close() {
  State& s = *state_;
  if (s.area == 0 && !set_bounds(s.database.get(), s.seen)) return s.error();
  if (!run(s.database.get(), "COMMIT")) return s.error();
  s.position.reset(), s.frame.reset();
  if (sqlite3_close(s.database.get()) != SQLITE_OK) return s.error();
  // Closed already.
  static_cast<void>(s.database.release());
  return Done{};
}

}  // namespace inhabit::io
