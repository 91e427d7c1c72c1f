#include "fuzz/check_trajectories.h"
#include "io/formats/trajectories/hdf5.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace inhabit;
  const std::string_view bytes = fuzz::bytes_of(data, size);
  if (io::is_hdf5(bytes)) fuzz::check_trajectories(io::read_trajectories(bytes, "a.hdf5"));
  return 0;
}
