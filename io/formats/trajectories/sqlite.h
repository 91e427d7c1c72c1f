#pragma once
#include <memory>
#include <string_view>

#include "io/formats/trajectories/output.h"
#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// JuPedSim's database, versions 1 to 3: trajectory_data(frame, id, pos_x, pos_y, …), metadata(key, value) with fps,
/// geometry(wkt). Metres. It is opened in memory, read only; nothing that the file holds is run.
bool is_sqlite(std::string_view bytes);
Result<RawTrajectories> read_sqlite(std::string_view bytes);

/// The same in version 2, which JuPedSim and PedPy both read; orientations are 0. Committed at whole frames.
class SqliteWriter {
 public:
  static Result<SqliteWriter> create(const std::filesystem::path& path, const TrajectoryHeader& header);
  SqliteWriter(SqliteWriter&&) noexcept;
  SqliteWriter& operator=(SqliteWriter&&) noexcept;
  ~SqliteWriter();
  Status add(std::int32_t frame, std::span<const Spot> people);
  Status flush();
  Status close();

 private:
  struct State;
  explicit SqliteWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace inhabit::io
