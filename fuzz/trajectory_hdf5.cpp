#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include "fuzz/check_trajectories.h"
#include "io/formats/trajectories/hdf5.h"

/// The library itself does crash on damaged files (1.10.8: H5HG_read, among others), in the process of its own that
/// io/formats/trajectories/apart.h gives it: what is tried here is that this process lives on and what it makes of the
/// messages it gets.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace inhabit;
  // A copy that crashes writes no report of its own.
  [[maybe_unused]] static const int quiet =
      pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback(nullptr); });
  const std::string_view bytes = fuzz::bytes_of(data, size);
  if (io::is_hdf5(bytes)) fuzz::check_trajectories(io::read_trajectories(bytes, "a.hdf5"));
  return 0;
}
