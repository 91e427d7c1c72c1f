#pragma once
#include <memory>
#include <string_view>

#include "io/formats/trajectories/output.h"
#include "io/formats/trajectories/raw.h"

namespace inhabit::io {

/// The dataset /trajectory of the Juelich archive and of JuPedSim, columns by name whatever their types and order,
/// metres. The frame rate is the attribute `fps` of the dataset or the file, or JuPedSim's `dt` and `every_nth_frame`;
/// the area is `wkt_geometry` or JuPedSim's /regions. Links and data that lead out of the file are not followed.
/// The library reads in a process of its own, because damaged files make it crash: then that is the error.
bool is_hdf5(std::string_view bytes);
Result<RawTrajectories> read_hdf5(std::string_view bytes);

/// {id i64, frame i64, x f64, y f64, z f64 = 0} as in the archive, with the attributes of the archive and of JuPedSim.
/// Chunks of 16384 rows, shuffled and deflated; flushed at whole frames. No times of the clock, so the same input gives
/// the same bytes.
class Hdf5Writer {
 public:
  static Result<Hdf5Writer> create(const std::filesystem::path& path, const TrajectoryHeader& header);
  Hdf5Writer(Hdf5Writer&&) noexcept;
  Hdf5Writer& operator=(Hdf5Writer&&) noexcept;
  ~Hdf5Writer();
  Status add(std::int32_t frame, std::span<const Spot> people);
  Status flush();
  Status close();

 private:
  struct State;
  explicit Hdf5Writer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace inhabit::io
