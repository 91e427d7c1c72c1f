#pragma once
#include <variant>

#include "io/formats/trajectories/csv.h"
#include "io/formats/trajectories/hdf5.h"
#include "io/formats/trajectories/petrack.h"
#include "io/formats/trajectories/sqlite.h"
#include "io/trajectory_table.h"

namespace inhabit::io {

/// One of the writers; all have create, add, flush and close.
class AnyTrajectoryWriter {
 public:
  std::variant<PetrackWriter, CsvWriter, Hdf5Writer, SqliteWriter> writer;
};

template <class Writer>
Result<std::unique_ptr<AnyTrajectoryWriter>> create_as(const std::filesystem::path& path,
                                                       const TrajectoryHeader& header) {
  Result<Writer> writer = Writer::create(path, header);
  if (!writer) return writer.error();
  return std::make_unique<AnyTrajectoryWriter>(AnyTrajectoryWriter{std::move(*writer)});
}

}  // namespace inhabit::io
