#include "fuzz/check_trajectories.h"
#include "io/file.h"
#include "io/formats/trajectories/splines.h"

/// The first byte says which flags are given, the rest is the file: every format of text and XML is known by its
/// content.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace inhabit;
  if (size == 0) return 0;
  io::TrajectoryOptions options;
  if ((data[0] & 1) != 0) options.unit = io::LengthUnit::centimetres;
  if ((data[0] & 2) != 0) options.frame_rate = 16;
  const std::string_view text = fuzz::bytes_of(data + 1, size - 1);
  if (io::is_gzip(text)) return 0;  // unpacking is slow and tried elsewhere
  constexpr io::Homography kGround = {0.02, 0.001, 5, 0, 0.025, 6, 0.0001, 0, 1};
  if (io::is_splines(text)) {
    core::Result<io::RawTrajectories> raw = io::read_splines(text, &kGround);
    if (raw) fuzz::check_trajectories(io::checked_trajectories(std::move(*raw), options));
  }
  fuzz::check_trajectories(io::read_trajectories(text, (data[0] & 4) != 0 ? "a.csv" : "a.txt", options));
  return 0;
}
