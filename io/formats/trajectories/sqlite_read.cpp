#include <cmath>

#include "io/formats/trajectories/areas.h"
#include "io/formats/trajectories/delimited.h"
#include "io/formats/trajectories/sqlite.h"
#include "io/formats/trajectories/sqlite_handle.h"

namespace inhabit::io {
namespace {

constexpr std::string_view kMagic("SQLite format 3\0", 16);
constexpr int kLongestValue = 16 << 20;
/// Instructions of the database's machine between two looks at how many there were.
constexpr int kLook = 10000;

Error broken(std::string what) { return invalid("", "SQLite: " + std::move(what)); }

/// Ends a query that does more than reading every byte once could need.
struct Budget {
  double left = 0;
  static int look(void* budget) { return (static_cast<Budget*>(budget)->left -= kLook) < 0; }
};

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// The header says how many pages there are, unless an old version wrote last (sqlite.org/fileformat2.html, 1.3.7).
bool cut_off(std::string_view bytes) {
  if (bytes.size() < 100) return true;
  const std::uint32_t low = static_cast<unsigned char>(bytes[17]), high = static_cast<unsigned char>(bytes[16]);
  const std::uint64_t page = high == 0 && low == 1 ? 65536 : high << 8 | low;
  return big_endian(bytes, 24) == big_endian(bytes, 92) && bytes.size() < page * big_endian(bytes, 28);
}

Database open_bytes(std::string_view bytes, Budget& budget) {
  sqlite3* opened = nullptr;
  const int state = sqlite3_open_v2(":memory:", &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database(opened);
  if (state != SQLITE_OK) return {};
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, kLongestValue);
  sqlite3_limit(opened, SQLITE_LIMIT_SQL_LENGTH, 1 << 16);
  sqlite3_progress_handler(opened, kLook, Budget::look, &budget);
  // Read only, so that the bytes stay as they are.
  auto* data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(opened, "main", data, size, size, SQLITE_DESERIALIZE_READONLY) != SQLITE_OK) return {};
  return database;
}

/// Whether there is an ordinary table of this name: a view or a virtual one would run what the file says.
bool has_table(sqlite3* database, const char* name) {
  const Statement query = prepare(
      database,
      "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = ?1 AND sql NOT LIKE 'CREATE VIRTUAL%'");
  if (!query) return false;
  sqlite3_bind_text(query.get(), 1, name, -1, SQLITE_STATIC);
  return sqlite3_step(query.get()) == SQLITE_ROW && sqlite3_column_int(query.get(), 0) == 1;
}

std::string_view text_of(sqlite3_stmt* row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
  return text == nullptr ? std::string_view{}
                         : std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(row, column)));
}
bool is_number(sqlite3_stmt* row, int column) {
  const int kind = sqlite3_column_type(row, column);
  return kind == SQLITE_INTEGER || kind == SQLITE_FLOAT;
}
std::optional<std::int64_t> whole_in(sqlite3_stmt* row, int column) {
  if (sqlite3_column_type(row, column) == SQLITE_INTEGER) return sqlite3_column_int64(row, column);
  if (sqlite3_column_type(row, column) != SQLITE_FLOAT) return std::nullopt;
  const double value = sqlite3_column_double(row, column);
  if (!(std::abs(value) <= 9e15) || value != std::floor(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

Status read_positions(sqlite3* database, RawTrajectories& raw) {
  const Statement query = prepare(database, "SELECT frame, id, pos_x, pos_y FROM trajectory_data");
  if (!query) return broken("trajectory_data has not the columns frame, id, pos_x and pos_y");
  RawRows rows(raw);
  for (;;) {
    const int state = sqlite3_step(query.get());
    if (state == SQLITE_DONE) return Done{};
    if (state != SQLITE_ROW) return broken(std::string("trajectory_data cannot be read: ") + sqlite3_errmsg(database));
    const std::string where = "row " + std::to_string(raw.fixes.size() + 1) + " of trajectory_data";
    const std::optional<std::int64_t> frame = whole_in(query.get(), 0), person = whole_in(query.get(), 1);
    if (!frame || !person) return invalid(where, "frame and id must be whole numbers");
    if (!is_number(query.get(), 2) || !is_number(query.get(), 3))
      return invalid(where, "pos_x and pos_y must be numbers");
    if (!rows.add(*person, *frame, sqlite3_column_double(query.get(), 2), sqlite3_column_double(query.get(), 3)))
      return invalid(where, rows.problem);
  }
}

Status read_metadata(sqlite3* database, RawTrajectories& raw) {
  if (!has_table(database, "metadata")) return Done{};
  const Statement query = prepare(database, "SELECT key, value FROM metadata LIMIT 1000");
  if (!query) return broken("metadata has not the columns key and value");
  for (;;) {
    const int state = sqlite3_step(query.get());
    if (state == SQLITE_DONE) return Done{};
    if (state != SQLITE_ROW) return broken(std::string("metadata cannot be read: ") + sqlite3_errmsg(database));
    const std::string_view key = text_of(query.get(), 0), value = text_of(query.get(), 1);
    if (key == "fps") raw.frame_rate = number_of(value);
    if (key == "title") raw.title = value;
  }
}

/// An area that cannot be read leaves the positions as good as they are.
void read_geometry(sqlite3* database, RawTrajectories& raw) {
  if (!has_table(database, "geometry")) return;
  const Statement query = prepare(database, "SELECT wkt FROM geometry");
  std::size_t count = 0;
  while (query && count < 1000 && sqlite3_step(query.get()) == SQLITE_ROW) {
    take_walkable(text_of(query.get(), 0), raw);
    ++count;
  }
  if (count < 2) return;
  raw.walkable = geometry::difference(raw.walkable, {}, 0);
  raw.remarks.push_back("the walkable area is what " + std::to_string(count) + " geometries cover together");
}

}  // namespace

bool is_sqlite(std::string_view bytes) { return bytes.starts_with(kMagic); }

Result<RawTrajectories> read_sqlite(std::string_view bytes) {
  if (cut_off(bytes)) return broken("the file is cut off");
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  // A database with a write-ahead log says so in bytes 18 and 19 and is not opened in memory; without its log it is one
  // that has none.
  std::string without_log;
  if (bytes[18] == 2 || bytes[19] == 2) {
    without_log = bytes;
    without_log[18] = without_log[19] = 1;
    bytes = without_log;
    raw.remarks.push_back("the database has a write-ahead log; what is only there is not read");
  }
  Budget budget{1e7 + 20.0 * static_cast<double>(bytes.size())};
  const Database database = open_bytes(bytes, budget);
  if (!database) return broken("the file is damaged or cut off");
  if (!has_table(database.get(), "trajectory_data")) {
    const int state = sqlite3_errcode(database.get());
    const bool damaged = state != SQLITE_OK && state != SQLITE_ROW && state != SQLITE_DONE;
    return broken(damaged ? "the file is damaged or cut off" : "there is no table trajectory_data");
  }
  if (const Status read = read_metadata(database.get(), raw); !read) return read.error();
  if (const Status read = read_positions(database.get(), raw); !read) return read.error();
  read_geometry(database.get(), raw);
  return raw;
}

}  // namespace inhabit::io
